#pragma once
// The commands of levelc, one a file. Each takes its arguments after its own name and returns the exit status:
// 0 good, 1 the level (or the flight) is not, 2 bad usage or a file that cannot be read.

#include <QStringList>

namespace spacetow {

int checkCommand(const QStringList& arguments);
int infoCommand(const QStringList& arguments);

} // namespace spacetow
