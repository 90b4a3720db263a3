#pragma once
// Games in caves, sound and spoiled, for tests of what lint finds and how it is cured.

#include "core/base/random.h"
#include "core/level/lint.h"

#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spacetow::test {

inline Key putObject(Level& level, ObjectData data, const std::string& name = {}) {
    const auto key = static_cast<Key>(level.objects.size() + 1);
    level.objects.append({key, name, std::move(data), {}});
    return key;
}

inline BodyObject bodyOf(LevelShape shape, BodyKind kind = BodyKind::Static) {
    BodyObject body;
    body.kind = kind;
    body.shapes = {std::move(shape)};
    return body;
}

inline EdgeChain edgesOf(std::vector<Vec2> vertices, bool closed = false, double depth = 0.5) {
    return {std::move(vertices), closed, depth};
}

/// A game in a square cave of four walls from (0, 0) to (10, 10), each a body of its own.
inline Level squareCave(double depth = noBack) {
    Level level;
    putObject(level, ShipObject{{2, 5}, 0});
    putObject(level, PayloadObject{{5, 5}, 0.2, 0.25});
    putObject(level, FinishObject{{8, 4}, {8, 6}});
    const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(0, 10)};
    for (std::size_t i = 0; i < 4; ++i) {
        putObject(level, bodyOf(edgesOf({corners[i], corners[(i + 1) % 4]}, false, depth)));
    }
    return level;
}

inline Level withMore(Level level, ObjectData data, const std::string& name = {}) {
    putObject(level, std::move(data), name);
    return level;
}

template <class T, class Change>
inline Level withFirst(Level level, Change change) {
    for (int i = 0; i < level.objects.size(); ++i) {
        Object object = level.objects[i];
        if (auto* data = std::get_if<T>(&object.data)) {
            change(*data);
            level.objects.replace(i, std::move(object));
            break;
        }
    }
    return level;
}

inline Level withWallAt(Level level, std::vector<Vec2> vertices) {
    return withFirst<BodyObject>(std::move(level), [&](BodyObject& body) {
        std::get<EdgeChain>(body.shapes[0]).vertices = std::move(vertices);
    });
}

/// "code@key code@key"; notes are left out unless asked for.
inline QString problemsOf(const Level& level, Severity least = Severity::Warning) {
    QString text;
    for (const Problem& problem : lint(level)) {
        if (problem.severity >= least) {
            text += (text.isEmpty() ? "" : " ") + QString::fromUtf8(problem.code.text());
            text += problem.object != 0 ? "@" + QString::number(problem.object) : QString();
        }
    }
    return text;
}

/// A random cave of one closed chain, cut into bodies at random, with a closed rock in it; all as it should be.
inline Level plainCave(std::uint64_t seed) {
    Random random(seed);
    Level level;
    putObject(level, ShipObject{{3, 0}, 0});
    putObject(level, PayloadObject{{-3, 0}, 0.2, 0.25});
    putObject(level, FinishObject{{0, 4}, {0, 5}});
    const auto ring = [&random](int count, double radius, double rough) {
        std::vector<Vec2> points;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            points.push_back((radius + random.uniform(-rough, rough)) * Vec2(std::cos(angle), std::sin(angle)));
        }
        return points;
    };
    const std::vector<Vec2> cave = ring(24, 9, 1);
    std::size_t from = 0;
    while (from < cave.size()) {
        const std::size_t to = std::min(cave.size(), from + 1 + random.below(6));
        std::vector<Vec2> part(cave.begin() + static_cast<std::ptrdiff_t>(from),
                               cave.begin() + static_cast<std::ptrdiff_t>(to));
        part.push_back(cave[to % cave.size()]);
        putObject(level, bodyOf(edgesOf(std::move(part), false, random.below(2) == 0 ? noBack : 1)));
        from = to;
    }
    std::vector<Vec2> rock = ring(8, 1, 0.2);
    std::ranges::reverse(rock);
    putObject(level, bodyOf(edgesOf(std::move(rock), true, 0.2)));
    putObject(level, bodyOf(Polygon{ring(7, 0.5, 0.1)}));
    return level;
}

inline Level manyRocks(int count) {
    Level level;
    const int columns = static_cast<int>(std::sqrt(count)) + 1;
    for (int i = 0; i < count; ++i) {
        const Vec2 at(4.0 * (i % columns), 4.0 * (i / columns)); // NOLINT(bugprone-integer-division)
        putObject(level, bodyOf(edgesOf({at, at + Vec2(0, 2), at + Vec2(2, 2), at + Vec2(2, 0)}, true, 0.5)));
    }
    return level;
}

} // namespace spacetow::test
