#include "editor/window/bug_capsule.h"

#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/exchange/capsule_text.h"
#include "editor/window/dropped_files.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QClipboard>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>

using namespace spacetow;
using namespace spacetow::test;

namespace {

QString onClipboard() {
    return QGuiApplication::clipboard()->text();
}

void paste(TestWindow& test, const QString& text) {
    QGuiApplication::clipboard()->setText(text);
    test.trigger(Act::Paste);
    test.window->bugCapsule().finish();
}

/// A ball that falls past a wall, held in the run after some updates; the capsule of that is on the clipboard.
struct ReportedRun : TestWindow {
    ReportedRun() {
        Level level = openSpace();
        level.gravity = Vec2(0.3, -1);
        addBall(level, {1, 1}, 0.2, {0.5, 0});
        document().reset(level);
        trigger(Act::Simulate);
    }
    std::int64_t shown() { return window->liveRun().frame()->now->update; }
    void moveBall() {
        Level edited = moved(level(), std::vector<Key>{level().objects[3].key}, {0.5, 0});
        document().commit({"move", 1}, {std::make_shared<const Level>(std::move(edited)), {}});
    }
    QString copied() {
        trigger(Act::CopyCapsule);
        window->bugCapsule().finish();
        return onClipboard();
    }
};

bool leftTheSame(const TestWindow& a, const TestWindow& b) {
    const RunChanges& one = a.window->openLevel()->runChanges;
    const RunChanges& other = b.window->openLevel()->runChanges;
    return one.areWaiting() && other.areWaiting() && one.changes().size() == other.changes().size() &&
           one.before() == other.before() && one.after() == other.after();
}

bool sameBodies(const Snapshot& a, const Snapshot& b) {
    return std::ranges::equal(a.moving, b.moving, [](const BodyPicture& one, const BodyPicture& other) {
        return one.pose.position == other.pose.position && one.velocity == other.velocity;
    });
}

} // namespace

class BugCapsuleTest : public QObject {
    Q_OBJECT

  private slots:
    void pastedIntoAnotherWindowARunIsThereAtTheSameMoment() {
        ReportedRun from;
        QTRY_VERIFY(from.shown() > 5);
        from.moveBall();
        const std::int64_t then = from.shown();
        QTRY_VERIFY(from.shown() > then + 5);
        from.trigger(Act::Pause);
        QTRY_VERIFY(from.window->liveRun().frame()->paused);
        const std::shared_ptr<const Snapshot> moment = from.window->liveRun().frame()->now;
        const QString text = from.copied();
        QVERIFY(text.contains("SPACETOW BUG CAPSULE"));
        QVERIFY(from.window->messageBar().text().contains("clipboard"));
        QCOMPARE(from.shown(), moment->update);

        TestWindow to;
        paste(to, text);
        QVERIFY2(to.window->isPlaying(), qPrintable(to.window->messageBar().text()));
        QVERIFY(to.level().objects.size() == from.level().objects.size());
        QTRY_COMPARE(to.window->liveRun().frame()->now->update, moment->update);
        QVERIFY(to.window->liveRun().isPaused());
        QVERIFY(sameBodies(*to.window->liveRun().frame()->now, *moment));
        to.trigger(Act::Stop);
        from.trigger(Act::Stop);
        QVERIFY(leftTheSame(from, to)); // what was moved there
    }

