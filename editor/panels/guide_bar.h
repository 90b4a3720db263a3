#pragma once
// The bar in which a guide's place, angle and name are typed. Each entry is one step of the history; Escape and the
// cross close the bar. Lengths are metres, the angle is shown in degrees.

#include "editor/editing/document.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <cstddef>
#include <functional>
#include <optional>

namespace spacetow {

class GuideBar : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the bar.
    explicit GuideBar(Document& document, QWidget* parent = nullptr);
    ~GuideBar() override;

    /// Makes a sentence of a code of core/base/expression.
    void setWords(const std::function<QString(const Error&)>& words);

    /// Shows the guide of this index, ready to type the coordinate that matters.
    void open(std::size_t index);
    void dismiss();
    std::optional<std::size_t> guide() const { return m_index; }

    NumberField& x() { return m_x; }
    NumberField& y() { return m_y; }
    NumberField& angle() { return m_angle; }
    QLineEdit& name() { return m_name; }
    QToolButton& deleteButton() { return m_delete; }

  Q_SIGNALS:
    void dismissed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void layOut();
    void refresh();
    void tint();
    void change(const std::function<void(Guide&)>& how, NumberEntry::Phase phase);
    void enterInto(NumberField& field, const std::function<void(Guide&, double)>& set);

    Document& m_document;
    std::optional<std::size_t> m_index;
    QVBoxLayout m_column;
    QHBoxLayout m_row;
    NumberField m_x, m_y, m_angle;
    ScrubLabel m_xLabel, m_yLabel, m_angleLabel;
    QLineEdit m_name;
    QToolButton m_delete, m_close;
    FaultLabel m_fault;
    int m_listener = 0;
};

} // namespace spacetow
