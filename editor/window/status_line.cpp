#include "editor/window/status_line.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <QEvent>
#include <QLocale>
#include <QStyleOption>
#include <QStylePainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace spacetow {

namespace {

constexpr std::array divisions{1, 2, 3, 4, 5, 10};

QString metres(double value, int decimals = 2) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0 : value, 'f', decimals);
}

/// Those of its clauses that there is room for, in their order, or of the first one as many letters.
QString fitted(const QString& hint, const QFontMetrics& metrics, int room) {
    const QString between = QStringLiteral(" · ");
    if (metrics.horizontalAdvance(hint) <= room) {
        return hint;
    }
    const QString more = between + QStringLiteral("…");
    QString shown;
    for (const QString& clause : hint.split(between)) {
        const QString longer = shown.isEmpty() ? clause : shown + between + clause;
        shown = metrics.horizontalAdvance(longer + more) <= room ? longer : shown;
        if (shown.isEmpty()) {
            break; // without its beginning the rest could be misread
        }
    }
    return shown.isEmpty() ? metrics.elidedText(hint, Qt::ElideRight, room) : shown + more;
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent), m_steps(tr("Grid S&tep")), m_stepGroup(nullptr), m_divisions(tr("Su&b-Grid")),
      m_divisionGroup(nullptr) {
    m_hintLabel.setObjectName(QStringLiteral("hint"));
    m_hintLabel.setTextFormat(Qt::PlainText);
    m_hintLabel.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hintLabel.setContentsMargins(6, 0, 6, 0);
    m_hintLabel.installEventFilter(this);
    addWidget(&m_hintLabel, 1);
    addPermanentWidget(&m_pace);
    addPermanentWidget(&m_selection);
    m_selection.setObjectName(QStringLiteral("selection"));
    m_pace.setObjectName(QStringLiteral("pace"));
    m_pace.setTextFormat(Qt::PlainText);
    addPermanentWidget(&m_pointer);
    m_pointer.setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    // Wide enough for what is usual, so that the line does not jump about under the moving pointer.
    m_pointer.setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("x -00.00  y -00.00 m")));
    dressButton(m_snap);
    addPermanentWidget(&m_zoom);
    dressButton(m_problems);
    m_snap.setToolTip(tr("How points snap; Shift+G switches the grid, Shift+S the rest, Ctrl suspends both"));
    m_snap.setObjectName(QStringLiteral("snap"));
    m_snap.setMenu(&m_steps);
    m_snap.setPopupMode(QToolButton::InstantPopup);
    fillSteps();
    fillDivisions();
    m_problems.setToolTip(tr("Next problem (F4)"));
    connect(&m_zoom, &ZoomField::zoomChosen, this, &StatusLine::zoomChosen);
    connect(&m_zoom, &ZoomField::left, this, &StatusLine::left);
    connect(&m_problems, &QToolButton::clicked, this, &StatusLine::problemsClicked);
    setProblems(0, 0);
}

StatusLine::~StatusLine() {
    m_hintLabel.removeEventFilter(this);
}

void StatusLine::fillSteps() {
    for (const double step : usualSteps()) {
        auto action = std::make_unique<QAction>(tr("%1 m").arg(QLocale().toString(step)));
        action->setCheckable(true);
        action->setData(step);
        connect(action.get(), &QAction::triggered, this, [this, step] { Q_EMIT stepChosen(step); });
        m_stepGroup.addAction(action.get());
        m_steps.addAction(action.get());
        m_stepActions.push_back(std::move(action));
    }
}

void StatusLine::fillDivisions() {
    for (const int parts : divisions) {
        auto action = std::make_unique<QAction>(parts == 1 ? tr("None") : tr("%1 parts").arg(parts));
        action->setCheckable(true);
        action->setData(parts);
        connect(action.get(), &QAction::triggered, this, [this, parts] { Q_EMIT divisionChosen(parts); });
        m_divisionGroup.addAction(action.get());
        m_divisions.addAction(action.get());
        m_divisionActions.push_back(std::move(action));
    }
}

void StatusLine::dressButton(QToolButton& button) {
    button.setAutoRaise(true);
    button.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button.setIconSize(QSize(16, 16));
    button.setFocusPolicy(Qt::NoFocus);
    addPermanentWidget(&button);
}

void StatusLine::setHint(const QString& sentence) {
    if (sentence != m_hint) {
        m_hint = sentence;
        m_hintLabel.setToolTip(plainToolTip(sentence));
        elide();
        fit();
    }
}

void StatusLine::elide() {
    const int room = m_hintLabel.width() - 12;
    m_hintLabel.setText(fitted(m_hint, m_hintLabel.fontMetrics(), std::max(room, 20)));
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_hintLabel && event->type() == QEvent::Resize) {
        elide();
    }
    return QStatusBar::eventFilter(watched, event);
}

