#include "core/game/replay.h"
#include "core/game/thinned_path.h"
#include "core/game/timeline.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/live_level.h"
#include "tests/support/mark_kinds.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const std::filesystem::path cloneRoot(sourceFolder().toStdString());

Level firstHaul() {
    const Result<LevelFile> file = readLevel(cloneRoot / "levels" / "01_first_haul.json");
    EXPECTS(file && file.value().level);
    return *file.value().level;
}

Replay wonFlight() {
    const Result<Replay> replay = readReplay(cloneRoot / "tests" / "replays" / "01_first_haul.replay.json");
    EXPECTS(replay);
    return replay.value();
}

/// A minute: the flight, and the time after it.
std::vector<StepInput> minuteOf(const Replay& replay) {
    std::vector<StepInput> inputs;
    for (const Replay::Run& run : replay.runs) {
        for (std::int64_t i = 0; i < run.count; ++i) {
            inputs.push_back({run.controls, {}, {}});
        }
    }
    inputs.resize(3000);
    return inputs;
}

struct Recorded {
    Timeline timeline;
    Session session;                   // at the end
    std::vector<std::uint64_t> hashes; // by update
};

Recorded recorded(const Session& start, const std::vector<StepInput>& inputs, const Timeline::Limits& limits = {}) {
    Recorded result{Timeline(start, limits), start, {start.hash()}};
    for (const StepInput& input : inputs) {
        result.session.step(input);
        result.timeline.add(input, result.session);
        result.hashes.push_back(result.session.hash());
    }
    return result;
}

/// Looks at every 20th update, in an order that is none.
bool everyMomentIsThat(Recorded& run) {
    Random random(4);
    std::vector<std::int64_t> moments;
    for (std::int64_t update = run.timeline.first(); update <= run.timeline.last(); update += 20) {
        moments.push_back(update);
    }
    for (std::size_t i = moments.size(); i > 1; --i) {
        std::swap(moments[i - 1], moments[random.below(static_cast<std::uint32_t>(i))]);
    }
    return std::ranges::all_of(moments, [&](std::int64_t update) {
        const std::shared_ptr<const Session> there = run.timeline.at(update);
        return there->updates() == update && there->hash() == run.hashes[static_cast<std::size_t>(update)];
    });
}

Level manyBalls(int count) {
    Level level;
    level.gravity = Vec2(0, -10);
    level.iterations = 4;
    addBodyObject(level, floorKey, {.shapes = {LineChain{{{-4, 40}, {-4, 0}, {4, 0}, {4, 40}}, false}}});
    for (int i = 0; i < count; ++i) {
        addBodyObject(level, static_cast<Key>(100 + i), ballAt(Vec2(-3.5 + i % 13 * 0.55, 0.5 + i / 13 * 0.55)));
    }
    return level;
}

} // namespace

class TimelineTest : public QObject {
    Q_OBJECT

