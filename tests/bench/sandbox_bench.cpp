// Times the sandbox: sandbox_bench [--json FILE] [--cpu] [PART…]. Each figure is printed beside its bar.

#include "tests/bench/sandbox_figures.h"

#include <QApplication>
#include <QStyleFactory>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <span>
#include <vector>

using namespace spacetow::bench;

namespace {

struct Part {
    const char* name;
    void (*measure)(const Meter&);
};

constexpr Part allParts[] = {
    {"runs", measureRuns},     {"reach", measureReach}, {"time", measureTime},
    {"window", measureWindow}, {"edits", measureEdits},
};

struct Request {
    std::string file;
    std::vector<Part> parts; // none stand for all
    bool cpu = false;        // processor time instead of what the clock on the wall says
};

/// Nothing when the arguments make no sense.
std::optional<Request> request(const QStringList& arguments) {
    Request result;
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        if (arguments[i] == QStringLiteral("--json") && i + 1 < arguments.size()) {
            result.file = arguments[++i].toStdString();
        } else if (arguments[i] == QStringLiteral("--cpu")) {
            result.cpu = true;
        } else {
            const auto part = std::ranges::find(allParts, arguments[i].toStdString(), &Part::name);
            if (part == std::end(allParts)) {
                return std::nullopt;
            }
            result.parts.push_back(*part);
        }
    }
    return result;
}

void printFigure(const SandboxFigure& figure) {
    const bool misses = figure.bar > 0 && (figure.isAtLeast ? figure.value < figure.bar : figure.value > figure.bar);
    char bar[32] = "-";
    if (figure.bar > 0) {
        std::snprintf(bar, sizeof bar, "%s%g", figure.isAtLeast ? "≥ " : "≤ ", figure.bar);
    }
    std::printf("%-34s %8d %12.2f %-4s %10s  %s\n", figure.name.c_str(), figure.n, figure.value, figure.unit.c_str(),
                bar, misses ? "missed" : "");
    std::fflush(stdout);
}

} // namespace

int main(int count, char** arguments) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(count, arguments);
    const std::optional<Request> asked = request(QCoreApplication::arguments());
    if (!asked) {
        std::fprintf(stderr, "Usage: sandbox_bench [--json FILE] [--cpu] [runs] [reach] [time] [window] [edits]\n");
        return 2;
    }
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    std::printf("%-34s %8s %12s %-4s %8s\n", "figure", "n", "value", "unit", "bar");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    const auto report = [&rows](const SandboxFigure& figure) {
        printFigure(figure);
        nlohmann::ordered_json row;
        row["name"] = figure.name;
        row["n"] = figure.n;
        row["value"] = figure.value;
        row["unit"] = figure.unit;
        rows.push_back(std::move(row));
    };
    const Meter meter{report, asked->cpu};
    for (const Part& part : asked->parts.empty() ? std::span<const Part>(allParts) : asked->parts) {
        part.measure(meter);
    }
    if (asked->file.empty()) {
        return 0;
    }
    std::ofstream file(asked->file);
    file << rows.dump(2) << '\n';
    return file.good() ? 0 : 1;
}
