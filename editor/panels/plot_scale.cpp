#include "editor/panels/plot_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spacetow {

PlotRange rangeAround(const std::vector<const std::vector<double>*>& columns, std::size_t first, std::size_t end) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const std::vector<double>* column : columns) {
        for (std::size_t i = first; i < std::min(end, column->size()); ++i) {
            if (std::isfinite((*column)[i])) {
                least = std::min(least, (*column)[i]);
                most = std::max(most, (*column)[i]);
            }
        }
    }
    if (!(least <= most)) {
        return {-1, 1};
    }
    const double room = 0.05 * (most - least);
    const double atLeast = std::max(1e-6, 1e-6 * std::max(std::abs(least), std::abs(most))); // else it is one number
    const double grow = most - least < atLeast ? 0.5 * std::max(1.0, 0.1 * std::abs(most)) : room;
    return {least - grow, most + grow};
}

std::vector<double> roundTicks(const PlotRange& range, int wanted) {
    std::vector<double> ticks;
    if (!(range.size() > 0) || !std::isfinite(range.size()) || wanted < 1) {
        return ticks;
    }
    const double rough = range.size() / wanted;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double factor = rough / power;
    const double step = power * (factor <= 1.5 ? 1 : factor <= 3.5 ? 2 : factor <= 7.5 ? 5 : 10);
    const double first = std::ceil(range.from / step);
    for (int i = 0; i < 4 * wanted + 4 && (first + i) * step <= range.to; ++i) {
        ticks.push_back((first + i) * step + 0.0); // no negative zero
    }
    return ticks;
}

PlotRange zoomed(const PlotRange& range, double share, double factor) {
    const double fixed = range.at(share);
    return {fixed - (fixed - range.from) / factor, fixed + (range.to - fixed) / factor};
}

} // namespace spacetow
