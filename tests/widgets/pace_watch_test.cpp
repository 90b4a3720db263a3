#include "editor/play/pace_watch.h"

#include "tests/support/test_main.h"

using namespace spacetow;

namespace {

/// Sixty looks a second at a run that makes so many updates a second, each seen when it has ended.
class WatchedPace {
  public:
    /// The least and the most that was said in this time.
    struct Said {
        double least = 1e9, most = 0; // s
    };
    Said watch(double seconds, double updatesPerSecond, bool paused = false) {
        Said said;
        const double from = m_now;
        const auto first = m_update;
        while (m_now < from + seconds) {
            m_now += 1.0 / 60;
            m_update = first + static_cast<std::int64_t>((m_now - from) * updatesPerSecond);
            const double behind = pace.behind({m_now, m_update, 0.02, paused});
            said = {std::min(said.least, behind), std::max(said.most, behind)};
        }
        return said;
    }
    void leapTo(std::int64_t update) { m_update = update; }

    PaceWatch pace;

  private:
    double m_now = 100; // s
    std::int64_t m_update = 0;
};

} // namespace

class PaceWatchTest : public QObject {
    Q_OBJECT

  private slots:
    void whoKeepsUpIsNeverBehind() {
        WatchedPace run;
        QCOMPARE(run.watch(10, 50).most, 0.0);
        QCOMPARE(run.watch(10, 47).most, 0.0); // hardly behind
    }
    void aRunIsBehindByWhatItHasNotMade() {
        WatchedPace run;
        const double most = run.watch(10.5, 25).most;
        QVERIFY2(most > 4 && most < 6, qPrintable(QString::number(most)));
        run.watch(2.1, 50);
        QCOMPARE(run.watch(5, 50).most, 0.0);  // as long as it keeps up
        QVERIFY(run.watch(3, 25).most > most); // what was lost stays lost
    }
    void aRunWhoseUpdatesTakeLongIsBehindAllTheTime() {
        for (const double perSecond : {2.0, 0.7, 0.3}) {
            WatchedPace run;
            run.watch(2, perSecond);
            QVERIFY(run.watch(8, perSecond).least > 0);
        }
    }
    void timeThatStandsStillIsNotLost() {
        WatchedPace run;
        run.watch(3, 50);
        QCOMPARE(run.watch(5, 0, true).most, 0.0);
        QCOMPARE(run.watch(5, 50).most, 0.0);
        run.watch(5, 10);
        QCOMPARE(run.watch(5, 0, true).most, 0.0);
    }
    void aLeapIsNeitherLostNorWon() {
        WatchedPace run;
        run.watch(3, 50);
        run.leapTo(7);
        QCOMPARE(run.watch(3, 50).most, 0.0);
        run.pace.lookAnew();
        run.leapTo(5000);
        QVERIFY(run.watch(3, 10).most > 0);
    }
};

SPACETOW_TEST(PaceWatchTest)
#include "pace_watch_test.moc"
