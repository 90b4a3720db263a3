#include "core/game/plot_history.h"

#include "core/game/runner.h"
#include "core/physics/query/explain.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <set>
#include <string_view>

using namespace spacetow;

namespace {

/// A ball that falls, and one on a spring.
Level plottedLevel() {
    Level level;
    level.gravity = {0, -10};
    level.iterations = 4;
    for (const Key key : {Key{1}, Key{2}, Key{3}}) {
        BodyObject made;
        made.kind = key == 3 ? BodyKind::Static : BodyKind::Dynamic;
        made.shapes = {Circle{{0, 0}, 0.2}};
        made.position = {3.0 * key, 0};
        made.mass = 2;
        level.objects.append({key, {}, made, {}});
    }
    level.objects.append({4, {}, ConnectorObject{.a = 2, .b = 3, .stiffness = 10}, {}});
    return level;
}

std::vector<PlotSource> someSources() {
    return {
        {1, PlotQuantity::Y}, {4, PlotQuantity::Tension}, {0, PlotQuantity::Energy}, {0, PlotQuantity::EnergyDrift}};
}

void stepAndSample(Session& session, PlotHistory& history, int updates) {
    for (int i = 0; i < updates; ++i) {
        session.step(Controls{});
        history.sample(session);
    }
}

} // namespace

class PlotHistoryTest : public QObject {
    Q_OBJECT

  private slots:
    void curvesAreWhatTheSessionWas() {
        Session session(plottedLevel());
        PlotHistory history;
        history.watch(someSources());
        for (int i = 0; i < 50; ++i) {
            session.step(Controls{});
            history.sample(session);
            QCOMPARE(history.size(), std::size_t(i + 1));
            QVERIFY(std::abs(history.seconds().back() - 0.02 * (i + 1)) < 1e-12);
            QCOMPARE(history.column(0).back(), session.world().body(*session.bodyOf(1)).pose.position.y());
            QCOMPARE(history.column(1).back(), session.world().connector(*session.connectorOf(4)).tension);
            QCOMPARE(history.column(2).back(), totals(session.world()).energy());
            QVERIFY(std::abs(history.column(3).back()) < 1); // percent
        }
        const double t = history.seconds()[30];
        QVERIFY(std::abs(history.column(0)[30] + 5 * t * t) < 1e-6);
    }

    void aNewCurveBeginsNowAndOthersKeepWhatTheyHave() {
        Session session(plottedLevel());
        PlotHistory history;
        history.watch({{1, PlotQuantity::Y}});
        stepAndSample(session, history, 10);
        history.watch({{0, PlotQuantity::Kinetic}, {1, PlotQuantity::Y}});
        QVERIFY(std::isnan(history.column(0)[3]));
        QVERIFY(!std::isnan(history.column(1)[3]));
        stepAndSample(session, history, 1);
        QVERIFY(!std::isnan(history.column(0).back()));
    }

    void whatIsRewoundStaysAndAnotherFutureTakesItsPlace() {
        Session session(plottedLevel());
        PlotHistory history;
        history.watch(someSources());
        std::vector<Session> moments;
        for (int i = 0; i < 40; ++i) {
            moments.push_back(session);
            stepAndSample(session, history, 1);
        }
        const std::vector<double> before = history.column(0);
        history.sample(moments[20]); // scrubbed
        QVERIFY(history.column(0) == before);
        QVERIFY(std::abs(history.shownSeconds() - 0.4) < 1e-12);
        Session again = moments[20];
        stepAndSample(again, history, 5); // the same once more
        QVERIFY(history.column(0) == before);
        Level lighter = plottedLevel();
        lighter.gravity = {0, 5};
        Session other = moments[20];
        other.step(StepInput{{}, {}, std::make_shared<const Level>(lighter)});
        history.sample(other);
        QCOMPARE(history.size(), std::size_t(21));
        QVERIFY(history.column(0).back() > before[20]);
    }

    void anHourTakesNoMoreRoomThanTwoMinutes() {
        Level level = plottedLevel();
        level.gravity = {0, 0};
        level.iterations = 1;
        Session session(level);
        PlotHistory history;
        history.watch({{1, PlotQuantity::X}});
        std::size_t most = 0;
        for (int i = 0; i < 50 * 60 * 12; ++i) {
            session.step(Controls{});
            history.sample(session);
            most = std::max(most, history.size());
        }
        QVERIFY(most <= 3001 + PlotHistory::mostOlder + 1);
        QVERIFY(history.seconds().front() < 0.1);
        QVERIFY(std::is_sorted(history.seconds().begin(), history.seconds().end()));
        const std::vector<double>& seconds = history.seconds();
        for (std::size_t i = seconds.size() - 2900; i < seconds.size(); ++i) {
            QVERIFY(seconds[i] - seconds[i - 1] < 0.021); // the last minute is whole
        }
    }

