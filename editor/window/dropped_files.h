#pragma once
// What becomes of files that are dropped on a window, chosen in it or named on the command line: levels are opened,
// recorded flights are flown in their level, bug capsules run, drawings are imported. What a file is, its content says,
// whatever it is called.

#include <QStringList>

namespace spacetow {

class MainWindow;

/// What cannot be done with them, the window says in its bar.
void openDropped(const QStringList& paths, MainWindow& window);

} // namespace spacetow
