#pragma once
// What guides are dragged out of: the rulers, and the corner between them. It only tells of the drag; the canvas has
// the gesture.

#include <QWidget>

namespace spacetow {

class GuideSource : public QWidget {
    Q_OBJECT

  public:
    GuideSource(double angle, QWidget* parent) : QWidget(parent), m_angle(angle) {}
    /// Of the guides that come out of it, in radians.
    double angle() const { return m_angle; }

  Q_SIGNALS:
    void pressed(const QPointF& global, Qt::KeyboardModifiers modifiers);
    void dragged(const QPointF& global, Qt::KeyboardModifiers modifiers);
    void released(const QPointF& global, Qt::KeyboardModifiers modifiers);

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    double m_angle;
};

/// Between the rulers: says the unit; its guides rise by 45°.
class RulerCorner : public GuideSource {
    Q_OBJECT

  public:
    explicit RulerCorner(QWidget* parent = nullptr);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace spacetow
