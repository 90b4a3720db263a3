#pragma once
// What the window takes for the things that people do all day, on one large level.

#include "tests/bench/large_levels.h"

#include <functional>
#include <string>

namespace spacetow::bench {

struct Figure {
    std::string name; // as in pan.median
    double value;
    std::string unit; // ms, MB
    double bar;       // what it should not exceed; 0 for figures without a bar
};

struct Subject {
    LargeLevel level;
    int edges;
    bool cpu; // time of the processor in the thread of the window, instead of the clock on the wall
};

/// Needs a QApplication. `report` is called as figures come about.
void timeEditor(const Subject& subject, const std::function<void(const Figure&)>& report);

/// The memory of a window for each of two such levels.
void measureWindows(const Subject& subject, const std::function<void(const Figure&)>& report);

} // namespace spacetow::bench