    void driftIsThatOfEnergyAndMomentum() {
        Level level = plottedLevel();
        level.gravity = {0, 0};
        auto body = level.objects[0];
        std::get<BodyObject>(body.data).velocity = {3, 0};
        std::get<BodyObject>(body.data).linearDamping = 1;
        level.objects.replace(0, body);
        Session session(level);
        PlotHistory history;
        history.watch({{0, PlotQuantity::MomentumDrift}, {0, PlotQuantity::EnergyDrift}});
        history.sample(session);
        stepAndSample(session, history, 50);
        const double share = std::exp(-1.0);
        QVERIFY(std::abs(*history.momentumDrift() - (1 - share)) < 1e-3);
        QVERIFY(std::abs(*history.energyDrift() - (share * share - 1)) < 1e-3);
        const double energy = totals(session.world()).energy();
        QVERIFY(std::abs(*history.energyChange() - energy * (1 - 1 / (share * share))) < 0.01 * energy);
        QVERIFY(std::abs(history.column(0).back() - 100 * (1 - share)) < 0.1);
    }

    void everyQuantityHasASubjectAndAUnit() {
        Session session(plottedLevel());
        session.step(Controls{});
        std::set<PlotQuantity> all;
        for (const auto& [subject, key] : {std::pair(PlotSubject::World, Key(0)), std::pair(PlotSubject::Body, Key(1)),
                                           std::pair(PlotSubject::Connector, Key(4))}) {
            QVERIFY(subjectOf(session, key) == subject);
            for (const PlotQuantity quantity : quantitiesOf(subject)) {
                QVERIFY(subjectOf(quantity) == subject);
                QVERIFY(*unitOf(quantity) != 0);
                const bool drift = std::string_view(unitOf(quantity)) == "%";
                QVERIFY(plotted(session, {key, quantity}).has_value() != drift);
                QVERIFY(all.insert(quantity).second);
            }
        }
        QCOMPARE(all.size(), std::size_t(plotQuantityCount));
        QVERIFY(!subjectOf(session, 99) && !plotted(session, {99, PlotQuantity::X}));
    }

    void theTableIsWrittenWithCommas() {
        Session session(plottedLevel());
        PlotHistory history;
        history.watch({{1, PlotQuantity::X}, {99, PlotQuantity::X}});
        stepAndSample(session, history, 2);
        QCOMPARE(history.csv({"x", "a \"b\", c"}), std::string("s,x,\"a \"\"b\"\", c\"\n0.02,3,\n0.04,3,\n"));
    }

    void stagesOfARunAreTimedWhereThatIsWanted() {
        Runner runner(plottedLevel(), Runner::Mode::Manual);
        runner.advance(3);
        QVERIFY(runner.frame()->profile == nullptr);
        runner.wantProfile(true);
        QVERIFY(runner.frame()->profile != nullptr);
        QCOMPARE(runner.frame()->profile->size(), std::size_t(0));
        runner.advance(5);
        const StepProfile& profile = *runner.frame()->profile;
        QCOMPARE(profile.size(), std::size_t(5));
        QVERIFY(profile.together().maximum > 0);
        QVERIFY(profile.of(StepStage::Motion).average <= profile.together().average);
        runner.wantProfile(false);
        QVERIFY(runner.frame()->profile == nullptr);
    }

    void aProfileKeepsTheLastUpdates() {
        StepProfile profile;
        for (int i = 1; i <= 300; ++i) {
            StepProfile::Stages stages{};
            stages[2] = static_cast<float>(i);
            stages[4] = 1;
            profile.note(stages);
        }
        QCOMPARE(profile.size(), StepProfile::kept);
        QCOMPARE(profile.of(StepStage::Pairs).now, 300.0);
        QCOMPARE(profile.of(StepStage::Pairs).maximum, 300.0);
        QVERIFY(std::abs(profile.of(StepStage::Pairs).average - (300 - 124.5)) < 1e-6);
        QCOMPARE(profile.together().now, 301.0);
        QCOMPARE(profile.history().front()[2], 51.0F);
        QCOMPARE(profile.history().back()[2], 300.0F);
    }

    void anImpactIsKnownWhenSessionsAreWanted() {
        Level level = plottedLevel();
        BodyObject floor;
        floor.shapes = {EdgeChain{{{-20, -0.2}, {20, -0.2}}}};
        level.objects.append({9, {}, floor, {}});
        Runner runner(level, Runner::Mode::Manual);
        runner.wantSession(true);
        runner.advance(20);
        const Session& session = *runner.frame()->session;
        QVERIFY(session.world().recordsImpulses());
        const BodyId ball = *session.bodyOf(1);
        QVERIFY(std::abs(explained(session.world(), ball).forces.contacts.force.y() - 20) < 0.1);
        runner.restart();
        runner.advance(20);
        QVERIFY(runner.frame()->session->world().recordsImpulses());
    }
};

SPACETOW_TEST(PlotHistoryTest)
#include "plot_history_test.moc"
