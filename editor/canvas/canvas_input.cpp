// Mouse, touchpad and keys of the canvas.
#include "editor/canvas/canvas.h"
#include "editor/canvas/key_place.h"
#include "editor/editing/guide_gestures.h"
#include "editor/editing/verbs.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>

#include <cmath>

namespace spacetow {

namespace {

constexpr double wheelZoom = 1.25; // a notch of the wheel
constexpr double notch = 120;      // eighths of a degree, as the toolkit counts
constexpr double menuDistance = 4; // px that a click may move and still be a click
constexpr double arrowPan = 60;    // px
constexpr double fineSteps = 5;    // arrow keys move by this fraction of a grid step
constexpr int belowKey = Qt::Key_B;

Qt::CursorShape shapeFor(CursorShape shape) {
    switch (shape) {
    case CursorShape::Arrow:
        return Qt::ArrowCursor;
    case CursorShape::Cross:
        return Qt::CrossCursor;
    case CursorShape::Move:
        return Qt::SizeAllCursor;
    case CursorShape::OpenHand:
        return Qt::OpenHandCursor;
    case CursorShape::Insert:
        return Qt::DragCopyCursor;
    case CursorShape::SizeAcross:
        return Qt::SizeHorCursor;
    case CursorShape::SizeUpright:
        return Qt::SizeVerCursor;
    case CursorShape::SizeRising:
        return Qt::SizeBDiagCursor;
    case CursorShape::SizeFalling:
        return Qt::SizeFDiagCursor;
    case CursorShape::Pointing:
        break;
    }
    return Qt::PointingHandCursor;
}

/// Keys that change what the mouse does while they are held.
bool isModifier(const QKeyEvent& event) {
    return event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control || event.key() == Qt::Key_Alt ||
           latinKey(event) == belowKey;
}

/// What is held once the key is down or up. Systems differ in whether an event of Shift counts it already, and some
/// tell the application only with the event that follows.
Qt::KeyboardModifiers heldAfter(const QKeyEvent& event) {
    Qt::KeyboardModifiers held = event.modifiers();
    for (const auto& [key, modifier] :
         {std::pair{Qt::Key_Shift, Qt::ShiftModifier}, std::pair{Qt::Key_Control, Qt::ControlModifier},
          std::pair{Qt::Key_Alt, Qt::AltModifier}}) {
        if (event.key() == key) {
            held.setFlag(modifier, event.type() == QEvent::KeyPress);
        }
    }
    return held;
}

bool isTouchpad(const QWheelEvent& event) {
    return event.device() != nullptr && event.device()->type() == QInputDevice::DeviceType::TouchPad;
}

std::optional<Vec2> arrowDirection(int key) {
    switch (key) {
    case Qt::Key_Left:
        return Vec2(-1, 0);
    case Qt::Key_Right:
        return Vec2(1, 0);
    case Qt::Key_Up:
        return Vec2(0, 1);
    case Qt::Key_Down:
        return Vec2(0, -1);
    default:
        return {};
    }
}

} // namespace

void Canvas::mousePressEvent(QMouseEvent* event) {
    if (m_drag != Drag::None) {
        return;
    }
    m_pressedAt = event->position();
    m_position = event->position();
    m_dragButton = event->button();
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && m_spaceHeld)) {
        m_drag = Drag::Pan;
    } else if (event->button() == Qt::RightButton) {
        m_drag = Drag::PanOrMenu;
    } else if (event->button() == Qt::LeftButton) {
        m_drag = Drag::Tool;
        m_edgeScroll.follow(rect(), event->position());
        m_toolbox.press(pointerAt(event->position(), event->modifiers()));
    }
    updateCursor();
}

void Canvas::loseMouse() {
    m_drag = Drag::None;
    m_spaceHeld = m_belowHeld = false;
    m_edgeScroll.end();
    m_toolbox.loseMouse();
    updateCursor();
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_drag != Drag::None && !event->buttons().testFlag(m_dragButton)) {
        loseMouse(); // the release went to somebody else
    }
    const QPointF moved = event->position() - m_position.value_or(event->position());
    if (m_drag == Drag::PanOrMenu && (event->position() - m_pressedAt).manhattanLength() > menuDistance) {
        m_drag = Drag::Pan;
        updateCursor();
    }
    if (m_drag == Drag::Pan || (m_drag == Drag::Tool && m_spaceHeld)) {
        panBy(moved); // what is dragged stays under the pointer
    }
    moveTo(event->position(), event->modifiers());
}

