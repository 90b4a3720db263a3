// Leaks in caves made at random, whole and spoilt, and of discs among walls at random.

#include "core/base/random.h"
#include "core/geometry/intersect.h"
#include "core/level/leak.h"
#include "core/level/leak_paths.h"
#include "tests/support/full_run.h"
#include "tests/support/random_cave.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

bool noneIsWrong(int /*object*/) {
    return false;
}

std::vector<Leak> foundIn(const Level& level) {
    return leaksOf(level, noneIsWrong);
}

bool liesNear(const Vec2& a, const Vec2& b, double metres) {
    return (a - b).norm() <= metres;
}

/// Whether the leak's two places are those, in any order.
bool spans(const Leak& leak, const Vec2& a, const Vec2& b, double metres) {
    return (liesNear(leak.from.at, a, metres) && liesNear(leak.to.at, b, metres)) ||
           (liesNear(leak.from.at, b, metres) && liesNear(leak.to.at, a, metres));
}

bool passesThroughWall(const std::vector<Vec2>& path, const std::vector<LeakWall>& walls) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        for (const LeakWall& wall : walls) {
            const Vec2 along = wall.b - wall.a;
            const double from = cross(along, path[i] - wall.a);
            const double to = cross(along, path[i + 1] - wall.a);
            const double slack = 1e-4 * along.norm();
            const bool crosses = (from > slack && to < -slack) || (!wall.oneWay && from < -slack && to > slack);
            if (crosses && segmentsMeet(path[i], path[i + 1], wall.a, wall.b)) {
                return true;
            }
        }
    }
    return false;
}

/// Whether a leak is there and the piece is said to be to blame for it.
QByteArray faultOf(const RandomCave& cave, std::size_t piece) {
    std::vector<int> objects;
    const Level level = cave.level(&objects);
    const std::vector<Leak> leaks = foundIn(level);
    if (leaks.size() != 1) {
        return QByteArray::number(static_cast<int>(leaks.size())) + " leaks";
    }
    const Leak& leak = leaks.front();
    if (leak.path.size() < 2 || !liesNear(leak.path.front(), cave.ship, 1e-9) ||
        passesThroughWall(leak.path, leakWalls(level, noneIsWrong))) {
        return "a wrong path";
    }
    const CavePiece& spoilt = cave.pieces[piece];
    if (spoilt.isReversed) {
        const bool isNamed = leak.kind == Leak::Kind::Reversed && leak.walls == 1 && leak.isWhole &&
                             leak.from.object == objects[piece] && spans(leak, spoilt.a, spoilt.b, 1e-6);
        return isNamed ? "" : "another wall";
    }
    if (leak.kind != Leak::Kind::Opening) {
        return "not an opening";
    }
    const std::size_t count = cave.pieces.size();
    const int before = objects[(piece + count - 1) % count];
    const int after = objects[(piece + 1) % count];
    const auto isNeighbour = [&](const LeakPlace& place) { return place.object == before || place.object == after; };
    const double metres = (spoilt.b - spoilt.a).norm();
    if ((isNeighbour(leak.from) || isNeighbour(leak.to)) && spans(leak, spoilt.a, spoilt.b, metres)) {
        return "";
    }
    // Where others narrow the opening, what matters is that one has to pass there.
    const Vec2 middle = 0.5 * (spoilt.a + spoilt.b);
    const Vec2 out = std::max(1.5, metres) * leftOf(spoilt.a - spoilt.b).normalized();
    return segmentsMeet(middle - out, middle + out, leak.from.at, leak.to.at) ? "" : "another place";
}

