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

QString placeOf(const FlightResult& result) {
    return result.place
               ? QStringLiteral("%1; %2").arg(shortNumberText(result.place->x()), shortNumberText(result.place->y()))
               : QString();
}

QString wonWords(const FlightResult& now, const std::optional<FlightResult>& before) {
    const QString time = shortNumberText(now.time);
    switch (newsOf(before, now)) {
    case FlightNews::Same:
        return FlightWords::tr("still wins, after %1 s").arg(time);
    case FlightNews::Elsewhere:
        return FlightWords::tr("still wins, now after %1 s; before after %2 s")
            .arg(time, shortNumberText(before->time));
    case FlightNews::Better:
        return before->end == FlightEnd::Lost ? FlightWords::tr("crashed before, wins now after %1 s").arg(time)
                                              : FlightWords::tr("was not won before, wins now after %1 s").arg(time);
    default:
        return FlightWords::tr("wins after %1 s, with %2 s of thrust").arg(time, shortNumberText(now.fuel));
    }
}

QString lostWords(const FlightResult& now, const std::optional<FlightResult>& before) {
    const QString place = placeOf(now);
    const QString seconds = shortNumberText(now.seconds);
    switch (newsOf(before, now)) {
    case FlightNews::Same:
        return FlightWords::tr("still crashes at %1, after %2 s").arg(place, seconds);
    case FlightNews::Elsewhere:
        return FlightWords::tr("still crashes, now at %1, after %2 s; before after %3 s")
            .arg(place, seconds, shortNumberText(before->seconds));
    case FlightNews::Worse:
        return FlightWords::tr("won before, crashes now at %1, after %2 s").arg(place, seconds);
    case FlightNews::Other:
        return FlightWords::tr("crashes now, at %1, after %2 s").arg(place, seconds);
    default:
        return FlightWords::tr("crashes at %1, after %2 s").arg(place, seconds);
    }
}

QString underWayWords(const FlightResult& now, const std::optional<FlightResult>& before) {
    const QString place = placeOf(now);
    const FlightNews news = newsOf(before, now);
    if (!now.place) {
        return news == FlightNews::Worse ? FlightWords::tr("won before, now there is no ship")
                                         : FlightWords::tr("runs to its end");
    }
    switch (news) {
    case FlightNews::Same:
        return FlightWords::tr("is still under way at its end, at %1").arg(place);
    case FlightNews::Elsewhere:
        return FlightWords::tr("is still under way at its end, now at %1").arg(place);
    case FlightNews::Worse:
        return FlightWords::tr("won before, now is under way at its end, at %1").arg(place);
    case FlightNews::Other:
        return FlightWords::tr("crashed before, now is under way at its end, at %1").arg(place);
    default:
        return FlightWords::tr("is under way at its end, at %1").arg(place);
    }
}

/// Where a flight came to its end; of a simulation there is nothing that would be won or lost.
bool runsOut(const FlightResult& now, RunKind kind) {
    const bool ends = now.end == FlightEnd::Won || now.end == FlightEnd::Lost || now.end == FlightEnd::UnderWay;
    return ends && kind == RunKind::Simulation;
}

QString wordsOf(const FlightResult& now, const std::optional<FlightResult>& before, RunKind kind) {
    if (runsOut(now, kind)) {
        return FlightWords::tr("is a simulation of %1 s").arg(shortNumberText(now.seconds));
    }
    switch (now.end) {
    case FlightEnd::Won:
        return wonWords(now, before);
    case FlightEnd::Lost:
        return lostWords(now, before);
    case FlightEnd::UnderWay:
        return underWayWords(now, before);
    case FlightEnd::Crowded:
        return FlightWords::tr("cannot be flown: too many bodies lie in the same place. Move them apart.");
    case FlightEnd::Unread: // for which there are words of the file
    case FlightEnd::Stopped:
        break;
    }
    return FlightWords::tr("is being flown…");
}

/// What ends as it did is good, however that is.
QString iconOf(const FlightResult& now, const std::optional<FlightResult>& before, RunKind kind) {
    if (now.end == FlightEnd::Stopped) {
        return QStringLiteral("restart");
    }
    if (runsOut(now, kind)) {
        return QStringLiteral("simulate");
    }
    const FlightNews news = newsOf(before, now);
    const bool isBad = news == FlightNews::Worse || (news == FlightNews::New && now.end == FlightEnd::Lost);
    if (now.end == FlightEnd::Unread || now.end == FlightEnd::Crowded || isBad) {
        return QStringLiteral("error");
    }
    const bool isGood = now.end == FlightEnd::Won || news == FlightNews::Same;
    return isGood ? QStringLiteral("ok") : QStringLiteral("warning");
}

QString nameOf(const StoredFlight& flight) {
    return QFileInfo(QString::fromStdString(flight.path.filename().string())).fileName();
}

} // namespace

FlightsPanel::FlightsPanel(Document& document, Words words, QWidget* parent)
    : QWidget(parent), m_document(document), m_words(std::move(words)), m_column(this) {
    m_none.setText(tr("No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or "
                      "cave.NAME.replay.json in the same folder."));
    m_none.setWordWrap(true);
    m_none.setMargin(8);
    m_none.setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_list.setAccessibleName(tr("Flights"));
    m_list.setWordWrap(true);
    m_list.setResizeMode(QListView::Adjust);
    m_list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.addWidget(&m_none);
    m_column.addWidget(&m_list);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            refresh();
        }
    });
    connect(&m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        const FlightResult result = row >= 0 ? m_results[static_cast<std::size_t>(row)] : FlightResult();
        if (result.place) {
            Q_EMIT placeWanted(result.place->x(), result.place->y());
        }
    });
    connect(&m_list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const auto row = static_cast<std::size_t>(m_list.row(item));
        if (const auto& replay = (*m_flights)[row].replay) {
            Q_EMIT flightWanted(*replay, m_results[row].update);
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
        const std::shared_ptr<const Replay>& replay = (*m_flights)[i].replay;
        const std::optional<FlightResult> before = replay ? replay->ended : std::nullopt;
        const RunKind kind = replay ? replay->kind : RunKind::Game;
        const QString words = replay ? wordsOf(m_results[i], before, kind)
                                     : FlightWords::tr("cannot be read: %1").arg(m_words((*m_flights)[i].unread));
        auto* const item = new QListWidgetItem( // owned by the list
            icon(iconOf(m_results[i], before, kind), palette()),
            QStringLiteral("%1: %2").arg(nameOf((*m_flights)[i]), words), &m_list);
        item->setToolTip(item->text());
    }
    m_list.setCurrentRow(row);
    m_list.setVisible(!m_flights->empty());
    m_none.setVisible(m_flights->empty());
}

} // namespace spacetow