void Canvas::mouseReleaseEvent(QMouseEvent* event) {
    const Pointer pointer = pointerAt(event->position(), event->modifiers());
    if (m_drag == Drag::None || event->button() != m_dragButton) {
        return;
    }
    const Drag drag = std::exchange(m_drag, Drag::None);
    m_edgeScroll.end();
    if (drag == Drag::Tool) {
        m_toolbox.release(pointer);
    } else if (drag == Drag::PanOrMenu && isLive()) {
        if (!m_live->isGame() && !(m_live->showsTool() && m_toolbox.secondaryClick(pointer))) {
            Q_EMIT menuWanted(event->globalPosition().toPoint());
        }
    } else if (drag == Drag::PanOrMenu && !m_toolbox.secondaryClick(pointer)) {
        Q_EMIT menuWanted(event->globalPosition().toPoint());
    }
    updateCursor();
}

void Canvas::mouseDoubleClickEvent(QMouseEvent* event) {
    const std::optional<std::size_t> guide = m_toolbox.guideInReach();
    if (event->button() == Qt::LeftButton && !m_spaceHeld && guide) {
        m_drag = Drag::Tool; // the release is still to come
        m_dragButton = Qt::LeftButton;
        Q_EMIT guideOpened(*guide);
    } else if (event->button() == Qt::LeftButton && !m_spaceHeld) {
        m_drag = Drag::Tool;
        m_dragButton = Qt::LeftButton;
        m_toolbox.doubleClick(pointerAt(event->position(), event->modifiers()));
    } else {
        mousePressEvent(event);
    }
}

void Canvas::beginGuide(double angle, const QPointF& global, Qt::KeyboardModifiers modifiers) {
    if (m_drag == Drag::None) {
        m_drag = Drag::Guide;
        m_dragButton = Qt::LeftButton;
        m_position = mapFromGlobal(global);
        m_toolbox.begin(std::make_unique<NewGuideGesture>(m_toolbox.context(), angle),
                        pointerAt(*m_position, modifiers));
    }
}

void Canvas::dragGuide(const QPointF& global, Qt::KeyboardModifiers modifiers) {
    if (m_drag == Drag::Guide) {
        moveTo(mapFromGlobal(global), modifiers);
    }
}

void Canvas::endGuide(const QPointF& global, Qt::KeyboardModifiers modifiers) {
    if (m_drag == Drag::Guide) {
        m_drag = Drag::None;
        m_toolbox.release(pointerAt(mapFromGlobal(global), modifiers));
        updateCursor();
    }
}

void Canvas::wheelEvent(QWheelEvent* event) {
    const QPoint angle = event->angleDelta();
    const bool zooms = event->modifiers().testFlag(Qt::ControlModifier) || !isTouchpad(*event);
    if (!zooms) {
        const QPoint pixels = event->pixelDelta();
        panBy(pixels.isNull() ? QPointF(angle) / 2 : QPointF(pixels));
    } else if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        panBy(QPointF(angle.y() + angle.x(), 0) / 2);
    } else {
        const double turned = angle.y() != 0 ? angle.y() : angle.x();
        zoomAt(Vec2(event->position().x(), event->position().y()), std::pow(wheelZoom, turned / notch));
    }
    moveTo(event->position(), event->modifiers());
    event->accept();
}

bool Canvas::event(QEvent* event) {
    if (isLive() && m_live->take(*event)) {
        return true;
    }
    if (event->type() == QEvent::NativeGesture) {
        return nativeGesture(*static_cast<QNativeGestureEvent*>(event));
    }
    if (event->type() == QEvent::ShortcutOverride && opensEntry(*static_cast<QKeyEvent*>(event))) {
        event->accept(); // digits that are shortcuts otherwise
        return true;
    }
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::UngrabMouse ||
        event->type() == QEvent::Hide) {
        loseMouse();
    }
    return QWidget::event(event);
}

