#include "editor/panels/profile_panel.h"

#include "core/physics/query/explain.h"
#include "editor/canvas/palette.h"
#include "editor/panels/list_keys.h"
#include "editor/panels/names.h"
#include "editor/panels/plot_names.h"
#include "editor/panels/plot_view.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr int pauseBetweenFigures = 200; // ms
constexpr int counterCount = 10;

constexpr std::array<const char*, counterCount> counterNames{
    QT_TRANSLATE_NOOP("ProfilePanel", "Static bodies"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Kinematic bodies"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Dynamic bodies"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Awake"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Asleep"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Connectors"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Pairs that may meet"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Pairs that touch"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Islands"),
    QT_TRANSLATE_NOOP("ProfilePanel", "Leaves of the quadtrees"),
};

std::array<int, counterCount> figuresOf(const WorldCounters& c) {
    return {c.statics,    c.kinematics, c.dynamics, c.awake,   c.asleep,
            c.connectors, c.pairs,      c.contacts, c.islands, c.treeCells};
}

QString milliseconds(double seconds) {
    return QLocale().toString(1000 * seconds, 'f', 3);
}

/// The next of 1, 2, 5, 10 … that is no less.
double roundUp(double seconds) {
    const double power = std::pow(10, std::floor(std::log10(std::max(seconds, 1e-6))));
    const double factor = seconds / power;
    return power * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10);
}

StepStage stageAt(std::size_t i) {
    return static_cast<StepStage>(i);
}

} // namespace

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Times of the last updates"));
    setToolTip(tr("The last updates, newest at the right; the colors are those of the stages below"));
}

void ProfileChart::setProfile(std::shared_ptr<const StepProfile> profile, double period) {
    m_profile = std::move(profile);
    m_period = period;
    m_top = m_profile ? roundUp(m_profile->together().maximum) : 0.001;
    update();
}

QColor ProfileChart::stageColor(StepStage stage, const QPalette& palette) {
    const auto i = static_cast<std::size_t>(stage);
    const QColor color = PlotView::curveColor(i, palette);
    return i < 7 ? color : mixed(color, palette.color(QPalette::Text), 0.45); // as colours are seven
}

void ProfileChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QColor ink = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.75);
    if (m_profile) {
        const std::vector<StepProfile::Stages> updates = m_profile->history();
        const double wide = static_cast<double>(width()) / static_cast<double>(StepProfile::kept);
        double x = width() - wide * static_cast<double>(updates.size());
        for (const StepProfile::Stages& stages : updates) {
            double y = height();
            for (std::size_t i = 0; i < stages.size(); ++i) {
                const double high = stages[i] / m_top * height();
                painter.fillRect(QRectF(x, y - high, wide, high), stageColor(stageAt(i), palette()));
                y -= high;
            }
            x += wide;
        }
        if (m_period <= m_top) {
            const double y = height() * (1 - m_period / m_top);
            painter.setPen(QPen(markColors(shadeOf(palette())).error, 1, Qt::DashLine));
            painter.drawLine(QPointF(0, y), QPointF(width(), y));
        }
        painter.setPen(ink);
        painter.drawText(rect().adjusted(4, 2, -4, 0), Qt::AlignLeft | Qt::AlignTop,
                         tr("%1 ms").arg(QLocale().toString(1000 * m_top, 'g', 3)));
    } else {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Times are taken while the level is played or simulated."));
    }
}

ProfilePanel::ProfilePanel(QWidget* parent) : QWidget(parent), m_column(this) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_column.addWidget(&m_chart);
    m_column.addWidget(&m_rows, 1);
    m_rows.setColumnCount(4);
    m_rows.setHeaderLabels({tr("Stage, ms"), tr("Now"), tr("Average"), tr("Maximum")});
    m_rows.header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_rows.header()->setStretchLastSection(true);
    m_rows.setFrameShape(QFrame::NoFrame);
    m_rows.setRootIsDecorated(false);
    m_rows.setUniformRowHeights(true);
    m_rows.setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_rows.setAccessibleName(tr("Times and counters"));
    m_rows.installEventFilter(this);
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseBetweenFigures);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_stale) {
            refresh();
        }
    });
    fill();
    tint();
}

/// All rows there will ever be.
void ProfilePanel::fill() {
    const auto addRow = [this](const QString& what) {
        auto* const item = new QTreeWidgetItem(&m_rows, QStringList{what}); // owned by the tree
        for (int column = 1; column < 4; ++column) {
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
        return item;
    };
    for (std::size_t i = 0; i < stepStageCount; ++i) {
        addRow(stageName(stageAt(i)));
    }
    m_total = addRow(tr("Total"));
    for (const char* name : counterNames) {
        addRow(tr(name));
    }
}

void ProfilePanel::tint() {
    for (std::size_t i = 0; i < stepStageCount; ++i) {
        QPixmap square(12, 12);
        square.fill(ProfileChart::stageColor(stageAt(i), palette()));
        m_rows.topLevelItem(static_cast<int>(i))->setIcon(0, QIcon(square));
    }
}

void ProfilePanel::showSession(std::shared_ptr<const Session> session, std::shared_ptr<const StepProfile> profile) {
    m_session = std::move(session);
    m_profile = std::move(profile);
    m_stale = true;
    if (isVisible() && !m_pause.isActive()) {
        refresh();
    }
}

void ProfilePanel::refresh() {
    m_stale = false;
    m_pause.start();
    m_chart.setProfile(m_profile, m_session ? m_session->updateSeconds() : 0.02);
    showTimes();
    showCounters();
}

void ProfilePanel::showTimes() {
    const auto show = [this](QTreeWidgetItem& item, const StepProfile::Figures& figures) {
        const std::array values{figures.now, figures.average, figures.maximum};
        for (std::size_t i = 0; i < values.size(); ++i) {
            item.setText(static_cast<int>(i) + 1, m_profile ? milliseconds(values[i]) : QStringLiteral("–"));
        }
    };
    for (std::size_t i = 0; i < stepStageCount; ++i) {
        show(*m_rows.topLevelItem(static_cast<int>(i)), m_profile ? m_profile->of(stageAt(i)) : StepProfile::Figures{});
    }
    show(*m_total, m_profile ? m_profile->together() : StepProfile::Figures{});
}

void ProfilePanel::showCounters() {
    const int first = m_rows.indexOfTopLevelItem(m_total) + 1;
    const std::array<int, counterCount> figures =
        m_session ? figuresOf(counters(m_session->world())) : std::array<int, counterCount>{};
    for (int i = 0; i < counterCount; ++i) {
        m_rows.topLevelItem(first + i)->setText(1, m_session ? QLocale().toString(figures[static_cast<std::size_t>(i)])
                                                             : QStringLiteral("–"));
    }
}

void ProfilePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void ProfilePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

bool ProfilePanel::eventFilter(QObject* watched, QEvent* event) {
    return (watched == &m_rows && keepsListKey(*event)) || QWidget::eventFilter(watched, event);
}

} // namespace spacetow
