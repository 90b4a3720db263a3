#pragma once
// What the program remembers from one run to the next: window, recent files and switches. Kept by QSettings; nothing of
// it is ever written into a level.

#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/overlay_palette.h"
#include "editor/editing/snap.h"
#include "editor/window/appearance.h"
#include "editor/window/key_bindings.h"

#include <QByteArray>
#include <QStringList>

namespace spacetow {

class Preferences {
  public:
    static constexpr int maxRecent = 10;

    QByteArray geometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    /// Newest first; files that are gone are left out.
    QStringList recentFiles() const;
    void addRecent(const QString& path);
    void removeRecent(const QString& path);
    void clearRecent();

    /// Whether the windows of the last run are opened again.
    bool restoresWindows() const;
    void setRestoresWindows(bool restores);

    /// Whether the welcome page is shown while no level is open.
    bool welcomes() const;
    void setWelcomes(bool welcomes);

    SnapSettings snap() const;
    void setSnap(const SnapSettings& snap);
    bool grid() const;
    void setGrid(bool visible);
    bool rulers() const;
    void setRulers(bool visible);
    bool guides() const;
    void setGuides(bool visible);
    Appearance appearance() const;
    void setAppearance(Appearance appearance);
    /// See speak(); empty for that of the desktop.
    QString language() const;
    void setLanguage(const QString& code);
    OverlayFlags overlays() const;
    void setOverlays(const OverlayFlags& overlays);
    OverlayPalette overlayPalette() const;
    void setOverlayPalette(const OverlayPalette& palette);
    bool isLegendShown() const; // of the overlays
    void setLegendShown(bool shown);
    /// Sections of the inspector.
    QStringList foldedSections() const;
    void setFoldedSections(const QStringList& titles);
    /// Codes of what was taken from the command palette, newest first.
    QStringList recentlyFound() const;
    void addRecentlyFound(const QString& code);
    /// The usual ones where what is kept cannot be understood.
    KeyBindings keyBindings() const;
    void setKeyBindings(const KeyBindings& bindings);
};

} // namespace spacetow
