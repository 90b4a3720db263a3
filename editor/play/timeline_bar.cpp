#include "editor/play/timeline_bar.h"

#include "core/game/runner.h"
#include "editor/canvas/palette.h"
#include "editor/canvas/stage.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {
namespace {

constexpr double side = 9;    // px left free at both ends, for half a handle
constexpr double reach = 4;   // px, from which a mark is meant
constexpr double barTop = 11; // px
constexpr double barHigh = 8; // px

/// Colours that people who see red and green alike can tell apart, and a height of their own for each kind.
QColor colorOf(MarkKind kind, Shade shade) {
    const bool dark = shade == Shade::Dark;
    switch (kind) {
    case MarkKind::Crash:
        return dark ? QColor(255, 120, 96) : QColor(196, 40, 16);
    case MarkKind::Tow:
        return dark ? QColor(255, 206, 92) : QColor(176, 112, 0);
    case MarkKind::Win:
        return dark ? QColor(92, 226, 178) : QColor(0, 128, 92);
    case MarkKind::Edit:
        return dark ? QColor(206, 156, 255) : QColor(126, 52, 196);
    case MarkKind::Attempt:
    case MarkKind::LetGo:
        return dark ? QColor(150, 190, 255) : QColor(36, 92, 200);
    case MarkKind::FocusTouch:
    case MarkKind::FocusPart:
    case MarkKind::Touch:
        break;
    }
    return dark ? QColor(160, 170, 186) : QColor(110, 120, 138);
}

QString secondsText(double seconds) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(seconds, 'f', 2);
}

} // namespace

QString speedText(double speed) {
    return speed < 1 ? TimelineBar::tr("1/%1 ×").arg(qRound(1 / speed)) : TimelineBar::tr("%1 ×").arg(qRound(speed));
}

QString markName(MarkKind kind) {
    switch (kind) {
    case MarkKind::Touch:
        return TimelineScale::tr("Touch");
    case MarkKind::FocusTouch:
        return TimelineScale::tr("The selected body touches something");
    case MarkKind::FocusPart:
        return TimelineScale::tr("The selected body parts from something");
    case MarkKind::Tow:
        return TimelineScale::tr("Payload taken in tow");
    case MarkKind::LetGo:
        return TimelineScale::tr("Payload let go");
    case MarkKind::Crash:
        return TimelineScale::tr("Crash");
    case MarkKind::Attempt:
        return TimelineScale::tr("New attempt");
    case MarkKind::Win:
        return TimelineScale::tr("Win");
    case MarkKind::Edit:
        break;
    }
    return TimelineScale::tr("Edit of the level");
}

