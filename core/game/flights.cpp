#include "core/game/flights.h"

#include "core/game/input_runs.h"
#include "core/game/session.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

constexpr std::string_view ending = ".replay.json";

bool isOfLevel(const std::string& name, const std::string& stem) {
    return name.ends_with(ending) && name.starts_with(stem + '.') && name.size() >= stem.size() + ending.size();
}

bool isLost(Phase phase) {
    return phase == Phase::Crashed || phase == Phase::GameOver;
}

/// Watches a session for the moment that its result is about.
class Flight {
  public:
    Flight(const Level& level, std::uint64_t seed) : m_session(level, seed) { note(); }

    void step(const StepInput& input) {
        m_session.step(input);
        if (m_session.phase() == Phase::Won || !m_lost) {
            note();
        }
        m_lost = m_lost || isLost(m_session.phase());
        m_won = m_won || m_session.phase() == Phase::Won;
    }

    FlightResult result() const {
        FlightResult result = m_last;
        const bool won = m_session.phase() == Phase::Won;
        result.end = won ? FlightEnd::Won : m_lost ? FlightEnd::Lost : FlightEnd::Astray;
        result.time = m_session.time();
        result.fuel = m_session.fuel();
        return result;
    }

  private:
    /// Until it is won, or lost for the first time.
    void note() {
        if (m_won) {
            return;
        }
        if (const std::optional<BodyState> ship = m_session.ship()) {
            m_last.place = ship->massCenter;
        }
        m_last.update = m_session.updates();
    }

    Session m_session;
    FlightResult m_last;
    bool m_lost = false;
    bool m_won = false;
};

} // namespace

std::vector<StoredFlight> flightsBeside(const std::filesystem::path& level) {
    std::vector<StoredFlight> flights;
    std::error_code error;
    const std::filesystem::path folder = level.has_parent_path() ? level.parent_path() : std::filesystem::path(".");
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (isOfLevel(entry->path().filename().string(), level.stem().string())) {
            Result<Replay> replay = readReplay(entry->path());
            flights.push_back({entry->path(), replay ? std::make_shared<const Replay>(std::move(replay).value())
                                                     : std::shared_ptr<const Replay>()});
        }
    }
    std::ranges::sort(flights, {}, &StoredFlight::path);
    return flights;
}

FlightResult flightResult(const Level& level, const Replay& replay, const std::stop_token& stop) {
    Flight flight(level, replay.seed);
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        if (stop.stop_requested()) {
            return {.end = FlightEnd::Stopped};
        }
        flight.step(inputs.next());
    }
    return flight.result();
}

} // namespace spacetow
