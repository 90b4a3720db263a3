#include "core/game/session_lender.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <thread>

using namespace spacetow;
using namespace spacetow::test;

class SessionLenderTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsGivenBackIsFreedByWhoeverLentIt() {
        const auto level = std::make_shared<const Level>(openSpace());
        const Session session(level);
        SessionLender lender;
        const long before = level.use_count();
        std::shared_ptr<const Session> copy = lender.copyOf(session);
        QCOMPARE(copy->hash(), session.hash());
        QCOMPARE(level.use_count(), before + 1);
        lender.collect(); // it is still being looked at
        QCOMPARE(level.use_count(), before + 1);
        copy.reset();
        QCOMPARE(level.use_count(), before + 1);
        lender.collect();
        QCOMPARE(level.use_count(), before);
    }
    void copiesOutliveTheLender() {
        const auto level = std::make_shared<const Level>(openSpace());
        const long before = level.use_count();
        std::shared_ptr<const Session> copy;
        {
            SessionLender lender;
            copy = lender.copyOf(Session(level));
        }
        QCOMPARE(copy->updates(), std::int64_t(0));
        copy.reset();
        QCOMPARE(level.use_count(), before);
    }
    void copiesAreGivenBackWhileOthersAreLent() {
        const auto level = std::make_shared<const Level>(openSpace());
        const long before = level.use_count();
        const Session session(level);
        SessionLender lender;
        std::vector<std::shared_ptr<const Session>> held;
        for (int i = 0; i < 200; ++i) {
            held.push_back(lender.copyOf(session));
            std::jthread other([copies = std::exchange(held, {})]() mutable { copies.clear(); });
            held.push_back(lender.copyOf(session));
            lender.collect();
        }
        held.clear();
        lender.collect();
        QCOMPARE(level.use_count(), before + 1);
    }
};

SPACETOW_TEST(SessionLenderTest)
#include "session_lender_test.moc"
