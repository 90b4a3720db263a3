#pragma once
// Ranges of numbers along the axes of plots, and the round numbers that stand beside them.

#include <vector>

namespace spacetow {

struct PlotRange {
    double from = 0;
    double to = 1;

    double size() const { return to - from; }
    /// 0 at the beginning, 1 at the end.
    double share(double value) const { return (value - from) / size(); }
    double at(double share) const { return from + share * size(); }
    bool operator==(const PlotRange&) const = default;
};

/// Around all numbers that are finite, with a little room; around 0 when there are none, and never without a size.
PlotRange rangeAround(const std::vector<const std::vector<double>*>& columns, std::size_t first, std::size_t end);

/// Round numbers within the range, about `wanted` of them: steps of 1, 2 or 5 times a power of ten.
std::vector<double> roundTicks(const PlotRange& range, int wanted);

/// With the number at `share` staying where it is.
PlotRange zoomed(const PlotRange& range, double share, double factor);

} // namespace spacetow
