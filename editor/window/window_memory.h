#pragma once
// What was open when the program ended: which files, and which part of each was in view. Kept with the preferences.

#include "core/math/vec.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace spacetow {

class MainWindow;

struct RememberedView {
    Vec2 center{0, 0}; // m
    double scale = 0;  // pixels a metre; 0: the whole level
};

struct RememberedWindow {
    QString path;
    RememberedView view;
    QByteArray geometry;
    QByteArray arrangement; // of the panels
};

RememberedView viewOf(const MainWindow& window);
/// Of a window that is on the screen.
void showView(MainWindow& window, const RememberedView& view);

/// Levels without a file are left out.
void rememberWindows(const std::vector<MainWindow*>& windows);
/// Several windows with one path are views of one level.
std::vector<RememberedWindow> rememberedWindows();

} // namespace spacetow
