#include "editor/window/window_memory.h"

#include "editor/window/main_window.h"

#include <QSettings>

#include <cmath>

namespace spacetow {

namespace {

constexpr auto list = "windows/open";

} // namespace

RememberedView viewOf(const MainWindow& window) {
    return {window.canvas().view().center, window.canvas().view().scale};
}

void showView(MainWindow& window, const RememberedView& remembered) {
    const Vec2& center = remembered.center;
    if (!(remembered.scale >= Viewport::minScale && remembered.scale <= Viewport::maxScale) ||
        !std::isfinite(center.x()) || !std::isfinite(center.y())) {
        return;
    }
    Viewport view = window.canvas().view();
    view.center = center;
    view.scale = remembered.scale;
    window.canvas().setView(view);
}

void rememberWindows(const std::vector<MainWindow*>& windows) {
    QSettings settings;
    settings.remove(list);
    settings.beginWriteArray(list);
    int count = 0;
    for (const MainWindow* window : windows) {
        const QString path = window->openLevel()->files.path();
        if (path.isEmpty()) {
            continue;
        }
        settings.setArrayIndex(count++);
        const RememberedView view = viewOf(*window);
        settings.setValue("path", path);
        settings.setValue("x", view.center.x());
        settings.setValue("y", view.center.y());
        settings.setValue("scale", view.scale);
        settings.setValue("geometry", window->saveGeometry());
        settings.setValue("arrangement", window->panels().arrangement());
    }
    settings.endArray();
}

std::vector<RememberedWindow> rememberedWindows() {
    QSettings settings;
    std::vector<RememberedWindow> windows;
    const int count = settings.beginReadArray(list);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        windows.push_back(
            {settings.value("path").toString(),
             {Vec2(settings.value("x").toDouble(), settings.value("y").toDouble()), settings.value("scale").toDouble()},
             settings.value("geometry").toByteArray(),
             settings.value("arrangement").toByteArray()});
    }
    settings.endArray();
    return windows;
}

} // namespace spacetow
