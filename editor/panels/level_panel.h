#pragma once
// The fields of the level itself: its name, gravity, rules and limits. The inspector shows one of these when nothing is
// selected; another can stay in sight whatever is.

#include "editor/editing/document.h"
#include "editor/panels/form_page.h"

#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class LevelPanel : public QWidget {
    Q_OBJECT

  public:
    using Words = std::function<QString(const Error&)>;

    /// The document must outlive the panel; `words` makes a sentence of a code.
    LevelPanel(Document& document, Words words, QWidget* parent = nullptr);
    ~LevelPanel() override;

    void refresh();
    Form& form() { return m_page.form(); }
    const Form& form() const { return m_page.form(); }
    QScrollArea& page() { return m_page; }

    /// Never so narrow that a field would be cut off.
    QSize minimumSizeHint() const override { return {m_page.narrowWidth(), 90}; }
    QSize sizeHint() const override { return {m_page.fullWidth(), 260}; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    FormTarget target(Words words);
    QString make(const FormEdit& edit);

    Document& m_document;
    QVBoxLayout m_column;
    FormPage m_page;
    int m_listener = 0;
};

} // namespace spacetow
