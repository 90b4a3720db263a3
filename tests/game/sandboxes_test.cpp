// Each sandbox that comes with the program runs for a minute without a fault, and shows what it says.

#include "core/game/session.h"
#include "core/level/bounds.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int aMinute = 3000; // updates

std::filesystem::path sandboxFolder() {
    return std::filesystem::path(sourceFolder().toStdString()) / "levels" / "sandbox";
}

class SandboxRun {
  public:
    explicit SandboxRun(const std::string& file)
        : m_level(*readLevel(sandboxFolder() / (file + ".json")).value().level), m_session(m_level) {
        for (const Object& object : m_level.objects) {
            m_keys.try_emplace(object.name, object.key);
        }
    }

    const Level& level() const { return m_level; }
    const World& world() const { return m_session.world(); }
    void step() { m_session.step(Controls{}); }
    void pull(const Grab& grab) { m_session.step(StepInput{{}, grab, {}}); }
    /// The body of this name that lies lowest.
    Key lowest(const std::string& name) const {
        Key found = 0;
        for (const Object& object : m_level.objects) {
            if (object.name == name && (found == 0 || body(object.key).massCenter.y() < body(found).massCenter.y())) {
                found = object.key;
            }
        }
        return found;
    }
    void run(int updates) {
        for (int i = 0; i < updates; ++i) {
            step();
        }
    }
    BodyState body(Key key) const { return world().body(*m_session.bodyOf(key)); }
    BodyState body(const std::string& name) const { return body(m_keys.at(name)); }
    BodyState body(const std::string& name, int number) const { return body(name + ' ' + std::to_string(number)); }
    ConnectorState connector(Key key) const { return world().connector(*m_session.connectorOf(key)); }
    ConnectorState connector(const std::string& name) const { return connector(m_keys.at(name)); }
    /// Of the bodies that bear this name.
    std::vector<BodyState> all(const std::string& name) const {
        std::vector<BodyState> states;
        for (const Object& object : m_level.objects) {
            if (object.name == name) {
                states.push_back(body(object.key));
            }
        }
        return states;
    }

  private:
    Level m_level;
    Session m_session;
    std::map<std::string, Key> m_keys; // of the first of each name
};

/// J, of what moves and falls; what is in springs comes on top.
double energyOf(const World& world) {
    double energy = 0;
    for (const BodyId id : world.bodies()) {
        const BodyState body = world.body(id);
        if (body.kind == BodyKind::Dynamic) {
            energy += 0.5 * body.mass * body.velocity.squaredNorm() +
                      0.5 * body.inertia * body.angularVelocity * body.angularVelocity -
                      body.mass * world.parameters().gravity.dot(body.massCenter);
        }
    }
    return energy;
}

double kineticEnergyOf(const World& world) {
    double energy = energyOf(world);
    for (const BodyId id : world.bodies()) {
        const BodyState body = world.body(id);
        energy += body.kind == BodyKind::Dynamic ? body.mass * world.parameters().gravity.dot(body.massCenter) : 0;
    }
    return energy;
}

bool isDriven(const Level& level) {
    for (const Object& object : level.objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr && body->kind == BodyKind::Kinematic) {
            return true;
        }
    }
    return false;
}

/// Of the rooms of the maze in the order in which one comes through them; −1 in a doorway.
int roomOf(const Vec2& at) {
    constexpr double doorway = 0.25; // m: radius of a ball and depth of a door
    const double x = at.x() + 4.5;
    const int column = static_cast<int>(x / 3);
    const double within = x - 3 * column;
    const bool atDoor = (column > 0 && within < doorway) || (column < 2 && within > 3 - doorway);
    if (atDoor || std::abs(at.y()) < doorway) {
        return -1;
    }
    return at.y() > 0 ? column : 5 - column;
}

} // namespace

class SandboxesTest : public QObject {
    Q_OBJECT

  private slots:
    void eachRunsAMinuteWithoutAFault_data() {
        QTest::addColumn<QString>("file");
        for (const auto& entry : std::filesystem::directory_iterator(sandboxFolder())) {
            QTest::addRow("%s", entry.path().stem().c_str()) << QString::fromStdString(entry.path().stem().string());
        }
    }
    void eachRunsAMinuteWithoutAFault() {
        QFETCH(QString, file);
        SandboxRun run(file.toStdString());
        const bool large = run.level().objects.size() > 1000;
        const Aabb room = boundsOf(run.level()).grown(1);
        const double start = energyOf(run.world());
        const bool driven = isDriven(run.level());
        const int updates = large ? fullOrQuick(aMinute, usualOrThin(150, 20)) : usualOrThin(aMinute, 300);
        for (int i = 0; i < updates; ++i) {
            run.step();
            QVERIFY2(run.world().events().faults.empty(), qPrintable(QString("update %1").arg(i)));
            if (i % 10 != 0) {
                continue;
            }
            for (const BodyId id : run.world().bodies()) {
                QVERIFY2(room.contains(run.world().body(id).massCenter), qPrintable(QString("update %1").arg(i)));
            }
            const double energy = energyOf(run.world());
            QVERIFY2(driven ? kineticEnergyOf(run.world()) < 1000 : energy < start + 1e-3 * std::abs(start) + 1e-6,
                     qPrintable(QString("%1 J instead of %2 J in update %3").arg(energy).arg(start).arg(i)));
        }
    }

