// Times one scene: scene_bench SCENE [N [UPDATES]] [--hz H] [--iterations I] [--substeps S], and prints one line.

#include "tests/bench/engines.h"
#include "tests/bench/stopwatch.h"

#include <charconv>
#include <cstdio>
#include <string_view>

using namespace spacetow;
using namespace spacetow::bench;

namespace {

struct Request {
    std::string_view scene;
    std::optional<int> n, updates, iterations, substeps;
    std::optional<double> hertz;
};

template <class Number>
std::optional<Number> positive(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    return whole && number > 0 && number < Number{10'000'000} ? std::optional(number) : std::nullopt;
}

/// Nothing when the arguments make no sense.
std::optional<Request> request(int count, char** arguments) {
    Request result;
    int places = 0;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = arguments[i];
        const std::string_view next = i + 1 < count ? arguments[i + 1] : "";
        bool known = true;
        if (word == "--hz") {
            known = (result.hertz = positive<double>(next)).has_value();
            ++i;
        } else if (word == "--iterations") {
            known = (result.iterations = positive<int>(next)).has_value();
            ++i;
        } else if (word == "--substeps") {
            known = (result.substeps = positive<int>(next)).has_value();
            ++i;
        } else if (places == 0) {
            result.scene = word;
            ++places;
        } else {
            std::optional<int>& place = places == 1 ? result.n : result.updates;
            known = places <= 2 && (place = positive<int>(word)).has_value();
            ++places;
        }
        if (!known) {
            return std::nullopt;
        }
    }
    return places > 0 ? std::optional(result) : std::nullopt;
}

std::vector<double> timesOf(const Engine& engine, int updates) {
    std::vector<double> times;
    for (int i = 0; i < updates; ++i) {
        times.push_back(milliseconds(engine.update));
    }
    return times;
}

void print(const Scene& scene, int updates) {
    const Engine own = spacetowEngine(scene);
    const std::vector<double> times = timesOf(own, updates);
    const double median = quantile(times, 0.5);
    const Outcome outcome = own.outcome();
    std::printf("scene=%s n=%d bodies=%zu updates=%d build_ms=%.3f median_ms=%.3f p99_ms=%.3f max_ms=%.3f", //
                scene.name.c_str(), scene.n, scene.bodies.size(), updates, own.buildMs, median, quantile(times, 0.99),
                quantile(times, 1));
    std::printf(" min_y=%.4f mean_y=%.4f kinetic=%.6g hash=%016llx", outcome.minY, outcome.meanY, outcome.kinetic,
                static_cast<unsigned long long>(outcome.hash));
    for (const Peer& peer : peers(scene)) {
        if (peer.engine) {
            const double theirs = quantile(timesOf(*peer.engine, updates), 0.5);
            std::printf(" %s_ms=%.3f %s_ratio=%.2f", peer.name, theirs, peer.name, median / theirs);
        } else {
            std::printf(" %s_ms= %s_ratio=", peer.name, peer.name);
        }
    }
    std::printf("\n");
}

} // namespace

int main(int count, char** arguments) {
    const std::optional<Request> asked = request(count, arguments);
    std::optional<Scene> scene = asked ? test::makeScene(asked->scene, asked->n) : std::nullopt;
    if (!scene) {
        std::fprintf(stderr, "Usage: scene_bench SCENE [N [UPDATES]] [--hz H] [--iterations I] [--substeps S]\n"
                             "where SCENE is one of:");
        for (const std::string& name : test::sceneNames()) {
            std::fprintf(stderr, " %s", name.c_str());
        }
        std::fprintf(stderr, "\n");
        return 2;
    }
    if (asked->hertz) {
        scene->parameters.seconds = 1 / *asked->hertz;
    }
    scene->parameters.iterations = asked->iterations.value_or(scene->parameters.iterations);
    scene->parameters.substeps = asked->substeps.value_or(scene->parameters.substeps);
    print(*scene, asked->updates.value_or(scene->updates));
    return 0;
}
