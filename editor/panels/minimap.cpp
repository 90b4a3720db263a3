#include "editor/panels/minimap.h"

#include "editor/canvas/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <cmath>

namespace spacetow {

namespace {

constexpr double zoomStep = 1.25; // a key, or a notch of the wheel
constexpr double keyShare = 0.25; // of the view that an arrow key goes
constexpr double smallest = 6;    // pixels, of the frame around a part that is smaller

} // namespace

Minimap::Minimap(Document& document, Canvas& canvas, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(canvas) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Minimap"));
    setStatusTip(tr("Click or drag: go there · wheel: zoom · arrows: move the view"));
    m_listener = m_document.changed.connect([this](const Change&) { paintBeside(); });
    connect(&m_canvas, &Canvas::viewChanged, this, [this] { update(); });
}

Minimap::~Minimap() {
    m_document.changed.disconnect(m_listener);
}

Minimap::Painted Minimap::wanted() const {
    return {m_document.current().level, {size(), devicePixelRatioF()}, shadeOf(palette())};
}

void Minimap::paintBeside() {
    const Painted next = wanted();
    if (!isVisible() || m_task.isRunning() || next == m_painted || size().isEmpty()) {
        return;
    }
    m_task.start([this, next](const std::stop_token&) -> BackgroundTask::Then {
        const QImage image = levelPicture(*next.level, next.size, next.shade);
        const Viewport view = pictureView(*next.level, next.size.logical);
        return [this, next, image, view] {
            m_picture = QPixmap::fromImage(image);
            m_painted = next;
            m_view = view;
            update();
            paintBeside(); // what has changed meanwhile
        };
    });
}

void Minimap::finish() {
    paintBeside();
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

QPointF Minimap::at(const Vec2& world) const {
    const Vec2 screen = m_view.toScreen(world);
    // Far from the level there is room for a number only, not for a picture.
    constexpr double far = 1e6;
    return {std::clamp(screen.x(), -far, far), std::clamp(screen.y(), -far, far)};
}

QRectF Minimap::shownPart() const {
    const Aabb visible = m_canvas.view().visible();
    QRectF part(at({visible.min.x(), visible.max.y()}), at({visible.max.x(), visible.min.y()}));
    const double across = std::max(0.0, smallest - part.width()) / 2;
    const double upright = std::max(0.0, smallest - part.height()) / 2;
    return part.adjusted(-across, -upright, across, upright);
}

void Minimap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = editingTheme(shadeOf(palette()));
    painter.fillRect(rect(), theme.background);
    if (m_picture.isNull()) {
        return;
    }
    painter.drawPixmap(QRectF(QPointF(0, 0), QSizeF(m_painted.size.logical)), m_picture, QRectF(m_picture.rect()));
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF part = shownPart();
    QPainterPath hidden;
    hidden.addRect(QRectF(rect()).adjusted(-2, -2, 2, 2));
    QPainterPath seen;
    seen.addRect(part);
    QColor veil = palette().color(QPalette::Window);
    veil.setAlpha(110);
    painter.fillPath(hidden.subtracted(seen), veil);
    painter.setPen(QPen(theme.halo, 4));
    painter.drawRect(part);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(part);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void Minimap::goTo(const QPointF& position) {
    if (m_picture.isNull()) {
        return;
    }
    Viewport view = m_canvas.view();
    view.center = m_view.toWorld(Vec2(position.x(), position.y()));
    m_canvas.setView(view);
}

void Minimap::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        goTo(event->position());
    }
}

void Minimap::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) {
        goTo(event->position());
    }
}

void Minimap::wheelEvent(QWheelEvent* event) {
    m_canvas.zoom(std::pow(zoomStep, event->angleDelta().y() / 120.0));
    event->accept();
}

void Minimap::keyPressEvent(QKeyEvent* event) {
    Viewport view = m_canvas.view();
    const Vec2 step = keyShare / view.scale * view.size;
    switch (event->key()) {
    case Qt::Key_Left:
        view.center.x() -= step.x();
        break;
    case Qt::Key_Right:
        view.center.x() += step.x();
        break;
    case Qt::Key_Up:
        view.center.y() += step.y();
        break;
    case Qt::Key_Down:
        view.center.y() -= step.y();
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    m_canvas.setView(view);
}

void Minimap::resizeEvent(QResizeEvent*) {
    paintBeside();
}

void Minimap::showEvent(QShowEvent*) {
    paintBeside();
}

void Minimap::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        paintBeside();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
