#include "editor/window/quit_signals.h"

#include <QSocketNotifier>

#include <csignal>
#include <fcntl.h>
#include <iterator>
#include <unistd.h>

namespace spacetow {

namespace {

constexpr int quitting[] = {SIGTERM, SIGHUP, SIGINT};
int quitPipe[2] = {-1, -1}; // what is written to the second end wakes the event loop at the first

void tellQuit(int) {
    const char byte = 0;
    [[maybe_unused]] const ssize_t ignored = ::write(quitPipe[1], &byte, 1);
}

struct sigaction formerActions[std::size(quitting)];

} // namespace

QuitSignals::QuitSignals() {
    if (::pipe2(quitPipe, O_CLOEXEC | O_NONBLOCK) != 0) {
        return;
    }
    auto* const notifier = new QSocketNotifier(quitPipe[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        char bytes[16];
        while (::read(quitPipe[0], bytes, sizeof bytes) > 0) {
        }
        Q_EMIT received();
    });
    struct sigaction action {};
    action.sa_handler = tellQuit;
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < std::size(quitting); ++i) {
        ::sigaction(quitting[i], &action, &formerActions[i]);
    }
}

QuitSignals::~QuitSignals() {
    if (quitPipe[0] >= 0) {
        for (std::size_t i = 0; i < std::size(quitting); ++i) {
            ::sigaction(quitting[i], &formerActions[i], nullptr);
        }
        ::close(quitPipe[0]);
        ::close(quitPipe[1]);
        quitPipe[0] = quitPipe[1] = -1;
    }
}

} // namespace spacetow
