#pragma once
// A panel in a corner of the canvas that says which overlays are on and what their colours mean. A click on an overlay
// switches it off, one on a colour asks for another. Hidden while no overlay is on.

#include "core/level/tag_table.h"
#include "editor/canvas/left_out.h"
#include "editor/canvas/overlay_palette.h"

#include <QFrame>
#include <QScrollArea>

#include <optional>

class QVBoxLayout;

namespace spacetow {

struct OverlayInk;
struct OverlayRow;

class Legend : public QFrame {
    Q_OBJECT

  public:
    /// In the lower left corner of the widget, as large as there is room for.
    explicit Legend(QWidget& canvas);

    struct Explained {
        OverlayFlags overlays;
        OverlayPalette palette;
        TagTable tags;
        Shade ground;  // of what they are drawn on
        int spare = 0; // px that stay free above and below, where a game has its display
        LeftOut leftOut;

        bool operator==(const Explained&) const = default;
    };
    void showOverlays(const Explained& explained);

  signals:
    void switchedOff(int row); // of overlayRows()
    void colorWanted(int ink); // of overlayInks()
    void closed();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void fill();
    void addOverlay(QVBoxLayout& list, int row);
    void addInk(QVBoxLayout& list, const OverlayInk& ink);
    void addTags(QVBoxLayout& list);
    static void addRemark(QVBoxLayout& list, const QString& words);
    void place();

    QWidget& m_canvas;
    QScrollArea m_scroll;
    std::optional<Explained> m_shown;
    bool m_filling = false;
};

} // namespace spacetow
