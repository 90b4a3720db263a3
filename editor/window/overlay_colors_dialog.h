#pragma once
// The colours of all overlays, also of those that are off: the set that they come from, and colours of one's own in
// place of some. What is chosen holds at once; the window keeps it, and the legend shows the same.

#include "editor/canvas/overlay_palette.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <vector>

class QGridLayout;

namespace spacetow {

class OverlayColorsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit OverlayColorsDialog(QWidget* parent = nullptr);
    /// As they are on this ground.
    void showPalette(const OverlayPalette& palette, Shade ground);

  signals:
    void chosen(const spacetow::OverlayPalette& palette);
    void colorWanted(int ink); // of overlayInks()

  private:
    struct InkRow {
        QToolButton* color; // owned by the list
        QToolButton* reset;
    };

    void addOverlay(QGridLayout& list, int row);
    void addInk(QGridLayout& list, int ink);

    OverlayPalette m_palette;
    QVBoxLayout m_column;
    QLabel m_setLabel;
    QComboBox m_set;
    QScrollArea m_scroll;
    QDialogButtonBox m_buttons;
    QPushButton* m_forget; // owned by the buttons
    std::vector<InkRow> m_inks;
};

} // namespace spacetow
