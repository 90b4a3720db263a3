#pragma once
// What becomes of the flights that are stored beside the level: which still win, and which end otherwise than when
// they were recorded. They are flown again after every edit, by a thread beside the window, which the next edit stops.

#include "core/game/flights.h"
#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

namespace spacetow {

class FlightsPanel : public QWidget {
    Q_OBJECT

  public:
    using Words = std::function<QString(const Error& error)>;

    /// The document must outlive the panel.
    FlightsPanel(Document& document, Words words, QWidget* parent = nullptr);
    ~FlightsPanel() override;

    /// Where the level's file is; empty for a level that has none. The folder is looked through again.
    void setFile(const QString& path);
    const std::vector<StoredFlight>& flights() const { return *m_flights; }
    /// One a flight; of an earlier level until the flights have been flown.
    const std::vector<FlightResult>& results() const { return m_results; }
    QListWidget& list() { return m_list; }
    /// Waits until the flights have been flown in the level as it is.
    void finish();

    QSize sizeHint() const override { return {310, 160}; }
    QSize minimumSizeHint() const override { return {180, 70}; }

  signals:
    /// A flight ends here in the level as it is.
    void placeWanted(double x, double y); // m
    /// The flight, at the moment that its result is about.
    void flightWanted(const spacetow::Replay& replay, qint64 update);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    using Flights = std::vector<StoredFlight>;

    void refresh();
    void begin();
    void fill();

    Document& m_document;
    Words m_words;
    QVBoxLayout m_column;
    QLabel m_none;
    QListWidget m_list;
    QString m_file;
    std::shared_ptr<const Flights> m_flights = std::make_shared<const Flights>();
    std::vector<FlightResult> m_results;
    std::shared_ptr<const Level> m_level; // that they are flown in, or were
    bool m_isStale = false;
    int m_listener = 0;
    BackgroundTask m_task; // last, so that nothing is filled that is gone
};

} // namespace spacetow