bool Canvas::nativeGesture(const QNativeGestureEvent& event) {
    const Vec2 at(event.position().x(), event.position().y());
    if (event.gestureType() == Qt::ZoomNativeGesture) {
        zoomAt(at, std::max(0.2, 1 + event.value()));
    } else if (event.gestureType() == Qt::PanNativeGesture) {
        panBy(event.delta());
    } else {
        return false;
    }
    return true;
}

void Canvas::toolKey(ToolKey key) {
    if (m_drag == Drag::Pan || m_drag == Drag::PanOrMenu) {
        return;
    }
    m_toolbox.key(key, pointerAt(m_position.value_or(QPointF(rect().center())), QApplication::keyboardModifiers()));
}

/// Whether the key begins a number while there is one to type.
bool Canvas::opensEntry(const QKeyEvent& event) const {
    constexpr Qt::KeyboardModifiers others = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    const QString text = event.text();
    const bool begins = text.size() == 1 && (text.front().isDigit() || text == u"." || text == u",");
    return begins && (event.modifiers() & others) == 0 && !isDragging() && m_toolbox.measures();
}

bool Canvas::pressToolKey(int key) {
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        toolKey(ToolKey::Enter);
        return true;
    case Qt::Key_Escape:
        toolKey(ToolKey::Escape);
        return true;
    case Qt::Key_Backspace:
        toolKey(m_toolbox.isBusy() ? ToolKey::Backspace : ToolKey::Delete);
        return true;
    case Qt::Key_Delete:
        toolKey(ToolKey::Delete);
        return true;
    default:
        return false;
    }
}

bool Canvas::nudge(int key, Qt::KeyboardModifiers modifiers) {
    const std::optional<Vec2> direction = arrowDirection(key);
    if (!direction) {
        return false;
    }
    if (isDragging()) {
        return true;
    }
    if (m_document.selection().empty()) {
        panBy(QPointF(-direction->x(), direction->y()) * arrowPan);
        return true;
    }
    const double step = m_toolbox.snap.step;
    const double distance = modifiers.testFlag(Qt::AltModifier)     ? m_view.pixel()
                            : modifiers.testFlag(Qt::ShiftModifier) ? step
                                                                    : step / fineSteps;
    m_toolbox.finish(nudgeSelected(m_toolbox.context(), distance * *direction));
    return true;
}

void Canvas::keyPressEvent(QKeyEvent* event) {
    if (opensEntry(*event)) {
        m_entry.begin(event->text());
        return;
    }
    if (event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) {
            m_spaceHeld = true;
            updateCursor();
        }
    } else if (isModifier(*event)) {
        m_belowHeld = m_belowHeld || latinKey(*event) == belowKey;
        modifiersChanged(heldAfter(*event));
    } else if (!pressToolKey(event->key()) && !nudge(event->key(), event->modifiers())) {
        QWidget::keyPressEvent(event);
    }
}

void Canvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_spaceHeld = false;
        updateCursor();
    } else if (isModifier(*event)) {
        m_belowHeld = m_belowHeld && (latinKey(*event) != belowKey || event->isAutoRepeat());
        modifiersChanged(heldAfter(*event));
    } else {
        QWidget::keyReleaseEvent(event);
    }
}

/// The mouse opens it with its release, which may as well have ended a drag.
void Canvas::contextMenuEvent(QContextMenuEvent* event) {
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    if (byKey && !isDragging() && !m_toolbox.isBusy() && (!isLive() || !m_live->isGame())) {
        Q_EMIT menuKeyPressed();
    }
}

void Canvas::leaveEvent(QEvent*) {
    m_inside = false;
    Q_EMIT pointerLeft();
}

void Canvas::focusOutEvent(QFocusEvent* event) {
    loseMouse();
    if (m_held != Qt::NoModifier) {
        modifiersChanged({}); // somebody else hears of the release
    }
    QWidget::focusOutEvent(event);
}

void Canvas::updateCursor() {
    const Qt::CursorShape shape = m_drag == Drag::Pan ? Qt::ClosedHandCursor
                                  : m_spaceHeld       ? Qt::OpenHandCursor
                                  : isLive()          ? shapeFor(m_live->cursor())
                                                      : shapeFor(m_toolbox.cursor());
    if (shape != cursor().shape()) {
        setCursor(shape);
    }
}

} // namespace spacetow
