#pragma once
// levelc as a process of its own.

#include "tests/support/folders.h"

#include <QProcess>

namespace spacetow::test {

struct LevelcRun {
    int status = -1; // -1 when it has crashed, or not ended within two minutes
    QString out, err;
};

inline LevelcRun runLevelc(const QStringList& arguments) {
    QProcess process;
    process.start(binaryFolder() + "/bin/levelc", arguments);
    const bool ended = process.waitForFinished(120000) && process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

} // namespace spacetow::test