TimelineScale::TimelineScale(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("timelineScale"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(tr("Timeline"));
}

void TimelineScale::showState(const TimelineState& state) {
    if (state.shown != m_state.shown) {
        m_sought.reset();
    }
    if (!(state == m_state)) {
        m_state = state;
        setAccessibleDescription(timeText(m_state.shown));
        update();
    }
}

double TimelineScale::xOf(std::int64_t update) const {
    const auto all =
        static_cast<double>(std::max<std::int64_t>(1, std::max(m_state.last, m_state.goal) - m_state.first));
    return side + (width() - 2 * side) * static_cast<double>(update - m_state.first) / all;
}

std::int64_t TimelineScale::updateAt(double x) const {
    const auto all = static_cast<double>(std::max(m_state.last, m_state.goal) - m_state.first);
    const double share = std::clamp((x - side) / std::max(1.0, width() - 2 * side), 0.0, 1.0);
    return m_state.first + std::llround(share * all);
}

std::optional<TimelineMark> TimelineScale::markAt(double x) const {
    std::optional<TimelineMark> nearest;
    double distance = reach;
    for (const TimelineMark& mark : m_state.marks.all()) {
        if (mark.update >= m_state.first && std::abs(xOf(mark.update) - x) <= distance) {
            distance = std::abs(xOf(mark.update) - x);
            nearest = mark;
        }
    }
    return nearest;
}

QString TimelineScale::timeText(std::int64_t update) const {
    return tr("%1 s").arg(secondsText(static_cast<double>(update) * m_state.updateSeconds));
}

bool TimelineScale::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const std::optional<TimelineMark> mark = markAt(help->pos().x());
        const std::int64_t update = mark ? mark->update : updateAt(help->pos().x());
        QString words = mark ? tr("%1, at %2").arg(markName(mark->kind), timeText(update)) : timeText(update);
        if (m_state.hasGhosts) {
            words +=
                QLatin1Char('\n') + tr("Dashed on the canvas: what was to come before the run was changed. Without a "
                                       "ship these are the ways of the selected body and of up to %1 others.")
                                        .arg(Tracks::mostBodies);
        }
        QToolTip::showText(help->globalPos(), words, this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_PageUp || key == Qt::Key_PageDown ||
            key == Qt::Key_Left || key == Qt::Key_Right) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void TimelineScale::paintMarks(QPainter& painter) const {
    const Shade shade = shadeOf(palette());
    for (const TimelineMark& mark : m_state.marks.all()) {
        if (mark.update < m_state.first) {
            continue;
        }
        const double x = std::round(xOf(mark.update)) + 0.5;
        const bool ends = mark.kind == MarkKind::FocusPart;
        const bool small = ends || mark.kind == MarkKind::Touch || mark.kind == MarkKind::FocusTouch;
        painter.setPen(stroke(colorOf(mark.kind, shade), small ? 1 : 2));
        painter.drawLine(QPointF(x, ends    ? barTop
                                    : small ? barTop - 3
                                            : barTop - 6),
                         QPointF(x, barTop + barHigh + (ends ? 3 : 0))); // what ends goes down
        if (!small) {
            painter.setBrush(colorOf(mark.kind, shade));
            painter.drawEllipse(QPointF(x, barTop - 6), 2.5, 2.5);
        }
    }
}

void TimelineScale::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor text = palette().color(QPalette::WindowText);
    QColor faint = text;
    faint.setAlpha(50);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faint);
    painter.drawRoundedRect(QRectF(side, barTop, width() - 2 * side, barHigh), barHigh / 2, barHigh / 2);
    QColor passed = palette().color(QPalette::Highlight);
    passed.setAlpha(hasFocus() ? 255 : 190);
    painter.setBrush(faint);
    painter.drawRoundedRect(QRectF(QPointF(side, barTop), QPointF(xOf(m_state.last), barTop + barHigh)), barHigh / 2,
                            barHigh / 2);
    painter.setBrush(passed);
    painter.drawRoundedRect(QRectF(QPointF(side, barTop), QPointF(xOf(m_state.shown), barTop + barHigh)), barHigh / 2,
                            barHigh / 2);
    paintMarks(painter);
    painter.setPen(stroke(palette().color(QPalette::Window), 1.5));
    painter.setBrush(hasFocus() ? palette().color(QPalette::Highlight) : text);
    painter.drawEllipse(QPointF(xOf(m_state.shown), barTop + barHigh / 2), 7, 7);
}

void TimelineScale::seek(std::int64_t update) {
    const std::int64_t wanted = std::clamp(update, m_state.first, std::max(m_state.last, m_state.goal));
    m_sought = wanted;
    Q_EMIT sought(wanted);
}

void TimelineScale::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        const std::optional<TimelineMark> mark = markAt(event->position().x());
        seek(mark ? mark->update : updateAt(event->position().x()));
    }
}

void TimelineScale::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) {
        seek(updateAt(event->position().x()));
    }
}

