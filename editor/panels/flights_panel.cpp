#include "editor/panels/flights_panel.h"

#include "editor/canvas/icons.h"
#include "editor/panels/number_text.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace spacetow {

namespace {

struct FlightWords {
    Q_DECLARE_TR_FUNCTIONS(FlightsPanel)
};

QString wordsOf(const FlightResult& result) {
    const QString where =
        QStringLiteral("(%1, %2)").arg(shortNumberText(result.place.x()), shortNumberText(result.place.y()));
    switch (result.end) {
    case FlightEnd::Won:
        return FlightWords::tr("wins after %1 s, with %2 s of thrust")
            .arg(shortNumberText(result.time), shortNumberText(result.fuel));
    case FlightEnd::Lost:
        return FlightWords::tr("is lost at %1").arg(where);
    case FlightEnd::Astray:
        return FlightWords::tr("goes astray and ends at %1").arg(where);
    case FlightEnd::Unread:
        return FlightWords::tr("cannot be read");
    case FlightEnd::Stopped:
        break;
    }
    return FlightWords::tr("is being flown…");
}

QString iconOf(FlightEnd end) {
    switch (end) {
    case FlightEnd::Won:
        return QStringLiteral("ok");
    case FlightEnd::Lost:
    case FlightEnd::Unread:
        return QStringLiteral("error");
    case FlightEnd::Astray:
        return QStringLiteral("warning");
    case FlightEnd::Stopped:
        break;
    }
    return QStringLiteral("restart");
}

QString nameOf(const StoredFlight& flight) {
    return QFileInfo(QString::fromStdString(flight.path.filename().string())).fileName();
}

} // namespace

FlightsPanel::FlightsPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_column(this) {
    m_none.setText(tr("No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or "
                      "cave.NAME.replay.json in the same folder."));
    m_none.setWordWrap(true);
    m_none.setMargin(8);
    m_list.setAccessibleName(tr("Flights"));
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.addWidget(&m_none);
    m_column.addWidget(&m_list);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            refresh();
        }
    });
    connect(&m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && m_results[static_cast<std::size_t>(row)].end != FlightEnd::Unread &&
            m_results[static_cast<std::size_t>(row)].end != FlightEnd::Stopped) {
            const Vec2& place = m_results[static_cast<std::size_t>(row)].place;
            Q_EMIT placeWanted(place.x(), place.y());
        }
    });
    connect(&m_list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const auto& flight = (*m_flights)[static_cast<std::size_t>(m_list.row(item))];
        if (flight.replay) {
            Q_EMIT playWanted(*flight.replay);
        }
    });
    fill();
}

FlightsPanel::~FlightsPanel() {
    m_document.changed.disconnect(m_listener);
}

void FlightsPanel::setFile(const QString& path) {
    m_file = path;
    m_level = nullptr;
    refresh();
}

void FlightsPanel::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void FlightsPanel::finish() {
    refresh();
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

/// A panel that nobody sees flies nothing.
void FlightsPanel::refresh() {
    const std::shared_ptr<const Level>& level = m_document.current().level;
    if (!isVisible() || level == m_level) {
        return;
    }
    m_level = level;
    m_isStale = true;
    if (m_task.isRunning()) {
        m_task.requestStop();
    } else {
        begin();
    }
}

void FlightsPanel::begin() {
    m_isStale = false;
    m_task.start([this, level = m_level, file = m_file](const std::stop_token& stop) -> BackgroundTask::Then {
        auto flights =
            std::make_shared<const Flights>(file.isEmpty() ? Flights() : flightsBeside(file.toStdU16String()));
        std::vector<FlightResult> results;
        for (const StoredFlight& flight : *flights) {
            results.push_back(flight.replay ? flightResult(*level, *flight.replay, stop) : FlightResult());
        }
        return [this, flights = std::move(flights), results = std::move(results)] {
            if (m_isStale) {
                begin();
                return;
            }
            m_flights = flights;
            m_results = results;
            fill();
        };
    });
}

void FlightsPanel::fill() {
    const int row = m_list.currentRow();
    const QSignalBlocker quiet(m_list);
    m_list.clear();
    for (std::size_t i = 0; i < m_flights->size(); ++i) {
        auto* const item = new QListWidgetItem( // owned by the list
            icon(iconOf(m_results[i].end), palette()),
            QStringLiteral("%1: %2").arg(nameOf((*m_flights)[i]), wordsOf(m_results[i])), &m_list);
        item->setToolTip(item->text());
    }
    m_list.setCurrentRow(row);
    m_list.setVisible(!m_flights->empty());
    m_none.setVisible(m_flights->empty());
}

} // namespace spacetow
