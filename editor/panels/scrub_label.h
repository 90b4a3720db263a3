#pragma once
// The label of a number field. A drag to the right makes the number larger, to the left smaller: Shift a tenth as fast,
// Ctrl in whole steps; Escape takes it back.

#include <QLabel>

namespace spacetow {

class NumberField;

class ScrubLabel : public QLabel {
    Q_OBJECT

  public:
    /// The field must outlive the label.
    ScrubLabel(const QString& text, NumberField& field, QWidget* parent = nullptr);

  protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    NumberField& m_field;
    int m_pressedAt = 0;
    bool m_pressed = false;
    bool m_began = false; // since the press; Escape may have ended it
};

} // namespace spacetow