/// Whether a disc gets out between two-sided walls, on a grid of points.
bool escapesOnGrid(const std::vector<LeakWall>& walls, double radius) {
    constexpr int side = 220;
    constexpr double step = 10.0 / side;
    const auto placeOf = [](int x, int y) { return Vec2((x - side / 2) * step, (y - side / 2) * step); };
    std::vector<char> blocked(side * side, 0);
    for (int i = 0; i < side * side; ++i) {
        const Vec2 p = placeOf(i % side, i / side);
        for (const LeakWall& wall : walls) {
            if ((closestOnSegment(wall.a, wall.b, p) - p).norm() < radius) {
                blocked[static_cast<std::size_t>(i)] = 1;
                break;
            }
        }
    }
    std::vector<int> todo{side * side / 2 + side / 2};
    blocked[static_cast<std::size_t>(todo.front())] = 1;
    while (!todo.empty()) {
        const int at = todo.back();
        todo.pop_back();
        if (at % side == 0 || at % side == side - 1 || at < side || at >= side * (side - 1)) {
            return true;
        }
        for (const int next : {at - 1, at + 1, at - side, at + side}) {
            if (blocked[static_cast<std::size_t>(next)] == 0) {
                blocked[static_cast<std::size_t>(next)] = 1;
                todo.push_back(next);
            }
        }
    }
    return false;
}

} // namespace

class LeakRandomTest : public QObject {
    Q_OBJECT

  private slots:
    void closedCavesHaveNoLeakAndSpoiltOnesTheirs() {
        const int caves = fullOrQuick(500, usualOrThin(60, 10));
        int named = 0;
        int spoilt = 0;
        for (int i = 0; i < caves; ++i) {
            const auto seed = static_cast<std::uint64_t>(i + 1);
            RandomCave cave = caveAtRandom(seed);
            QVERIFY2(foundIn(cave.level()).empty(), seedText(seed));
            const int weak = cave.weakPiece(seed);
            if (weak < 0) {
                continue;
            }
            const auto at = static_cast<std::size_t>(weak);
            const bool isEdge = cave.pieces[at].kind == CavePiece::Kind::Edge;
            (isEdge && i % 2 == 0 ? cave.pieces[at].isReversed : cave.pieces[at].isMissing) = true;
            ++spoilt;
            const QByteArray fault = faultOf(cave, at);
            if (!fault.isEmpty()) {
                qInfo("%s: %s", seedText(seed).constData(), fault.constData());
            }
            named += fault.isEmpty() ? 1 : 0;
        }
        QVERIFY2(spoilt > 0.9 * caves, qPrintable(QString("%1 of %2").arg(spoilt).arg(caves)));
        // 1 %; in a quick run that is less than one of them.
        QVERIFY2(spoilt - named <= std::max(1, spoilt / 100), qPrintable(QString("%1 of %2").arg(named).arg(spoilt)));
    }

    void aDiscGetsOutWhereItDoesOnAGrid() {
        const int scenes = fullOrQuick(2000, usualOrThin(60, 10));
        int escapes = 0;
        int stays = 0;
        for (int i = 0; i < scenes; ++i) {
            const auto seed = static_cast<std::uint64_t>(i + 1);
            Random random(seed);
            std::vector<LeakWall> walls;
            for (unsigned k = 15 + random.below(60); k > 0; --k) {
                const Vec2 at(random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5));
                const Vec2 half = 0.5 * random.uniform(0, 2) * Rot::fromAngle(random.uniform(0, 7)).right();
                if (closestOnSegment(at - half, at + half, {0, 0}).norm() > 0.4) {
                    walls.push_back({at - half, at + half});
                }
            }
            constexpr double unsure = 0.035; // m, of the grid
            const double width = random.uniform(0.3, 0.7);
            const LeakMesh mesh(walls, {0, 0}, width, {});
            QVERIFY(mesh.isSound());
            const bool escaped = reachOf(mesh, {}).isOutside;
            if (escapesOnGrid(walls, width / 2 + unsure)) {
                ++escapes;
                QVERIFY2(escaped, seedText(seed));
            } else if (!escapesOnGrid(walls, width / 2 - unsure)) {
                ++stays;
                QVERIFY2(!escaped, seedText(seed));
            }
        }
        QVERIFY(escapes > scenes / 20 && stays > scenes / 20);
    }
};

SPACETOW_TEST(LeakRandomTest)
#include "leak_random_test.moc"