    void whatWasEditedInTheRunIsThereToBeKept() {
        ReportedRun from;
        const Level start = from.level();
        from.moveBall();
        QTRY_VERIFY(from.shown() > 5);
        from.trigger(Act::Pause);
        QTRY_VERIFY(from.window->liveRun().frame()->paused);
        Level pending = from.level(); // which no update has taken over
        pending.gravity = Vec2(0, 2);
        from.document().commit({"change", 1}, {std::make_shared<const Level>(pending), {}});
        const QString text = from.copied();

        TestWindow to;
        paste(to, text);
        QVERIFY2(to.window->messageBar().text().isEmpty(), qPrintable(to.window->messageBar().text()));
        QTRY_COMPARE(to.window->liveRun().updates(), from.shown());
        QVERIFY(to.level() == pending);
        const std::int64_t next = from.shown() + 1;
        from.trigger(Act::Step);
        to.trigger(Act::Step);
        QTRY_COMPARE(from.shown(), next);
        QTRY_COMPARE(to.window->liveRun().updates(), next);
        QVERIFY(sameBodies(*to.window->liveRun().frame()->now, *from.window->liveRun().frame()->now));
        for (TestWindow* const test : {static_cast<TestWindow*>(&from), &to}) {
            test->trigger(Act::Stop);
            QVERIFY(test->level() == start);
        }
        QVERIFY(leftTheSame(from, to));
        QCOMPARE(to.window->openLevel()->runChanges.changes().size(), std::size_t(2));
        to.window->openLevel()->runChanges.keepAll();
        QVERIFY(to.level() == pending);
    }

    void beganAnewARunThatWasPastedHasItsEdits() {
        ReportedRun from;
        from.moveBall();
        QTRY_VERIFY(from.shown() > 5);
        const Level edited = from.level();
        TestWindow to;
        paste(to, from.copied());
        to.trigger(Act::Restart);
        QTRY_VERIFY(to.window->liveRun().runner()->askRecording()().start != nullptr &&
                    *to.window->liveRun().runner()->askRecording()().start == edited);
    }

    void whatWasNotEditedHasNothingToKeep() {
        ReportedRun from;
        QTRY_VERIFY(from.shown() > 2);
        const QString text = from.copied();
        TestWindow to;
        paste(to, text);
        to.trigger(Act::Stop);
        QVERIFY(!to.window->openLevel()->runChanges.areWaiting());
    }

    void withoutARunItIsTheLevel() {
        TestWindow from;
        from.document().reset(openSpace());
        from.trigger(Act::CopyCapsule);
        from.window->bugCapsule().finish();
        const Result<Capsule> capsule = capsuleFromText(onClipboard().toStdString());
        QVERIFY(bool(capsule));
        QVERIFY(*capsule.value().level == openSpace());
        QCOMPARE(capsule.value().run.updates(), std::int64_t(0));
        QCOMPARE(capsule.value().hash, Session(openSpace()).hash());
        QVERIFY(QString::fromStdString(capsule.value().program).startsWith("SpaceTow Studio"));
    }

