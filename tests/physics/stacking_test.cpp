#include "tests/support/contact_scenes.h"

#include <utility>
#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Boxes of 1 m that should stay where they were put.
struct Pile {
    World world;
    std::vector<std::pair<BodyId, Vec2>> boxes;

    Pile(int iterations, const QString& floor) : world(withIterations(iterations)) {
        BodyDef ground = floorOf(floor);
        ground.friction = 0.6;
        add(world, ground);
    }

    void put(const Vec2& at) {
        BodyDef def = box(at, 0.5, 0.5);
        def.friction = 0.6;
        boxes.emplace_back(add(world, def), at);
    }

    /// Runs it; once settled, no box may ever have moved by more than 2 % of its size.
    void verifyStands(double seconds, double settling) {
        run(world, settling);
        for (int i = 0; i < std::lround((seconds - settling) / 0.02); ++i) {
            world.update();
            for (const auto& [id, at] : boxes) {
                const double moved = (world.body(id).massCenter - at).norm();
                QVERIFY2(moved < 0.02, qPrintable(QString("update %1: the box of (%2, %3) moved by %4")
                                                      .arg(i)
                                                      .arg(at.x())
                                                      .arg(at.y())
                                                      .arg(moved)));
            }
        }
    }
};

void floorRows() {
    QTest::addColumn<QString>("floor");
    QTest::addColumn<int>("iterations");
    for (const char* floor : floors) {
        for (const int iterations : iterationCounts) {
            QTest::addRow("on %s, %d iterations", floor, iterations) << floor << iterations;
        }
    }
}

} // namespace

class StackingTest : public QObject {
    Q_OBJECT

  private slots:
    void aStackOfTenBoxesStands_data() { floorRows(); }
    void aStackOfTenBoxesStands() {
        QFETCH(QString, floor);
        QFETCH(int, iterations);
        Pile pile(iterations, floor);
        for (int i = 0; i < 10; ++i) {
            pile.put({0, 0.5 + i});
        }
        pile.verifyStands(fullOrQuick(60, 10), 0);
    }

    void aTowerHardlyOutOfLineStands_data() {
        QTest::addColumn<bool>("hexagons");
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("boxes, %d iterations", iterations) << false << iterations;
            QTest::addRow("hexagons, %d iterations", iterations) << true << iterations;
        }
    }
    void aTowerHardlyOutOfLineStands() {
        QFETCH(bool, hexagons);
        QFETCH(int, iterations);
        for (const double aside : {0.0, 1e-12, 1e-9, 1e-6}) {
            World world(withIterations(iterations));
            BodyDef ground = floorOf("edge");
            ground.friction = 0.5;
            add(world, ground);
            std::vector<std::pair<BodyId, Vec2>> tower;
            const double half = hexagons ? 0.25 * std::sqrt(0.75) : 0.26;
            for (int i = 0; i < 15; ++i) {
                BodyDef def = hexagons ? hexagon({0, 0}) : box({0, 0}, 0.15, 0.26);
                def.angle = hexagons ? pi / 6 : 0;
                def.friction = 0.5;
                def.position = {i % 2 == 1 ? -aside : 0, half + 0.001 + i * (2 * half + 0.001)};
                tower.emplace_back(add(world, def), Vec2(def.position.x(), half + 2 * half * i));
            }
            for (int i = 0; i < fullOrQuick(1500, 250); ++i) {
                world.update();
            }
            for (const auto& [id, at] : tower) {
                QVERIFY2((world.body(id).massCenter - at).norm() < 0.01, qPrintable(QString("%1 m aside").arg(aside)));
            }
        }
    }

    void aPyramidOfTwentyRowsStands_data() { iterationRows(); }
    void aPyramidOfTwentyRowsStands() {
        QFETCH(int, iterations);
        Pile pile(iterations, "edge");
        for (int row = 0; row < 20; ++row) {
            for (int column = row; column < 20; ++column) {
                pile.put({1.1 * (column - row) + 0.55 * row - 11, 0.5 + row});
            }
        }
        // Four iterations need a moment until all the weight of twenty rows is carried.
        pile.verifyStands(fullOrQuick(30, iterations == 100 ? 1 : 5), iterations == 4 ? 1 : 0);
    }
};

SPACETOW_TEST(StackingTest)
#include "stacking_test.moc"
