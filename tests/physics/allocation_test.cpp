// An update of a world that has found its pace asks for no memory.

#include "core/physics/query/world_bytes.h"
#include "core/physics/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/scenes.h"
#include "tests/support/test_main.h"

#include <new>

using namespace spacetow;
using namespace spacetow::test;

class AllocationTest : public QObject {
    Q_OBJECT

  private slots:
    void allocationsAreCounted() {
        const std::uint64_t before = allocationCount();
        ::operator delete(::operator new(16));
        ::operator delete (::operator new (64, std::align_val_t{32}), std::align_val_t{32});
        QCOMPARE(allocationCount() - before, std::uint64_t{2});
    }

    void theFirstUpdateAllocates() {
        World world = worldOf(*makeScene("balls", 100));
        const std::uint64_t before = allocationCount();
        world.update();
        QVERIFY(allocationCount() > before);
    }

    void theBytesOfACopyAreEstimated() {
        for (const auto& [scene, n] : {std::pair("balls", 600), {"pyramid", 20}, {"cave", 4000}, {"mesh", 10}}) {
            World world = worldOf(*makeScene(scene, n));
            for (int i = 0; i < 100; ++i) {
                world.update();
            }
            const std::uint64_t before = allocatedBytes();
            const World copy(world);
            const double ratio = static_cast<double>(copyBytes(world)) / static_cast<double>(allocatedBytes() - before);
            QVERIFY2(ratio > 0.75 && ratio < 1.25, qPrintable(QString("%1: %2").arg(scene).arg(ratio)));
        }
    }

    void aSteadyUpdateAllocatesNothing_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("warmUp");
        QTest::newRow("balls") << 300 << 300;
        QTest::newRow("pyramid") << 12 << 100;
        QTest::newRow("cave") << 4000 << 150;
        QTest::newRow("tumbler") << 100 << 900; // one turn of the frame
        QTest::newRow("tow") << 1 << 300;
        QTest::newRow("mesh") << 10 << 300;
    }
    void aSteadyUpdateAllocatesNothing() {
        QFETCH(int, n);
        QFETCH(int, warmUp);
        World world = worldOf(*makeScene(QTest::currentDataTag(), n));
        const std::uint64_t atFirst = world.hash();
        for (int i = 0; i < warmUp; ++i) {
            world.update();
        }
        for (int i = 0; i < 100; ++i) {
            const std::uint64_t before = allocationCount();
            world.update();
            const std::uint64_t allocations = allocationCount() - before;
            QVERIFY2(allocations == 0, qPrintable(QString("%1 in update %2").arg(allocations).arg(warmUp + i)));
        }
        QVERIFY(world.hash() != atFirst); // the updates did something
    }
};

SPACETOW_TEST(AllocationTest)
#include "allocation_test.moc"
