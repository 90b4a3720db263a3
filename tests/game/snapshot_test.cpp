#include "core/game/blend.h"
#include "core/game/session.h"
#include "tests/support/live_level.h"
#include "tests/support/test_main.h"

#include <map>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level busyLevel() {
    Level level = openSpace();
    addWall(level, Vec2(3, 1), Vec2(-3, 1));
    addBall(level, Vec2(5, 0), 0.3, Vec2(0.5, 0));
    BodyObject mover;
    mover.kind = BodyKind::Kinematic;
    mover.shapes = {Polygon{{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}}};
    mover.position = Vec2(-6, 0);
    mover.angularVelocity = 1;
    level.objects.append({77, "mover", mover, {}});
    return level;
}

} // namespace

class SnapshotTest : public QObject {
    Q_OBJECT

  private slots:
    void bodiesComeByKindThenByAgeWithIdsOfTheirOwn() {
        Session session(busyLevel());
        std::map<std::uint64_t, BodyRole> known;
        for (int i = 0; i < 600; ++i) {
            session.step({.thrust = true, .tow = i % 40 == 0});
            const auto picture = session.snapshot();
            std::set<std::uint64_t> ids;
            const std::vector<BodyPicture> bodies = allBodies(*picture);
            for (std::size_t b = 0; b < bodies.size(); ++b) {
                const BodyLook& look = *bodies[b].look;
                QVERIFY(ids.insert(look.id).second);
                const auto [entry, isNew] = known.emplace(look.id, look.role);
                QVERIFY(entry->second == look.role);
                if (b > 0) {
                    const BodyLook& before = *bodies[b - 1].look;
                    QVERIFY(before.kind < look.kind || (before.kind == look.kind && before.id < look.id));
                }
            }
        }
        QVERIFY(known.size() > 8); // there have been several ships and their debris
    }
    void looksAreSharedBetweenSnapshots() {
        Session session(busyLevel());
        session.step(idle);
        const auto one = session.snapshot();
        session.step(idle);
        const auto other = session.snapshot();
        QCOMPARE(one->moving.size(), other->moving.size());
        for (std::size_t i = 0; i < one->moving.size(); ++i) {
            QVERIFY(one->moving[i].look == other->moving[i].look);
        }
        QVERIFY(one->statics == other->statics);
    }
    void theListOfStaticsStaysTheSameOverANewAttempt() {
        Session session(busyLevel());
        const auto statics = session.snapshot()->statics;
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        hold(session, idle, 20);
        session.step(tow);
        QCOMPARE(session.phase(), Phase::AwaitingInput);
        QVERIFY(session.snapshot()->statics == statics);
    }
    void snapshotsShareOneListOfStaticsUntilOneOfThemIsEdited() {
        Session session(yard());
        const auto before = session.snapshot()->statics;
        QVERIFY(!before->empty());
        session.step(idle);
        session.step(withLevel(edited<BodyObject>(session.level(), boxKey, [](BodyObject& box) { box.mass = 3; })));
        stepOn(session, 5);
        QVERIFY(session.snapshot()->statics == before); // of what stands, nothing has changed
        session.step(withLevel(edited<BodyObject>(session.level(), floorKey, [](BodyObject& floor) {
            floor.position += Vec2(0, -1);
        })));
        const auto after = session.snapshot()->statics;
        QVERIFY(after != before && after->size() == before->size());
        const auto isFloor = [](const BodyPicture& body) { return body.look->key == floorKey; };
        QVERIFY(session.snapshot()->find(isFloor)->pose.position == Vec2(0, -1));
        session.step(withLevel(without(session.level(), floorKey)));
        QVERIFY(session.snapshot()->find(isFloor) == nullptr);
        stepOn(session, 5);
        QCOMPARE(session.snapshot()->bodies(), session.world().bodies().size());
    }
    void aSnapshotSaysWhatThereIs() {
        Session session = towing(busyLevel());
        const auto picture = session.snapshot();
        std::map<BodyRole, Key> keys;
        for (const BodyPicture& body : allBodies(*picture)) {
            keys[body.look->role] = body.look->key;
            QVERIFY(!body.look->shapes.empty());
            QVERIFY(body.look->role != BodyRole::Finish || !body.look->tangible);
        }
        QCOMPARE(keys.at(BodyRole::Ship), shipKey);
        QCOMPARE(keys.at(BodyRole::Payload), payloadKey);
        QCOMPARE(keys.at(BodyRole::Finish), finishKey);
        QVERIFY(keys.contains(BodyRole::Object));
        QCOMPARE(picture->connectors.size(), std::size_t(1));
        QCOMPARE(picture->phase, Phase::Towing);
        QCOMPARE(picture->update, session.updates());
    }
    void blendingGoesStraightFromOnePictureToTheNext() {
        Session session(busyLevel());
        hold(session, {.left = true, .thrust = true}, 20);
        const auto before = session.snapshot();
        session.step({.left = true, .thrust = true});
        const auto now = session.snapshot();
        const Snapshot start = blended(*before, *now, 0), half = blended(*before, *now, 0.5),
                       end = blended(*before, *now, 1);
        for (std::size_t i = 0; i < now->moving.size(); ++i) {
            const Transform &a = before->moving[i].pose, &b = now->moving[i].pose;
            QVERIFY((start.moving[i].pose.position - a.position).norm() < 1e-12);
            QVERIFY((end.moving[i].pose.position - b.position).norm() < 1e-12);
            QVERIFY((half.moving[i].pose.position - 0.5 * (a.position + b.position)).norm() < 1e-12);
            const Rot r = half.moving[i].pose.rotation;
            QVERIFY(std::abs(r.c * r.c + r.s * r.s - 1) < 1e-12);
            QVERIFY(std::abs(r.angle() - (a.rotation.angle() + b.rotation.angle()) / 2) < 1e-6);
        }
    }
    void blendingAcrossANewAttemptLeavesTheNewBodiesWhereTheyAre() {
        Session session(busyLevel());
        QVERIFY(holdUntil(session, thrust, Phase::Crashed));
        hold(session, idle, 20);
        const auto before = session.snapshot();
        session.step(tow);
        const auto now = session.snapshot();
        QCOMPARE(now->phase, Phase::AwaitingInput);
        const Snapshot half = blended(*before, *now, 0.5);
        QVERIFY(half.camera == now->camera);
        for (const BodyPicture& body : half.moving) {
            if (body.look->role == BodyRole::Ship) {
                QVERIFY(body.pose.position == Vec2(0, 0));
            }
        }
    }
};

SPACETOW_TEST(SnapshotTest)
#include "snapshot_test.moc"
