// Times the window on large levels: editor_bench [--json FILE] [--cpu] [LEVEL…]. The real window, offscreen, is driven
// by mouse and keys; what a frame takes is the event and the painting that it brings about. Every level has a process
// of its own, so that the memory of one is not that of another.

#include "tests/bench/editor_figures.h"

#include <QApplication>
#include <QProcess>
#include <QStyleFactory>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <optional>

using namespace spacetow;
using namespace spacetow::bench;

namespace {

struct Case {
    const char* name;
    LargeLevel level;
    int edges;
};

constexpr std::array cases{
    Case{"chains-10k", LargeLevel::Chains, 10'000},   Case{"bodies-10k", LargeLevel::Bodies, 10'000},
    Case{"wall-10k", LargeLevel::Wall, 10'000},       Case{"chains-100k", LargeLevel::Chains, 100'000},
    Case{"bodies-100k", LargeLevel::Bodies, 100'000}, Case{"wall-100k", LargeLevel::Wall, 100'000},
    Case{"windows-10k", LargeLevel::Chains, 10'000},
};

struct Request {
    std::string file;
    std::string only; // the one level that this process is to time
    bool cpu = false; // processor time instead of what the clock on the wall says
    std::vector<std::string> levels;
};

/// Nothing when the arguments make no sense.
std::optional<Request> request(const QStringList& arguments) {
    Request result;
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        const std::string word = arguments[i].toStdString();
        const bool more = i + 1 < arguments.size();
        if (word == "--json" && more) {
            result.file = arguments[++i].toStdString();
        } else if (word == "--only" && more) {
            result.only = arguments[++i].toStdString();
        } else if (word == "--cpu") {
            result.cpu = true;
        } else if (std::ranges::find(cases, word, &Case::name) != cases.end()) {
            result.levels.push_back(word);
        } else {
            return std::nullopt;
        }
    }
    if (result.levels.empty()) {
        for (const Case& one : cases) {
            result.levels.emplace_back(one.name);
        }
    }
    return result;
}

/// Times one level and prints a line of JSON for each figure.
int timeOne(const Request& asked) {
    const auto found = std::ranges::find(cases, asked.only, &Case::name);
    if (found == cases.end()) {
        return 2;
    }
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const auto print = [&](const Figure& figure) {
        nlohmann::ordered_json row;
        row["name"] = figure.name + "." + asked.only;
        row["n"] = found->edges;
        row["value"] = figure.value;
        row["unit"] = figure.unit;
        row["bar"] = figure.bar;
        std::printf("%s\n", row.dump().c_str());
        std::fflush(stdout);
    };
    const Subject subject{found->level, found->edges, asked.cpu};
    if (asked.only == "windows-10k") {
        measureWindows(subject, print);
    } else {
        timeEditor(subject, print);
    }
    return 0;
}

void printRow(const nlohmann::ordered_json& row) {
    const double bar = row["bar"];
    const double value = row["value"];
    const std::string unit = row["unit"];
    const std::string name = row["name"];
    const std::string beside = bar > 0 ? std::to_string(std::lround(bar)) : "-";
    std::printf("%-34s %10.2f %-4s %6s  %s\n", name.c_str(), value, unit.c_str(), beside.c_str(),
                bar > 0 && value > bar ? "over" : "");
    std::fflush(stdout);
}

/// The rows that a process of its own has measured on the level; they are printed as they come.
bool measure(const Request& asked, const std::string& level, nlohmann::ordered_json& rows) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    QStringList arguments{QStringLiteral("--only"), QString::fromStdString(level)};
    if (asked.cpu) {
        arguments << QStringLiteral("--cpu");
    }
    process.start(QCoreApplication::applicationFilePath(), arguments);
    while (process.state() != QProcess::NotRunning || process.canReadLine()) {
        if (!process.canReadLine()) {
            process.waitForReadyRead(-1);
        }
        while (process.canReadLine()) {
            auto row = nlohmann::ordered_json::parse(process.readLine().toStdString());
            printRow(row);
            row.erase("bar");
            rows.push_back(std::move(row));
        }
    }
    return process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
}

} // namespace

int main(int count, char** arguments) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(count, arguments);
    const std::optional<Request> asked = request(QCoreApplication::arguments());
    if (!asked) {
        std::fprintf(stderr, "Usage: editor_bench [--json FILE] [--cpu] [LEVEL…]\nwhere LEVEL is one of:");
        for (const Case& one : cases) {
            std::fprintf(stderr, " %s", one.name);
        }
        std::fprintf(stderr, "\n");
        return 2;
    }
    if (!asked->only.empty()) {
        return timeOne(*asked);
    }
    std::printf("%-34s %10s %-4s %6s\n", "figure", "value", "unit", "bar");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool sound = true;
    for (const std::string& level : asked->levels) {
        sound = measure(*asked, level, rows) && sound;
    }
    if (!asked->file.empty()) {
        std::ofstream file(asked->file);
        file << rows.dump(2) << '\n';
        sound = file.good() && sound;
    }
    return sound ? 0 : 1;
}