    void whatIsCutOrNoCapsuleIsSaidAndNothingElseHappens_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("said");
        QTest::addRow("cut in half") << QStringLiteral("-----END") << QStringLiteral("gone") << QStringLiteral("whole");
        QTest::addRow("edited") << QStringLiteral("A") << QStringLiteral("B") << QStringLiteral("damaged");
        QTest::addRow("no capsule") << QStringLiteral("CAPSULE") << QStringLiteral("") << QStringLiteral("clipboard");
    }
    void whatIsCutOrNoCapsuleIsSaidAndNothingElseHappens() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, said);
        ReportedRun run;
        QTRY_VERIFY(run.shown() > 2);
        const QString text = run.copied();
        TestWindow test;
        test.document().reset(TestWindow::twoBallsAtOneSpot());
        const std::string before = levelText(test.level());
        const int header = text.indexOf("CAPSULE-----") + 12;
        const bool inBody = from == QStringLiteral("A");
        QString other = text;
        if (inBody) {
            other = text.left(header) + text.mid(header).replace(text.indexOf(from, header) - header, 1, to);
        } else {
            other.replace(from, to);
        }
        paste(test, other);
        QVERIFY2(test.window->messageBar().text().contains(said), qPrintable(test.window->messageBar().text()));
        QVERIFY(!test.window->isPlaying());
        QVERIFY(levelText(test.level()) == before);
        QCOMPARE(test.document().historySize(), 0);
    }

    void droppedAsTextItOpensToo() {
        ReportedRun run;
        QTRY_VERIFY(run.shown() > 2);
        const QString text = run.copied();
        TestWindow test;
        QMimeData data;
        data.setText(text);
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(test.window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(test.window.get(), &drop);
        test.window->bugCapsule().finish();
        QVERIFY(test.window->isPlaying());
    }

    void aFileThatHoldsOneOpensLikeAnyOther() {
        ReportedRun run;
        QTRY_VERIFY(run.shown() > 2);
        const QByteArray text = run.copied().toUtf8();
        TestWindow test;
        QFile file(test.file("report.txt"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
        file.close();
        openDropped({file.fileName()}, *test.window);
        test.window->bugCapsule().finish();
        QVERIFY(test.window->isPlaying());
    }

    void whileItsRunIsSimulatedTheWindowSaysHowFarItIsAndItCanBeStopped() {
        Capsule capsule;
        capsule.level = std::make_shared<const Level>(openSpace());
        capsule.run.runs = {{idle, 900'000}}; // five hours
        TestWindow to;
        to.window->bugCapsule().open(capsuleText(capsule).value());
        QVERIFY(to.window->messageBar().text().contains("being read"));
        to.window->bugCapsule().finish();
        QVERIFY(to.window->isPlaying());
        const auto hint = [&] { return to.window->statusLine().hint(); };
        QTRY_VERIFY2(hint().contains("Simulating the run") && !hint().contains(": 0.0 of"), qPrintable(hint()));
        to.trigger(Act::Stop);
        QVERIFY(!to.window->isPlaying());
    }

    void aRunThatComesOutOtherwiseIsSaidToOnceItIsSimulated() {
        Capsule capsule;
        capsule.program = "SpaceTow Studio 0.1";
        capsule.level = std::make_shared<const Level>(openSpace());
        capsule.run.runs = {{thrust, 300}};
        capsule.hash = sessionOf(capsule).hash() + 1;
        TestWindow to;
        paste(to, QString::fromStdString(capsuleText(capsule).value()));
        QTRY_VERIFY(to.window->messageBar().text().contains("SpaceTow Studio 0.1"));
        QCOMPARE(to.window->messageBar().tone(), MessageBar::Tone::Warning);
        to.trigger(Act::Stop);
        capsule.hash = sessionOf(capsule).hash();
        paste(to, QString::fromStdString(capsuleText(capsule).value()));
        QTRY_COMPARE(to.window->liveRun().updates(), std::int64_t(300));
        QVERIFY2(to.window->messageBar().text().isEmpty(), qPrintable(to.window->messageBar().text()));
    }

    void aSimulationOfALevelWithAShipOpensAsASimulation() {
        ReportedRun from;
        QTRY_VERIFY(from.shown() > 2);
        TestWindow to;
        paste(to, from.copied());
        QVERIFY(to.window->isPlaying() && !to.window->isInGame());
        from.trigger(Act::Stop);
        from.trigger(Act::Play);
        QTRY_VERIFY(from.window->isInGame());
        QTest::keyPress(&from.canvas(), Qt::Key_W);
        QTRY_VERIFY(from.shown() > 2);
        paste(to, from.copied());
        QVERIFY(to.window->isInGame());
    }

    void whatIsNotSavedIsNotLostByIt() {
        ReportedRun run;
        QTRY_VERIFY(run.shown() > 2);
        const QString text = run.copied();
        TestWindow test;
        test.drawWalls();
        const Level drawn = test.level();
        paste(test, text); // a window alone has to ask; the answer is Cancel
        QCOMPARE(test.asked, 1);
        QVERIFY(test.level() == drawn);
        QVERIFY(!test.window->isPlaying());
    }
};

SPACETOW_TEST(BugCapsuleTest)
#include "bug_capsule_test.moc"
