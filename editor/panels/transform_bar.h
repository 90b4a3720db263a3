#pragma once
// A bar above the canvas with the place and size of what is selected, to be typed: the lower left corner of its bounds,
// width and height, those of a single body along its own sides, and by how much to turn it. Relative, it moves by
// metres and scales by percent. Each number entered is one history entry; labels can be dragged.

#include "editor/editing/toolbox.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/panels/wrapping_row.h"

#include <QCheckBox>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <array>

namespace spacetow {

class TransformBar : public QWidget {
    Q_OBJECT

  public:
    /// Both must outlive the bar.
    TransformBar(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~TransformBar() override;

    /// Makes a sentence of a code of core/base/expression.
    void setWords(const std::function<QString(const Error&)>& words);

    void begin();
    void shut();

  Q_SIGNALS:
    void closed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum Field { X, Y, Width, Height, Angle, fields };

    void layOut();
    void dressFields();
    void refresh();
    /// What is wrong with the entry; empty when nothing is.
    QString enter(Field field, const NumberEntry& entry);
    std::optional<FinishedEdit> edited(Field field, double value);
    void showFaults();

    Document& m_document;
    Toolbox& m_toolbox;
    int m_connection = 0;
    QVBoxLayout m_column;
    WrappingRow m_row;
    QLabel m_title;
    std::array<NumberField, fields> m_fields;
    std::array<ScrubLabel, fields> m_labels;
    QCheckBox m_relative;
    QToolButton m_close;
    FaultLabel m_fault;
};

} // namespace spacetow
