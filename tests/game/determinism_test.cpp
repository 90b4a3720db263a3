#include "core/game/session.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A box to crash in, with a ball that gets about.
Level box() {
    Level level = openSpace();
    level.gravity = Vec2(0, -0.95);
    addWall(level, Vec2(-3, -3), Vec2(3, -3));
    addWall(level, Vec2(3, -3), Vec2(3, 3));
    addWall(level, Vec2(3, 3), Vec2(-3, 3));
    addWall(level, Vec2(-3, 3), Vec2(-3, -3));
    addBall(level, Vec2(-2, 1), 0.3, Vec2(1, 0));
    return level;
}

std::vector<Controls> mashing(std::uint64_t seed, int updates) {
    Random random(seed);
    std::vector<Controls> keys;
    while (static_cast<int>(keys.size()) < updates) {
        const auto bits = static_cast<std::uint8_t>(random.below(16));
        keys.insert(keys.end(), 1 + random.below(15), controlsFromBits(bits));
    }
    return keys;
}

} // namespace

class DeterminismTest : public QObject {
    Q_OBJECT

  private slots:
    void equalControlsGiveEqualGames() {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Session one(box(), seed), other(box(), seed);
            for (const Controls& keys : mashing(seed, 1500)) {
                one.step(keys);
                other.step(keys);
            }
            QVERIFY2(one.hash() == other.hash(), qPrintable(QString("seed %1").arg(seed)));
        }
    }
    void aCopyGoesOnLikeTheOriginalFromAnyUpdate() {
        const std::vector<Controls> keys = mashing(8, 1200);
        Session original(box(), 8);
        std::vector<Session> copies;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (i % 150 == 0) {
                copies.push_back(original);
            }
            original.step(keys[i]);
        }
        for (std::size_t c = 0; c < copies.size(); ++c) {
            QVERIFY(copies[c].hash() != original.hash());
            for (std::size_t i = 150 * c; i < keys.size(); ++i) {
                copies[c].step(keys[i]);
            }
            QVERIFY2(copies[c].hash() == original.hash(), qPrintable(QString("copy at update %1").arg(150 * c)));
            QVERIFY(copies[c].phase() == original.phase());
            QVERIFY(copies[c].camera().position() == original.camera().position());
        }
    }
    void theHashTellsStatesApart() {
        Session one(box()), other(box());
        QCOMPARE(one.hash(), other.hash());
        one.step(left);
        other.step(right);
        QVERIFY(one.hash() != other.hash());
        Session first(box(), 1), second(box(), 2); // their debris will differ
        QVERIFY(first.hash() != second.hash());
    }
    void takingPicturesChangesNothing() {
        Session watched(box()), unwatched(box());
        for (const Controls& keys : mashing(3, 400)) {
            watched.step(keys);
            unwatched.step(keys);
            watched.snapshot();
        }
        QCOMPARE(watched.hash(), unwatched.hash());
    }
    void lifeIsNeverLostTwiceInAnAttemptWhateverIsPressed() {
        for (std::uint64_t seed = 20; seed < 30; ++seed) {
            Session session(box(), seed);
            int lives = session.lives();
            int lost = 0; // in this attempt
            for (const Controls& keys : mashing(seed, 2000)) {
                session.step(keys);
                const bool fresh = session.phase() == Phase::AwaitingInput;
                lost = fresh ? 0 : lost + std::max(0, lives - session.lives());
                QVERIFY2(lost <= 1, qPrintable(QString("seed %1").arg(seed)));
                QVERIFY(session.lives() >= 0);
                QCOMPARE(session.lives() == 0, session.phase() == Phase::GameOver);
                lives = session.lives();
            }
        }
    }
};

SPACETOW_TEST(DeterminismTest)
#include "determinism_test.moc"
