#pragma once
// Work that would hold up the window, done by a thread beside it, one piece at a time. What becomes of the result is
// done by the thread that started it, from its event loop.

#include <QObject>

#include <functional>
#include <mutex>
#include <thread>

namespace spacetow {

class BackgroundTask : public QObject {
  public:
    using Then = std::function<void()>;
    /// Runs in the other thread and returns what is to be done with its result in this one. It should return early,
    /// with whatever, when a stop is requested. Where the memory does not do, nothing follows.
    using Work = std::function<Then(const std::stop_token&)>;

    explicit BackgroundTask(QObject* parent = nullptr) : QObject(parent) {}
    /// Asks the work to stop and waits for it; its result is forgotten.
    ~BackgroundTask() override;

    bool isRunning() const { return m_thread.joinable(); }
    /// Nothing else may be running.
    void start(Work work);
    /// Asks the work to stop, without waiting for it. What it returns is done all the same.
    void requestStop() { m_thread.request_stop(); }
    /// Waits for the work and does what follows from it at once.
    void finish();

  private:
    void conclude();

    std::mutex m_mutex;
    Then m_then; // once the work is done
    std::jthread m_thread;
};

} // namespace spacetow
