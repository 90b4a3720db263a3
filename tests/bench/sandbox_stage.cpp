#include "tests/bench/sandbox_stage.h"

#include "core/level/bounds.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QThread>

#include <algorithm>

namespace spacetow::bench {

class SandboxStage::PaintWatch : public QObject {
  public:
    explicit PaintWatch(int& count) : m_count(count) {}

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        m_count += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }

  private:
    int& m_count;
};

SandboxStage::SandboxStage(const Meter& meter) : m_meter(meter) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, file(QStringLiteral("settings")));
    qputenv("XDG_STATE_HOME", file(QStringLiteral("state")).toUtf8());
    m_window = std::make_unique<MainWindow>();
    m_window->files().questions.whatAboutChanges = [](const QString&) { return Unsaved::Discard; };
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
    m_window->toolbox().snap.grid = false;
    m_watch = std::make_unique<PaintWatch>(m_paintings);
    canvas().installEventFilter(m_watch.get());
}

SandboxStage::~SandboxStage() = default;

void SandboxStage::show(Level level) {
    stop();
    m_window->document().reset(std::move(level));
    canvas().setView(canvas().view().showing(boundsOf(m_window->document().level())));
    for (int round = 0; round < 3; ++round) {
        QCoreApplication::processEvents();
        canvas().finishPainting();
        m_window->problems().check();
    }
}

double SandboxStage::turn() {
    const double taken = m_meter.time([] { QCoreApplication::processEvents(); });
    QThread::usleep(500);
    return taken;
}

double SandboxStage::longestTurn(const std::function<bool()>& isDone) {
    return longestTurn([] {}, isDone);
}

double SandboxStage::longestTurn(const std::function<void()>& work, const std::function<bool()>& isDone) {
    constexpr qint64 patience = 30'000; // ms
    QElapsedTimer clock;
    clock.start();
    double longest = m_meter.time(work);
    while (!isDone() && clock.elapsed() < patience) {
        longest = std::max(longest, turn());
    }
    return std::max(longest, turn());
}

void SandboxStage::stop() {
    m_window->stopPlaying();
    while (run().ending() > 0) {
        turn();
    }
    if (m_window->openLevel()->runChanges.areWaiting()) {
        m_window->openLevel()->runChanges.discard();
    }
}

} // namespace spacetow::bench