    void eachSaysWhatToTry() {
        for (const auto& entry : std::filesystem::directory_iterator(sandboxFolder())) {
            const std::string text = readLevel(entry.path()).value().level->description;
            QVERIFY2(text.size() > 40 && text.back() == '.', entry.path().c_str());
        }
    }

    void onlyTheRopeWhoseLimitIsTooLowGives() {
        SandboxRun run("02_pendulum");
        const double length = run.connector("stiff rope").length;
        double stiff = 0, bending = 0, giving = 0;
        for (int i = 0; i < 500; ++i) {
            run.step();
            const auto stretch = [&](const char* name) {
                const ConnectorState rope = run.connector(name);
                return (rope.anchorB - rope.anchorA).norm() - length;
            };
            stiff = std::max(stiff, std::abs(stretch("stiff rope")));
            bending = std::max(bending, std::abs(stretch("bending rope")));
            giving = std::max(giving, stretch("giving rope"));
            QVERIFY(run.connector("bending rope").tension <= 26 + 1e-9);
            QVERIFY(run.connector("giving rope").tension <= 15 + 1e-9);
        }
        QVERIFY2(stiff < 0.01 * length && bending < 0.02 * length, qPrintable(QString::number(bending)));
        QVERIFY2(giving > 0.1 * length, qPrintable(QString::number(giving)));
    }

    void theLastBallOfTheCradleSwings() {
        SandboxRun run("03_newtons_cradle");
        const double rest = run.body("ball", 5).massCenter.y();
        const double raised = run.body("ball", 1).massCenter.y() - rest;
        double highest = 0;
        for (int i = 0; i < 100; ++i) { // until the last one comes back
            run.step();
            highest = std::max(highest, run.body("ball", 5).massCenter.y() - rest);
            for (const int middle : {2, 3, 4}) {
                QVERIFY(std::abs(run.body("ball", middle).massCenter.y() - rest) < 0.05 * raised);
            }
        }
        QVERIFY2(highest > 0.9 * raised, qPrintable(QString("%1 of %2 m").arg(highest).arg(raised)));
    }

    void theMazeLetsThroughOneWayOnly() {
        SandboxRun run("04_one_way_maze");
        std::vector<int> rooms(run.all("ball").size(), 0);
        for (int i = 0; i < aMinute; ++i) {
            run.step();
            const std::vector<BodyState> balls = run.all("ball");
            for (std::size_t k = 0; k < balls.size(); ++k) {
                const int room = roomOf(balls[k].massCenter);
                QVERIFY2(room < 0 || room >= rooms[k], qPrintable(QString("ball %1, update %2").arg(k).arg(i)));
                rooms[k] = std::max(room, rooms[k]);
            }
        }
        QCOMPARE(rooms.size(), std::size_t(30));
        QVERIFY(std::ranges::count(rooms, 5) >= 24);
    }

