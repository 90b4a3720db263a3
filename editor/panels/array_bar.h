#pragma once
// A bar above the canvas that makes arrays of what is selected: it shows them as they would be while the numbers are
// being changed. It stays while something else is selected or done to the level, and then goes on from there.

#include "editor/editing/array_verb.h"
#include "editor/editing/toolbox.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/panels/wrapping_row.h"

#include <QCheckBox>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <array>
#include <optional>

namespace spacetow {

class ArrayBar : public QWidget {
    Q_OBJECT

  public:
    enum class Kind { Linear, Radial };

    /// Both must outlive the bar.
    ArrayBar(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~ArrayBar() override;

    /// Opens for what is selected; without a selection it stays closed.
    void begin(Kind kind);
    /// One history entry; the bar stays open and says why when the array cannot be made.
    void apply();
    void cancel();

    /// Makes a sentence of a code of core/base/expression.
    void setWords(const std::function<QString(const Error&)>& words);

  Q_SIGNALS:
    void closed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void layOut();
    void add(ScrubLabel& label, const QString& text, NumberField& field);
    /// Once the document has done telling what has happened.
    void followSoon();
    void follow();
    bool isBehind() const;
    void takeSelection();
    std::array<NumberField*, 4> numbers() { return {&m_copies, &m_angle, &m_x, &m_y}; }
    void setNumbers();
    void shut();
    ArraySpec spec() const;
    void preview();
    void showFaults();

    Document& m_document;
    Toolbox& m_toolbox;
    int m_documentListener = 0;
    int m_toolboxListener = 0;
    QTimer m_soon;
    bool m_isShown = false;  // the array, in the document's preview
    bool m_hasPlace = false; // step or center have been typed, and go with no other selection
    Kind m_kind = Kind::Linear;
    std::optional<ToolContext> m_context; // while open
    LinearArray m_linear;
    RadialArray m_radial;

    QVBoxLayout m_column;
    WrappingRow m_row;
    QLabel m_title;
    NumberField m_copies, m_x, m_y, m_angle;
    ScrubLabel m_copiesLabel, m_xLabel, m_yLabel, m_angleLabel;
    QString m_objection; // to the array as a whole
    QCheckBox m_turns;
    QToolButton m_apply, m_cancel;
    FaultLabel m_refusal;
};

} // namespace spacetow
