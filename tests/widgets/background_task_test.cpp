#include "editor/canvas/background_task.h"

#include "tests/support/test_main.h"

#include <QThread>

#include <atomic>
#include <new>
#include <stdexcept>

using namespace spacetow;

class BackgroundTaskTest : public QObject {
    Q_OBJECT

  private slots:
    void theResultComesBackToTheThreadThatAsked() {
        BackgroundTask task;
        QThread* worked = nullptr;
        QThread* concluded = nullptr;
        task.start([&](const std::stop_token&) -> BackgroundTask::Then {
            worked = QThread::currentThread();
            return [&] { concluded = QThread::currentThread(); };
        });
        QVERIFY(task.isRunning());
        QTRY_VERIFY(!task.isRunning());
        QCOMPARE(concluded, QThread::currentThread());
        QVERIFY(worked != concluded);
    }

    void finishingConcludesAtOnceAndOnlyOnce() {
        BackgroundTask task;
        int concluded = 0;
        task.start([&](const std::stop_token&) -> BackgroundTask::Then { return [&] { ++concluded; }; });
        task.finish();
        QCOMPARE(concluded, 1);
        QVERIFY(!task.isRunning());
        QCoreApplication::processEvents();
        task.finish();
        QCOMPARE(concluded, 1);
    }

    void whatFollowsMayStartTheNext() {
        BackgroundTask task;
        int concluded = 0;
        task.start([&](const std::stop_token&) -> BackgroundTask::Then {
            return [&] {
                ++concluded;
                task.start([&](const std::stop_token&) -> BackgroundTask::Then { return [&] { ++concluded; }; });
            };
        });
        QTRY_COMPARE(concluded, 2);
    }

    void whatIsOutOfDateCanBeAskedToStop() {
        BackgroundTask task;
        task.requestStop(); // nothing is running
        bool concluded = false;
        task.start([&](const std::stop_token& stop) -> BackgroundTask::Then {
            while (!stop.stop_requested()) {
                std::this_thread::yield();
            }
            return [&] { concluded = true; };
        });
        task.requestStop();
        QTRY_VERIFY(concluded);
        QVERIFY(!task.isRunning());
    }

    void whatTheMemoryDoesNotHoldEndsTheWorkAndNothingElse() {
        BackgroundTask task;
        task.start([](const std::stop_token&) -> BackgroundTask::Then { throw std::bad_alloc(); });
        QTRY_VERIFY(!task.isRunning());
        task.start([](const std::stop_token&) -> BackgroundTask::Then { throw std::length_error("too long"); });
        task.finish();
        QVERIFY(!task.isRunning());
        bool concluded = false;
        task.start([&](const std::stop_token&) -> BackgroundTask::Then { return [&] { concluded = true; }; });
        task.finish();
        QVERIFY(concluded);
    }

    void whatNobodyWaitsForIsAskedToStop() {
        std::atomic<bool> stopped = false;
        bool concluded = false;
        {
            BackgroundTask task;
            task.start([&](const std::stop_token& stop) -> BackgroundTask::Then {
                while (!stop.stop_requested()) {
                    std::this_thread::yield();
                }
                stopped = true;
                return [&] { concluded = true; };
            });
        }
        QVERIFY(stopped);
        QCoreApplication::processEvents();
        QVERIFY(!concluded);
    }
};

SPACETOW_TEST(BackgroundTaskTest)
#include "background_task_test.moc"
