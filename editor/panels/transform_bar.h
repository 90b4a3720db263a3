#pragma once
// A bar above the canvas with the place and size of what is selected, to be typed: the lower left corner of its bounds,
// width and height, and by how much to turn it. Relative, it moves by metres and scales by percent. Each number entered
// is one history entry.

#include "editor/editing/toolbox.h"
#include "editor/panels/number_field.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include <array>

namespace spacetow {

class TransformBar : public QWidget {
    Q_OBJECT

  public:
    /// Both must outlive the bar.
    TransformBar(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~TransformBar() override;

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
    void enter(Field field, double value);

    Document& m_document;
    Toolbox& m_toolbox;
    int m_connection = 0;
    QHBoxLayout m_row;
    QLabel m_title;
    std::array<QLabel, fields> m_labels;
    std::array<NumberField, fields> m_fields;
    QCheckBox m_relative;
    QToolButton m_close;
};

} // namespace spacetow
