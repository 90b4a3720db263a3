#pragma once
// A form that scrolls: to a fault that comes up, and back to where the user had scrolled when its rows come and go.

#include "editor/panels/form.h"

#include <QScrollArea>

namespace spacetow {

class FormPage : public QScrollArea {
    Q_OBJECT

  public:
    FormPage(std::span<const FormRow> rows, FormTarget target, QWidget* parent = nullptr);
    ~FormPage() override;

    Form& form() { return m_form; }
    const Form& form() const { return m_form; }
    /// The width at which no field would be cut off.
    int fullWidth() const;
    /// The same with labels above the fields, as they are where there is no room for them beside.
    int narrowWidth() const;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void keepScrolled();
    void reveal(QWidget* sentence);

    Form m_form;
    int m_wanted = 0; // where the user has scrolled to
};

} // namespace spacetow
