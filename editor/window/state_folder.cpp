#include "editor/window/state_folder.h"

#include <QDir>

namespace spacetow {

std::filesystem::path stateFolder() {
    // QStandardPaths knows of it from Qt 6.7 on.
    const QString told = qEnvironmentVariable("XDG_STATE_HOME");
    const QString home = QDir::isAbsolutePath(told) ? told : QDir::home().filePath(QStringLiteral(".local/state"));
    return QDir(home).filePath(QStringLiteral("spacetow-studio")).toStdString();
}

} // namespace spacetow