  private slots:
    void everyMomentOfAFlightIsThatOfAFreshRun() {
        const Replay flight = wonFlight();
        Recorded run = recorded(Session(firstHaul(), flight.seed), minuteOf(flight));
        QCOMPARE(run.session.phase(), Phase::Won);
        QCOMPARE(run.timeline.first(), std::int64_t(0));
        QVERIFY(everyMomentIsThat(run));
        QVERIFY(run.timeline.bytes() < std::size_t(64) << 20);
        const std::vector<MarkKind> marks = markKinds(run.timeline);
        QVERIFY(std::ranges::count(marks, MarkKind::Tow) == 1);
        QCOMPARE(marks.back(), MarkKind::Win);
        QVERIFY(run.timeline.marks().back().update > 1600);
    }
    void soItIsWithEditsAndHandsInIt() {
        const Replay flight = wonFlight();
        std::vector<StepInput> inputs = minuteOf(flight);
        const Level level = firstHaul();
        const Key ship = firstOf<ShipObject>(level)->key;
        Level edited = level;
        edited.gravity = Vec2(0.1, -0.5);
        inputs[300].level = std::make_shared<const Level>(edited);
        addBodyObject(edited, 999, ballAt(Vec2(0, 3)));
        inputs[700].level = std::make_shared<const Level>(edited);
        for (std::size_t i = 400; i < 460; ++i) {
            inputs[i].grab = Grab{ship, Vec2(0, 0.1), Vec2(1 + 0.01 * static_cast<double>(i), 2)};
        }
        inputs[1500].level = std::make_shared<const Level>(level);
        Recorded run = recorded(Session(level, flight.seed), inputs);
        QVERIFY(everyMomentIsThat(run));
        QCOMPARE(std::ranges::count(markKinds(run.timeline), MarkKind::Edit), std::ptrdiff_t(3));
        QVERIFY(run.timeline.at(450)->grabForce().has_value());
        QVERIFY(run.timeline.at(301)->level().gravity == Vec2(0.1, -0.5));
        QVERIFY(run.timeline.at(300)->level().gravity == level.gravity);
    }
    void goingBackStepByStepIsTheSame() {
        Recorded run = recorded(Session(manyBalls(60)), std::vector<StepInput>(200), {.leastInterval = 40});
        for (std::int64_t update = 199; update >= 0; --update) {
            QCOMPARE(run.timeline.at(update)->hash(), run.hashes[static_cast<std::size_t>(update)]);
            if (update % 7 == 0) {
                for (int k = 0; k < 20 && !run.timeline.prepareBackFrom(update, 10); ++k) {
                }
                QVERIFY(run.timeline.prepareBackFrom(update, 1));
            }
        }
    }
    void aStepBackSimulatesLittle() {
        Recorded run = recorded(Session(manyBalls(60)), std::vector<StepInput>(400), {.leastInterval = 40});
        const auto steps = [&](std::int64_t from, int count) { // each of few updates
            for (int i = 1; i <= count; ++i) {
                const std::int64_t before = run.timeline.updatesTo(from - i);
                if (before > 8) {
                    return false;
                }
                run.timeline.at(from - i);
                while (!run.timeline.prepareBackFrom(from - i, 8)) {
                }
            }
            return true;
        };
        QVERIFY(steps(400, 100)); // from the end, where nothing was prepared
        run.timeline.at(221);
        while (!run.timeline.prepareBackFrom(221, 8)) {
        }
        QVERIFY(steps(221, 100));
    }
    void theBytesStayWithinTheirLimit() {
        const Timeline::Limits limits{.seconds = 4, .bytes = 4 << 20, .leastInterval = 1};
        Recorded run = recorded(Session(manyBalls(150)), std::vector<StepInput>(500), limits);
        const std::size_t each = run.session.copyBytes();
        QVERIFY(each > 50'000);
        QVERIFY(run.timeline.bytes() < limits.bytes + 18 * each);
        QVERIFY(run.timeline.bytes() > limits.bytes / 2); // and are made use of
        QVERIFY(run.timeline.first() <= 300 && run.timeline.first() > 250);
        QVERIFY(everyMomentIsThat(run));
        QVERIFY(run.timeline.bytes() < limits.bytes + 18 * each); // with those that were looked at
    }
    void anHourTakesNoMoreMemoryThanTwoMinutes() {
        Level level;
        level.gravity = Vec2(0, -1);
        level.iterations = 1;
        addBodyObject(level, floorKey, {.shapes = {LineChain{{{-20, 0}, {20, 0}}, false}}});
        BodyObject ball = ballAt(Vec2(0, 2));
        ball.restitution = 1;
        addBodyObject(level, ballKey, ball);
        Session session(level);
        Timeline timeline(session);
        std::size_t after = 0;
        for (int i = 0; i < 180'000; ++i) {
            const StepInput input{{.left = i % 100 == 0}, {}, {}};
            session.step(input);
            timeline.add(input, session);
            after = i == 6'000 ? timeline.bytes() : after;
        }
        QVERIFY(after > 0);
        QVERIFY(timeline.bytes() < after + after / 20);
        QCOMPARE(timeline.last(), std::int64_t(180'000));
        QVERIFY(timeline.first() <= 177'000 && timeline.first() > 176'900);
        QCOMPARE(timeline.at(179'999)->updates(), std::int64_t(179'999));
        QCOMPARE(timeline.at(177'000)->updates(), std::int64_t(177'000));
    }
    void aMinuteOfTinyUpdatesTakesNoMoreRoomForItsPaths() {
        Level level;
        level.gravity = Vec2(0, 0);
        level.iterations = 1;
        level.updateSeconds = 1e-5; // six million in a minute
        addBodyObject(level, ballKey, ballAt(Vec2(0, 2)));
        Tracks tracks;
        Session session(*edited<BodyObject>(level, ballKey, [](BodyObject& ball) { ball.velocity = Vec2(1, 0); }));
        tracks.add(session);
        for (int i = 1; i <= 70'000; ++i) {
            session.step(idle);
            tracks.add(session);
            if (i % 1000 == 0 && i > 10'000) {
                tracks.forgetBefore(i - 60'000);
            }
        }
        QVERIFY(tracks.bytes() <= (Tracks::mostPoints + 1) * sizeof(Vec2));
        const auto ends = [&](std::int64_t from) {
            const std::vector<TracedPath> paths = tracks.pathsFrom(from);
            EXPECTS(paths.size() == 1);
            return Vec2(paths[0].points.front().x(), paths[0].points.back().x());
        };
        QVERIFY2((ends(0) - Vec2(0.1, 0.7)).norm() < 2e-4, qPrintable(QString::number(ends(0).x(), 'g', 9)));
        QVERIFY((ends(30'000) - Vec2(0.3, 0.7)).norm() < 2e-4);
        tracks.forgetAfter(50'001);
        QVERIFY((ends(0) - Vec2(0.1, 0.5)).norm() < 2e-4);
    }
    void bodiesThatAreAddedAreFollowedInPlaceOfThoseThatAreGone() {
        Level level;
        level.gravity = Vec2(0, -1);
        level.iterations = 1;
        for (Key key = 1; key <= Tracks::mostBodies; ++key) {
            addBodyObject(level, key, ballAt(Vec2(2.0 * static_cast<double>(key), 0)));
        }
        addBodyObject(level, 100, ballAt(Vec2(-5, 0)));
        Session session(level);
        Timeline timeline(session);
        const auto go = [&](const StepInput& first) {
            for (int i = 0; i < 100; ++i) {
                const StepInput input = i == 0 ? first : StepInput();
                session.step(input);
                timeline.add(input, session);
            }
        };
        const auto follows = [&](Key key) {
            const std::vector<TracedPath> paths = timeline.pathsFrom(timeline.first());
            return std::ranges::any_of(paths, [key](const TracedPath& path) { return path.object == key; });
        };
        go({});
        QVERIFY(follows(1) && !follows(100)); // there are too many
        Level more = level;
        addBodyObject(more, 101, ballAt(Vec2(-9, 0)));
        go(withLevel(std::make_shared<const Level>(more)));
        QVERIFY(follows(1) && follows(101));                                      // somebody has just added it
        const std::shared_ptr<const Level> fewer = without(*without(more, 1), 2); // 101 has the place of one
        go(withLevel(fewer));
        QVERIFY(follows(100));
        QVERIFY(follows(1)); // of the past
    }
    void theFutureThatIsGivenUpStaysAsAGhost() {
        Recorded run = recorded(Session(openSpace()), std::vector<StepInput>(200, {thrust, {}, {}}));
        QVERIFY(run.timeline.ghosts().empty());
        const Session there = *run.timeline.at(120);
        run.timeline.goOnFrom(there);
        QCOMPARE(run.timeline.last(), std::int64_t(120));
        QCOMPARE(run.timeline.ghosts().size(), std::size_t(1));
        const Ghost& ghost = *run.timeline.ghosts().front();
        QCOMPARE(ghost.from, std::int64_t(120));
        QCOMPARE(ghost.paths.size(), std::size_t(1)); // the payload waited
        QVERIFY(ghost.paths[0].object == shipKey);
        QVERIFY((ghost.paths[0].points.front() - there.ship()->massCenter).norm() < 1e-9);
        QVERIFY((ghost.paths[0].points.back() - run.session.ship()->massCenter).norm() < 1e-9);
        QVERIFY(ghost.paths[0].points.size() < 20); // it was a line

        Session session = there;
        for (int i = 0; i < 100; ++i) {
            session.step(left);
            run.timeline.add({left, {}, {}}, session);
        }
        QCOMPARE(run.timeline.at(170)->updates(), std::int64_t(170));
        Session fresh(openSpace());
        hold(fresh, thrust, 120);
        hold(fresh, left, 50);
        QCOMPARE(run.timeline.at(170)->hash(), fresh.hash());
        run.timeline.at(196); // keeps some on the way
        run.timeline.goOnFrom(*run.timeline.at(150));
        Session other = *run.timeline.at(150);
        for (int i = 0; i < 50; ++i) {
            other.step(right);
            run.timeline.add({right, {}, {}}, other);
        }
        Session again(openSpace());
        hold(again, thrust, 120);
        hold(again, left, 30);
        hold(again, right, 46);
        QCOMPARE(run.timeline.at(196)->hash(), again.hash()); // nothing of the future before
        QVERIFY(run.timeline.input(119).controls == thrust);
        QVERIFY(run.timeline.input(120).controls == left);
    }
    void ofManyBodiesThoseThatWereAddedInTheRunHavePathsToo() {
        const Level level = manyBalls(200);
        Session session(level);
        Timeline timeline(session, {});
        const auto steps = [&](StepInput input) {
            for (int i = 0; i < 5; ++i) {
                session.step(input);
                timeline.add(input, session);
                input.level.reset();
            }
        };
        steps({});
        constexpr Key added = 9000;
        Level more = level;
        addBodyObject(more, added, ballAt(Vec2(0, 30)));
        steps({{}, {}, std::make_shared<const Level>(more)});
        const std::vector<TracedPath> paths = timeline.pathsFrom(0);
        QVERIFY(paths.size() <= Tracks::mostBodies + 1);
        QVERIFY(std::ranges::find(paths, added, &TracedPath::object) != paths.end());
    }
    void anEditAtAMomentSimulatesTheFutureAgain() {
        const Replay flight = wonFlight();
        const std::vector<StepInput> inputs = minuteOf(flight);
        Recorded run = recorded(Session(firstHaul(), flight.seed), inputs);
        Level level = firstHaul();
        level.gravity.y() *= 0.9;
        const auto edited = std::make_shared<const Level>(level);
        const std::shared_ptr<const Session> there = run.timeline.at(500);
        Future future(*there, run.timeline.inputsFrom(500).withLevel(edited));
        run.timeline.goOnFrom(*there);
        QCOMPARE(run.timeline.last(), std::int64_t(500));
        QCOMPARE(future.goal(), std::int64_t(3000));
        while (!future.isDone()) {
            future.advance(run.timeline, 64);
        }
        QCOMPARE(run.timeline.last(), std::int64_t(3000));
        std::vector<StepInput> changed = inputs;
        changed[500].level = edited;
        Recorded fresh = recorded(Session(firstHaul(), flight.seed), changed);
        run.hashes = fresh.hashes;
        QVERIFY(everyMomentIsThat(run));
        QCOMPARE(run.timeline.ghosts().size(), std::size_t(1)); // the old path
        QVERIFY(!run.timeline.pathsFrom(500).empty());          // and the new one
        QVERIFY(future.session().hash() == fresh.session.hash());
    }
    void laterEditsAreInTheNewLevelAlready() {
        std::vector<StepInput> inputs(100);
        inputs[60].level = without(yard(), ballKey);
        Recorded run = recorded(Session(yard()), inputs);
        Level level = *inputs[60].level;
        level.gravity = Vec2(0, -3);
        const std::shared_ptr<const Session> there = run.timeline.at(40);
        Future future(*there, run.timeline.inputsFrom(40).withLevel(std::make_shared<const Level>(level)));
        run.timeline.goOnFrom(*there);
        future.advance(run.timeline, 1000);
        QVERIFY(future.isDone());
        QVERIFY(future.session().level().gravity == Vec2(0, -3));
        QVERIFY(!run.timeline.at(50)->bodyOf(ballKey));
    }
    void aThinnedPathKeepsItsShape() {
        std::vector<Vec2> points;
        for (int i = 0; i <= 100; ++i) {
            points.emplace_back(i * 0.1, i < 50 ? 0 : (i - 50) * 0.1);
        }
        const std::vector<Vec2> corner = thinned(points, 0.01);
        QCOMPARE(corner.size(), std::size_t(3));
        QVERIFY((corner[1] - Vec2(5, 0)).norm() < 0.11);
        QCOMPARE(thinned(std::span(points).first(2), 0.01).size(), std::size_t(2));
        QCOMPARE(thinned(std::vector<Vec2>(50, Vec2(1, 1)), 0.01).size(), std::size_t(2));
    }
};

SPACETOW_TEST(TimelineTest)
#include "timeline_test.moc"
