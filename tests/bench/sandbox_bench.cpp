// Times the sandbox: sandbox_bench [--json FILE]. Each figure is printed beside its bar.

#include "tests/bench/sandbox_figures.h"

#include <QApplication>
#include <QStyleFactory>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

using namespace spacetow::bench;

namespace {

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
    const QStringList words = QCoreApplication::arguments();
    if (words.size() != 1 && !(words.size() == 3 && words[1] == QStringLiteral("--json"))) {
        std::fprintf(stderr, "Usage: sandbox_bench [--json FILE]\n");
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
    measureRuns(report);
    measureTime(report);
    if (words.size() == 1) {
        return 0;
    }
    std::ofstream file(words[2].toStdString());
    file << rows.dump(2) << '\n';
    return file.good() ? 0 : 1;
}