void StatusLine::fit() {
    constexpr int around = 6; // px that a part takes beside its own width
    constexpr int grip = 28;  // px at the end of the line
    const auto widthOf = [](const QWidget& part) {
        return std::max(part.sizeHint().width(), part.minimumWidth()) + around;
    };
    // The hint is what the line is for, and shortens itself.
    const int hint = std::min(m_hintLabel.fontMetrics().horizontalAdvance(m_hint) + 16, width() * 2 / 5);
    const int room = width() - grip - hint - widthOf(m_problems);
    const bool selected = m_boardShown && !m_selectionCount.isEmpty();
    m_problems.setVisible(m_boardShown);
    m_selection.setText(m_selectionCount + m_selectionSize);
    const int whole = widthOf(m_zoom) + widthOf(m_snap) + widthOf(m_pointer) + (selected ? widthOf(m_selection) : 0) +
                      (m_pace.text().isEmpty() ? 0 : widthOf(m_pace));
    if (whole > room) {
        m_selection.setText(m_selectionCount);
    }
    int taken = 0;
    const std::array<std::pair<QWidget*, bool>, 5> parts{{{&m_pace, !m_pace.text().isEmpty()},
                                                          {&m_zoom, m_boardShown},
                                                          {&m_selection, selected},
                                                          {&m_snap, m_boardShown},
                                                          {&m_pointer, m_boardShown}}};
    for (const auto& [part, wanted] : parts) {
        taken += wanted ? widthOf(*part) : 0;
        part->setVisible(wanted && taken <= room);
    }
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    fit();
}

/// What is said for a moment, such as what a field takes, is shortened as the hint is.
void StatusLine::paintEvent(QPaintEvent* event) {
    if (currentMessage().isEmpty()) {
        QStatusBar::paintEvent(event);
        return;
    }
    constexpr int margin = 6; // px, as at the hint
    int end = width();
    for (const QWidget* part :
         std::initializer_list<const QWidget*>{&m_pace, &m_selection, &m_pointer, &m_snap, &m_zoom, &m_problems}) {
        end = part->isVisible() ? std::min(end, part->x()) : end;
    }
    QStylePainter painter(this);
    QStyleOption panel;
    panel.initFrom(this);
    painter.drawPrimitive(QStyle::PE_PanelStatusBar, panel);
    const QRect room(margin, 0, std::max(0, end - 2 * margin), height());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     fitted(currentMessage(), fontMetrics(), room.width()));
}

void StatusLine::setPointer(double x, double y, int decimals) {
    m_pointer.setText(tr("x %1  y %2 m").arg(metres(x, decimals), metres(y, decimals)));
}

void StatusLine::clearPointer() {
    m_pointer.clear();
}

void StatusLine::setSelection(int count, const Aabb& box) {
    m_selectionCount = count > 0 ? counted(tr("%n selected", nullptr, count), count) : QString();
    m_selectionSize =
        count > 0 && !box.isEmpty() ? tr(", %1 × %2 m").arg(metres(box.size().x()), metres(box.size().y())) : QString();
    fit();
}

void StatusLine::setSnap(const SnapSettings& snap) {
    for (const std::unique_ptr<QAction>& action : m_stepActions) {
        action->setChecked(action->data().toDouble() == snap.step);
    }
    for (const std::unique_ptr<QAction>& action : m_divisionActions) {
        action->setChecked(action->data().toInt() == snap.division);
    }
    m_snap.setText(snap.grid    ? tr("Snap %1 m").arg(QLocale().toString(snap.fineStep()))
                   : snap.smart ? tr("Snap to objects")
                                : tr("Snap off"));
    fit();
}

void StatusLine::setZoom(double zoom) {
    m_zoom.setZoom(zoom);
    fit();
}

void StatusLine::setProblems(int errors, int warnings) {
    m_errors = errors;
    m_warnings = warnings;
    const MarkColors colors = markColors(shadeOf(palette()));
    if (errors > 0) {
        m_problems.setIcon(icon(QStringLiteral("error"), colors.error));
    } else if (warnings > 0) {
        m_problems.setIcon(icon(QStringLiteral("warning"), colors.warning));
    } else {
        m_problems.setIcon(icon(QStringLiteral("ok"), colors.good));
    }
    const QString ofErrors = counted(tr("%n errors", nullptr, errors), errors);
    const QString ofWarnings = counted(tr("%n warnings", nullptr, warnings), warnings);
    const QString text = errors > 0 && warnings > 0 ? tr("%1, %2").arg(ofErrors, ofWarnings)
                         : errors > 0               ? ofErrors
                         : warnings > 0             ? ofWarnings
                                                    : tr("No problems");
    m_problems.setText(text);
    fit();
}

void StatusLine::setPace(const QString& pace) {
    if (pace != m_pace.text()) {
        m_pace.setText(pace);
        fit();
    }
}

void StatusLine::setBoardShown(bool shown) {
    m_boardShown = shown;
    fit();
}

void StatusLine::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        setProblems(m_errors, m_warnings);
    }
    QStatusBar::changeEvent(event);
}

} // namespace spacetow
