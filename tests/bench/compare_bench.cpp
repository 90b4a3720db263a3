// Times the scenes in our engine and in others: compare_bench [--json FILE] [SCENE…], "growth" being one more scene.
// The engines take turns, a block of updates each, so that whatever else the machine is doing slows all of them alike.
// All of them work in the thread that calls them, so that processor time is the whole of it.

#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"
#include "tests/support/allocation_count.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <string_view>

using namespace spacetow;
using namespace spacetow::bench;

namespace {

constexpr int block = 20;            // updates of one engine at a time
constexpr int growthFrom = 2000;     // balls
constexpr int growthTo = 20000;      // balls
constexpr double growthAllowed = 12; // times as long for ten times as many
constexpr const char* none = "-";    // printed where there is no figure

struct Timed {
    Engine engine;
    std::vector<double> times;
    std::uint64_t allocations = 0; // in the second half of the updates
};

struct Row {
    std::string scene, peer;
    double ours = 0;
    std::optional<double> theirs;
    std::uint64_t allocations = 0;
};

void run(Timed& timed, int first, int last, int updates) {
    for (int i = first; i < last; ++i) {
        const std::uint64_t before = test::allocationCount();
        const double time = processorMilliseconds(timed.engine.update);
        if (i >= updates / 2) {
            timed.allocations += test::allocationCount() - before;
        }
        timed.times.push_back(time);
    }
}

void runInTurns(std::vector<Timed>& all, int updates) {
    for (int first = 0; first < updates; first += block) {
        for (Timed& timed : all) {
            run(timed, first, std::min(first + block, updates), updates);
        }
    }
}

double median(const Timed& timed) {
    return quantile(timed.times, 0.5);
}

std::vector<Row> rowsOf(const Scene& scene) {
    std::vector<Timed> all{{spacetowEngine(scene), {}}};
    std::vector<Peer> others = peers(scene);
    for (Peer& peer : others) {
        if (peer.engine) {
            all.push_back({std::move(*peer.engine), {}});
        }
    }
    runInTurns(all, scene.updates);
    std::vector<Row> rows;
    for (const Peer& peer : others) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Timed& timed) { return timed.engine.name == peer.name; });
        rows.push_back({scene.name, peer.name, median(all.front()),
                        found != all.end() ? std::optional(median(*found)) : std::nullopt, all.front().allocations});
    }
    return rows;
}

/// Ten times as many balls, beside our own time for fewer.
std::vector<Row> growth() {
    const auto scene = [](int n) { return *test::makeScene("balls", n); };
    std::vector<Timed> all{{spacetowEngine(scene(growthTo)), {}}, {spacetowEngine(scene(growthFrom)), {}}};
    runInTurns(all, scene(growthFrom).updates);
    return {{"balls " + std::to_string(growthTo), "balls " + std::to_string(growthFrom), median(all[0]), median(all[1]),
             all[0].allocations}};
}

void print(const Row& row) {
    std::string theirs = none, ratio = none;
    if (row.theirs) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3f", *row.theirs);
        theirs = text;
        std::snprintf(text, sizeof text, "%.2f", row.ours / *row.theirs);
        ratio = text;
    }
    std::printf("%-12s %-11s %10.3f %10s %7s %12llu\n", row.scene.c_str(), row.peer.c_str(), row.ours, theirs.c_str(),
                ratio.c_str(), static_cast<unsigned long long>(row.allocations));
    std::fflush(stdout);
}

nlohmann::ordered_json toJson(const Row& row) {
    nlohmann::ordered_json json{{"scene", row.scene}, {"peer", row.peer}, {"ours_ms", row.ours},
                                {"peer_ms", nullptr}, {"ratio", nullptr}, {"allocations", row.allocations}};
    if (row.theirs) {
        json["peer_ms"] = *row.theirs;
        json["ratio"] = row.ours / *row.theirs;
    }
    return json;
}

struct Request {
    std::string file;
    std::vector<std::string> scenes;
};

std::vector<std::string> allNames() {
    std::vector<std::string> names = test::sceneNames();
    names.emplace_back("growth");
    return names;
}

/// Nothing when the arguments make no sense.
std::optional<Request> request(int count, char** arguments) {
    const std::vector<std::string> known = allNames();
    Request result;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--json" && i + 1 < count) {
            result.file = arguments[++i];
        } else if (std::find(known.begin(), known.end(), word) != known.end()) {
            result.scenes.push_back(word);
        } else {
            return std::nullopt;
        }
    }
    if (result.scenes.empty()) {
        result.scenes = known;
    }
    return result;
}

} // namespace

int main(int count, char** arguments) {
    const std::optional<Request> asked = request(count, arguments);
    if (!asked) {
        std::fprintf(stderr, "Usage: compare_bench [--json FILE] [SCENE…]\nwhere SCENE is one of:");
        for (const std::string& name : allNames()) {
            std::fprintf(stderr, " %s", name.c_str());
        }
        std::fprintf(stderr, "\n");
        return 2;
    }
    std::ofstream file;
    if (!asked->file.empty()) {
        file.open(asked->file);
        if (!file) {
            std::fprintf(stderr, "cannot write %s\n", asked->file.c_str());
            return 2;
        }
    }
    std::printf(
        "median milliseconds of processor time an update; allocations are ours, in the second half of the updates\n");
    std::printf("%-12s %-11s %10s %10s %7s %12s\n", "scene", "peer", "ours_ms", "peer_ms", "ratio", "allocations");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const std::string& name : asked->scenes) {
        for (const Row& row : name == "growth" ? growth() : rowsOf(*test::makeScene(name, std::nullopt))) {
            print(row);
            rows.push_back(toJson(row));
        }
        if (name == "growth") {
            std::printf("(the last ratio should stay below %.0f)\n", growthAllowed);
        }
    }
    if (file.is_open()) {
        file << rows.dump(2) << '\n';
    }
    return 0;
}