void TimelineScale::keyPressEvent(QKeyEvent* event) {
    const auto second = std::max<std::int64_t>(1, std::llround(1 / m_state.updateSeconds));
    const std::int64_t at = m_sought.value_or(m_state.shown); // keys repeat faster than pictures come
    const std::int64_t step = event->modifiers().testFlag(Qt::ShiftModifier) ? second : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        seek(at - step);
        break;
    case Qt::Key_Right:
        seek(at + step);
        break;
    case Qt::Key_PageUp:
        seek(at - second);
        break;
    case Qt::Key_PageDown:
        seek(at + second);
        break;
    case Qt::Key_Home:
        seek(m_state.first);
        break;
    case Qt::Key_End:
        seek(m_state.last);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent), m_row(this) {
    setObjectName(QStringLiteral("timelineBar"));
    m_row.setContentsMargins(6, 2, 10, 2);
    m_row.setSpacing(6);
    m_row.addLayout(&m_buttons);
    m_buttons.setSpacing(0);
    m_row.addWidget(&m_scale, 1);
    m_row.addWidget(&m_time);
    m_row.addWidget(&m_speed);
    makeSpeeds();
    m_time.setTextFormat(Qt::PlainText);
    m_time.setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_time.setMinimumWidth(m_time.fontMetrics().horizontalAdvance(QStringLiteral("0000.00 / 0000.00 s")));
    showState({});
}

void TimelineBar::makeSpeeds() {
    m_speed.setObjectName(QStringLiteral("speed"));
    m_speed.setAutoRaise(true);
    m_speed.setFocusPolicy(Qt::NoFocus);
    m_speed.setPopupMode(QToolButton::InstantPopup);
    m_speed.setToolTip(tr("How fast time runs"));
    m_speed.setAccessibleName(m_speed.toolTip());
    auto* const menu = new QMenu(this); // owned by it
    auto* const group = new QActionGroup(menu);
    for (double speed = Runner::slowest; speed <= Runner::fastest; speed *= 2) {
        QAction* const action = menu->addAction(speedText(speed));
        action->setCheckable(true);
        action->setData(speed);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, speed] { Q_EMIT speedWanted(speed); });
    }
    m_speed.setMenu(menu);
    const int widest = m_speed.fontMetrics().horizontalAdvance(speedText(Runner::slowest));
    m_speed.setMinimumWidth(widest + 26); // with the arrow of the menu; the scale keeps its place
    showSpeed(1);
}

void TimelineBar::showSpeed(double speed) {
    if (std::exchange(m_shownSpeed, speed) == speed) {
        return;
    }
    m_speed.setText(speedText(speed));
    for (QAction* const action : m_speed.menu()->actions()) {
        action->setChecked(action->data().toDouble() == speed);
    }
}

/// Without the button for the speed, which keys and menu change as well.
QSize TimelineBar::minimumSizeHint() const {
    QSize least = QWidget::minimumSizeHint();
    if (!m_speed.isHidden()) {
        least.rwidth() -= m_speed.minimumWidth() + m_row.spacing();
    }
    return least;
}

void TimelineBar::resizeEvent(QResizeEvent* event) {
    constexpr int scale = 160; // px, that the scale should have at least
    const int rest = minimumSizeHint().width() - m_scale.minimumSizeHint().width();
    m_speed.setVisible(width() >= rest + scale + m_speed.minimumWidth() + m_row.spacing());
    QWidget::resizeEvent(event);
}

void TimelineBar::setActions(const QList<QAction*>& actions) {
    for (QAction* const action : actions) {
        auto* const button = new QToolButton(this); // owned by it
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setIconSize(QSize(18, 18));
        button->setFocusPolicy(Qt::NoFocus); // the scale does the same by keys
        button->setAccessibleName(action->iconText());
        m_buttons.addWidget(button);
    }
}

void TimelineBar::showState(const TimelineState& state) {
    m_scale.showState(state);
    m_time.setText(tr("%1 / %2 s")
                       .arg(secondsText(static_cast<double>(state.shown) * state.updateSeconds),
                            secondsText(static_cast<double>(state.last) * state.updateSeconds)));
}

} // namespace spacetow