    void theWheelLiftsItsPassengersAndTheDoorsHandTheBallsOn() {
        SandboxRun run("05_lift_and_doors");
        std::array<double, 7> lowest{}, highest{};
        lowest.fill(100);
        for (int i = 0; i < 1500; ++i) {
            run.step();
            for (const int n : {1, 2, 3, 4, 5, 6}) {
                const Vec2 at = run.body("passenger", n).massCenter;
                const auto slot = static_cast<std::size_t>(n);
                lowest[slot] = std::min(lowest[slot], at.y());
                highest[slot] = std::max(highest[slot], at.y());
                QVERIFY((at - run.body("cabin", n).massCenter).norm() < 0.5);
            }
        }
        for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 6u}) {
            QVERIFY2(highest[n] - lowest[n] > 4, qPrintable(QString::number(highest[n] - lowest[n])));
        }
        for (const int n : {1, 2, 3, 4, 5, 6, 7}) {
            QVERIFY2(run.body("ball", n).massCenter.y() < 1, qPrintable(QString("ball %1").arg(n)));
        }
    }

    void aBallIsLiftedThroughAShelfAndStaysOnIt() {
        SandboxRun run("01_workbench");
        run.run(200);
        const Key ball = run.lowest("ball");
        const Vec2 start = run.body(ball).massCenter;
        for (int i = 0; i <= 400; ++i) { // along the tray below the shelves, then up
            const Vec2 target = i < 200 ? Vec2(start + i / 200.0 * (Vec2(-4.5, 2.2) - start))
                                        : Vec2(-4.5, 2.2 + (i - 200) / 200.0 * 3.4);
            run.pull(Grab{ball, Vec2(0, 0), target});
        }
        run.run(150);
        QVERIFY2(run.body(ball).massCenter.y() > 4.7, qPrintable(QString::number(run.body(ball).massCenter.y())));
    }

    void noBulletGetsThroughAndTheWedgeDrivesTheBlocksApart() {
        SandboxRun run("06_wedge_and_bullets");
        const auto gap = [&run] {
            return run.body("right block").massCenter.x() - run.body("left block").massCenter.x();
        };
        const double before = gap();
        const auto energy = [&run] {
            double sum = 0;
            for (int n = 1; n <= 10; ++n) {
                sum += run.body("bullet", n).velocity.squaredNorm();
            }
            return sum;
        };
        const double atFirst = energy();
        for (int i = 0; i < usualOrThin(500, 60); ++i) {
            run.step();
            for (int n = 1; n <= 10; ++n) {
                const Vec2 at = run.body("bullet", n).massCenter;
                QVERIFY2(at.x() > -7.4 && at.x() < 4.9 && at.y() > 4 && at.y() < 7.2, qPrintable(QString::number(i)));
            }
        }
        QVERIFY2(energy() > 0.2 * atFirst, qPrintable(QString::number(energy() / atFirst))); // there is much to see
        run.run(500);
        QVERIFY2(gap() > before + 0.3, qPrintable(QString::number(gap() - before)));
    }

    void whatIsRougherThanTheSlopeIsSteepHolds() {
        SandboxRun start("07_friction_ramp");
        SandboxRun run("07_friction_ramp");
        run.run(1500);
        for (const char* name : {"0.4", "0.5", "0.8"}) {
            const std::string box = std::string("box of friction ") + name;
            QVERIFY2((run.body(box).massCenter - start.body(box).massCenter).norm() < 0.01, name);
            QVERIFY2(run.body(box).asleep, name);
        }
        for (const char* name : {"0.1", "0.2", "0.3"}) {
            QVERIFY2(run.body(std::string("box of friction ") + name).massCenter.y() < 0.4, name);
        }
    }

    void theDominoesFallToTheLast() {
        SandboxRun run("08_dominoes");
        run.run(1200);
        for (int n = 1; n <= 40; ++n) {
            QVERIFY2(std::abs(run.body("domino", n).angle) > 0.8, qPrintable(QString("domino %1").arg(n)));
        }
    }

    void theClothCatchesTheBalls() {
        SandboxRun run("09_cloth");
        run.run(usualOrThin(600, 200));
        for (const char* name : {"light ball", "middle ball", "heavy ball"}) {
            const Vec2 at = run.body(name).massCenter;
            QVERIFY2(at.y() > 1.5 && std::abs(at.x()) < 4, name);
        }
        int threads = 0;
        for (const Object& object : run.level().objects) {
            if (std::holds_alternative<ConnectorObject>(object.data)) {
                const ConnectorState thread = run.connector(object.key);
                QVERIFY((thread.anchorB - thread.anchorA).norm() < 1.6 * thread.length);
                ++threads;
            }
        }
        QCOMPARE(threads, 20 * 5 + 21 * 4 + 2 * 5);
    }

    void theBallsRunOutOfTheHopper() {
        SandboxRun run("10_two_thousand_balls");
        const int updates = fullOrQuick(aMinute, usualOrThin(150, 20));
        run.run(updates);
        const std::vector<BodyState> balls = run.all("ball");
        QCOMPARE(balls.size(), std::size_t(2000));
        const auto below = std::ranges::count_if(balls, [](const BodyState& b) { return b.massCenter.y() < 5.8; });
        if (!isThinRun()) { // which is over before the first is through
            QVERIFY2(below > (isFullRun() ? 1000 : 50), qPrintable(QString::number(below)));
        }
    }

    void theGearsTurnTogether() {
        SandboxRun run("11_gears");
        double driving = 0, large = 0, small = 0; // rad
        for (int i = 0; i < aMinute; ++i) {
            run.step();
            const double dt = run.level().updateSeconds;
            driving += dt * run.body("driving gear").angularVelocity;
            large += dt * run.body("large gear").angularVelocity;
            small += dt * run.body("small gear").angularVelocity;
        }
        QVERIFY2(std::abs(large + driving / 2) < 0.02 * driving, qPrintable(QString::number(large / driving)));
        QVERIFY2(std::abs(small - driving) < 0.03 * driving, qPrintable(QString::number(small / driving)));
    }
};

SPACETOW_TEST(SandboxesTest)
#include "sandboxes_test.moc"
