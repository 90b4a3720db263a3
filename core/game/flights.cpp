#include "core/game/flights.h"

#include "core/game/crowd.h"
#include "core/game/input_runs.h"
#include "core/game/session.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr std::string_view ending = ".replay.json";

bool isOfLevel(const std::string& name, const std::string& stem) {
    return name.ends_with(ending) && name.starts_with(stem + '.') && name.size() >= stem.size() + ending.size();
}

/// There is a level with more of the file's name: cave.2.replay.json is beside cave.2.json rather than cave.json.
bool isOfAnother(const std::filesystem::path& flight, const std::string& stem) {
    std::string name = flight.filename().string();
    name.resize(name.size() - ending.size());
    for (; name.size() > stem.size(); name.resize(name.rfind('.'))) {
        std::error_code error;
        if (std::filesystem::exists(flight.parent_path() / (name + ".json"), error)) {
            return true;
        }
    }
    return false;
}

bool isSamePlace(const std::optional<Vec2>& a, const std::optional<Vec2>& b) {
    constexpr double near = 1e-3; // m; less is nothing to speak of
    return a.has_value() == b.has_value() && (!a || (*a - *b).norm() <= near);
}

} // namespace

std::vector<StoredFlight> flightsBeside(const std::filesystem::path& level) {
    std::vector<StoredFlight> flights;
    std::error_code error;
    const std::filesystem::path folder = level.has_parent_path() ? level.parent_path() : std::filesystem::path(".");
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string stem = level.stem().string();
        if (isOfLevel(entry->path().filename().string(), stem) && !isOfAnother(entry->path(), stem)) {
            Result<Replay> replay = readReplay(entry->path());
            if (replay) {
                flights.push_back({entry->path(), std::make_shared<const Replay>(std::move(replay).value()), {}});
            } else {
                flights.push_back({entry->path(), nullptr, replay.error()});
            }
        }
    }
    std::ranges::sort(flights, {}, &StoredFlight::path);
    return flights;
}

FlightResult flightResult(const Level& level, const Replay& replay, const std::stop_token& stop) {
    if (stop.stop_requested()) {
        return {.end = FlightEnd::Stopped}; // without building the level
    }
    Session session(level, replay.seed);
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        if (stop.stop_requested()) {
            return {.end = FlightEnd::Stopped};
        }
        if (isCrowdedAt(session.updates(), session.world())) {
            return {.end = FlightEnd::Crowded};
        }
        session.step(inputs.next());
    }
    return session.flight();
}

FlightNews newsOf(const std::optional<FlightResult>& before, const FlightResult& now) {
    if (!before) {
        return FlightNews::New;
    }
    if (before->end == now.end) {
        const bool same = before->update == now.update && isSamePlace(before->place, now.place);
        return same ? FlightNews::Same : FlightNews::Elsewhere;
    }
    return now.end == FlightEnd::Won       ? FlightNews::Better
           : before->end == FlightEnd::Won ? FlightNews::Worse
                                           : FlightNews::Other;
}

} // namespace spacetow
