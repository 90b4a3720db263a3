#include "editor/exchange/flatten.h"

#include "core/base/overloaded.h"
#include "core/math/rot.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// A chord over a step of the parameter strays by at most step² / 8 times the greatest second derivative.
int stepsFor(double range, double secondDerivative, double tolerance) {
    const double steps = std::ceil(range * std::sqrt(secondDerivative / (8 * tolerance)));
    constexpr double most = 1e9;
    return static_cast<int>(steps <= most ? std::max(steps, 1.0) : most); // many, if it is not a number
}

class Flattener {
  public:
    Flattener(double tolerance, int most) : m_tolerance(tolerance), m_most(most) {}

    std::vector<Vec2> points;
    bool isTooMuch = false;

    void add(const LinePiece& line) {
        points.push_back(line.to);
        isTooMuch = isTooMuch || static_cast<int>(points.size()) > m_most;
    }

    void add(const CubicPiece& cubic) {
        const Vec2 from = points.back();
        const double bend = 6 * std::max((from - 2 * cubic.control1 + cubic.control2).norm(),
                                         (cubic.control1 - 2 * cubic.control2 + cubic.to).norm());
        const int steps = affordable(stepsFor(1, bend, m_tolerance));
        for (int i = 1; i < steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            const double s = 1 - t;
            points.emplace_back(s * s * s * from + 3 * s * s * t * cubic.control1 + 3 * s * t * t * cubic.control2 +
                                t * t * t * cubic.to);
        }
        points.push_back(cubic.to);
    }

    void add(const ArcPiece& arc) {
        // The longest half axis bounds the second derivative.
        const double a = arc.u.squaredNorm();
        const double b = arc.v.squaredNorm();
        const double c = arc.u.dot(arc.v);
        const double longest = std::sqrt((a + b) / 2 + std::hypot((a - b) / 2, c));
        constexpr int fewest = 3; // of a whole turn there is something left however coarse it is
        const double turns = std::abs(arc.sweep) / 6.283185307179586;
        const int least = static_cast<int>(std::ceil(fewest * turns - 1e-9));
        const int steps = affordable(std::max(least, stepsFor(std::abs(arc.sweep), longest, m_tolerance)));
        for (int i = 1; i < steps; ++i) {
            const Rot at = Rot::fromAngle(arc.from + arc.sweep * i / steps);
            points.emplace_back(arc.center + at.c * arc.u + at.s * arc.v);
        }
        points.push_back(arc.to);
    }

  private:
    int affordable(int steps) {
        isTooMuch = isTooMuch || steps > m_most - static_cast<int>(points.size());
        return isTooMuch ? 1 : steps;
    }

    double m_tolerance;
    int m_most;
};

} // namespace

std::optional<std::vector<Vec2>> flattened(const DrawnPath& path, double tolerance, int most) {
    Flattener flattener(tolerance, most);
    flattener.points.push_back(path.start);
    for (const PathPiece& piece : path.pieces) {
        std::visit([&flattener](const auto& one) { flattener.add(one); }, piece);
    }
    return flattener.isTooMuch ? std::nullopt : std::optional(std::move(flattener.points));
}

} // namespace spacetow
