#include "editor/canvas/guide_source.h"

#include "editor/canvas/ruler.h"

#include <QMouseEvent>
#include <QPainter>

#include <numbers>

namespace spacetow {

void GuideSource::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        Q_EMIT pressed(event->globalPosition(), event->modifiers());
    }
}

void GuideSource::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) {
        Q_EMIT dragged(event->globalPosition(), event->modifiers());
    }
}

void GuideSource::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        Q_EMIT released(event->globalPosition(), event->modifiers());
    }
}

RulerCorner::RulerCorner(QWidget* parent) : GuideSource(std::numbers::pi / 4, parent) {
    setCursor(Qt::SizeBDiagCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Corner of the rulers"));
    const QString tip = tr("Metres; drag a slanting guide out of the corner");
    setToolTip(tip);
    setStatusTip(tip);
}

QSize RulerCorner::sizeHint() const {
    const int side = Ruler::thickness(*this);
    return {side, side};
}

void RulerCorner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.setFont(Ruler::numberFont(*this));
    painter.drawText(rect().adjusted(0, 0, -1, -1), Qt::AlignCenter, QStringLiteral("m"));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(rect().bottomLeft(), rect().bottomRight());
    painter.drawLine(rect().topRight(), rect().bottomRight());
}

} // namespace spacetow
