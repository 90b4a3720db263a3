#pragma once
// Being told by the system to end (SIGTERM, SIGHUP, SIGINT), as an event of the event loop, in which anything may be
// done; in the handler of a signal hardly anything may.

#include <QObject>

namespace spacetow {

/// One for the program.
class QuitSignals : public QObject {
    Q_OBJECT

  public:
    QuitSignals();
    ~QuitSignals() override;

  Q_SIGNALS:
    void received();
};

} // namespace spacetow
