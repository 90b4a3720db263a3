#pragma once
// What makes a level no level, whatever is drawn in it.

#include "core/level/lint.h"

#include <QStringList>

#include <algorithm>
#include <array>

namespace spacetow::test {

/// What no edit may bring about, whatever is drawn.
inline QStringList structuralBreaches(const Level& level) {
    constexpr std::array<LevelCode, 17> structural{"bad-tag-name",
                                                   "chain-too-short",
                                                   "connector-end-missing",
                                                   "connector-end-no-body",
                                                   "duplicate-tag",
                                                   "connector-same-ends",
                                                   "key-taken",
                                                   "layer-in-group",
                                                   "no-shape",
                                                   "not-finite",
                                                   "parent-circle",
                                                   "parent-missing",
                                                   "parent-no-group",
                                                   "polygon-too-few-vertices",
                                                   "several-finishes",
                                                   "several-payloads",
                                                   "several-ships"};
    QStringList codes;
    for (const Problem& problem : lint(level)) {
        if (std::ranges::find(structural, problem.code) != structural.end()) {
            codes << QString::fromUtf8(problem.code.text());
        }
    }
    return codes;
}

} // namespace spacetow::test
