#include "editor/canvas/start_session.h"

#include "core/level/edits.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <QSignalSpy>

using namespace spacetow;
using namespace spacetow::test;

class StartSessionTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingIsMadeBeforeItIsWanted() {
        Document document(openSpace());
        StartSession start(document);
        start.finish();
        QVERIFY(start.latest() == nullptr);
        start.want();
        start.finish();
        QVERIFY(start.isCurrent());
        QCOMPARE(start.latest()->hash(), Session(openSpace()).hash());
    }

    void itFollowsEditsForAsLongAsItIsWanted() {
        Document document(openSpace());
        StartSession start(document);
        const QSignalSpy changes(&start, &StartSession::changed);
        start.want();
        start.finish();
        QCOMPARE(changes.count(), 1);
        const std::shared_ptr<const Session> first = start.latest();
        const Level edited = moved(document.level(), std::vector<Key>{document.level().objects[0].key}, Vec2(1, 0));
        document.reset(edited);
        QVERIFY(start.latest() == first && !start.isCurrent()); // until the new one is ready
        start.finish();
        QCOMPARE(start.latest()->hash(), Session(edited).hash());
        QCOMPARE(changes.count(), 2);
        start.release();
        document.reset(openSpace());
        start.finish();
        QCOMPARE(changes.count(), 2);
    }

    void manyEditsInARowAreMadeOnce() {
        Document document(openSpace());
        StartSession start(document);
        const QSignalSpy changes(&start, &StartSession::changed);
        start.want();
        for (int i = 0; i < 20; ++i) {
            document.reset(moved(document.level(), std::vector<Key>{document.level().objects[0].key}, Vec2(1, 0)));
        }
        start.finish();
        QVERIFY(start.isCurrent());
        QVERIFY(changes.count() <= 2);
    }
};

SPACETOW_TEST(StartSessionTest)
#include "start_session_test.moc"
