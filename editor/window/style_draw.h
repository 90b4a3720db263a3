#pragma once
// The pieces of the style, each a function of an option and a painter; style.cpp says which is for what. True means
// that it was drawn; otherwise the toolkit's own style draws it.

#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace spacetow {

inline constexpr double controlRadius = 4; // px
inline constexpr int scrollWidth = 12;     // px
inline constexpr int menuArrowWidth = 16;  // px, beside the words of a button

/// Paints with antialiasing and leaves the painter as it was.
class Brushwork {
  public:
    explicit Brushwork(QPainter& painter) : m_painter(painter) {
        m_painter.save();
        m_painter.setRenderHint(QPainter::Antialiasing);
    }
    ~Brushwork() { m_painter.restore(); }
    Brushwork(const Brushwork&) = delete;
    Brushwork& operator=(const Brushwork&) = delete;

  private:
    QPainter& m_painter;
};

enum class Direction : std::uint8_t { Up, Down, Left, Right };
/// An angle bracket in the middle of the box.
void chevron(QPainter& painter, const QRectF& box, Direction direction, const QColor& color);
/// A rounded box whose line lies within the rectangle.
void plate(QPainter& painter, const QRectF& box, const QColor& fill, const QColor& line, double lineWidth = 1);
/// Around what has the keyboard.
void focusRing(QPainter& painter, const QRectF& box, const QPalette& palette);
/// The accent as a line: bright enough on panels of either shade.
QColor accentLine(const QPalette& palette);
bool isOn(const QStyleOption& option, QStyle::StateFlag flag);

/// The line edit of a field that has a panel of its own, as a combo box has.
bool isInsideField(const QWidget* widget);

// style_controls.cpp: buttons, ticks, fields
bool drawButtonPanel(const QStyleOption& option, QPainter& painter);
bool drawToolButtonPanel(const QStyleOption& option, QPainter& painter);
bool drawFieldPanel(const QStyleOption& option, QPainter& painter);
bool drawTick(const QStyleOption& option, QPainter& painter);
bool drawRadio(const QStyleOption& option, QPainter& painter);
bool drawComboBox(const QProxyStyle& style, const QStyleOptionComboBox& option, QPainter& painter,
                  const QWidget* widget);
bool drawSpinBox(const QProxyStyle& style, const QStyleOptionSpinBox& option, QPainter& painter, const QWidget* widget);
/// A button with words that only opens a menu; an arrow beside the words says so.
bool opensMenu(const QStyleOptionToolButton& option);
bool drawMenuButton(const QProxyStyle& style, const QStyleOptionToolButton& option, QPainter& painter,
                    const QWidget* widget);
bool drawSlider(const QProxyStyle& style, const QStyleOptionSlider& option, QPainter& painter, const QWidget* widget);

// style_bars.cpp: menus, tool bars, titles, tabs, headers
bool drawMenuItem(const QStyleOptionMenuItem& option, QPainter& painter);
bool drawMenuBarItem(const QStyleOptionMenuItem& option, QPainter& painter);
bool drawDockTitle(const QProxyStyle& style, const QStyleOptionDockWidget& option, QPainter& painter,
                   const QWidget* widget);
bool drawTab(const QStyleOptionTab& option, QPainter& painter);
bool drawHeaderSection(const QStyleOption& option, QPainter& painter);
bool drawToolBar(const QStyleOptionToolBar& option, QPainter& painter);
bool drawBarSeparator(const QStyleOption& option, QPainter& painter);
bool drawDockGrip(const QStyleOption& option, QPainter& painter);
bool drawStatusBar(const QStyleOption& option, QPainter& painter);

// style_views.cpp: lists, trees, frames, scroll bars, progress
bool drawItemPanel(const QStyleOptionViewItem& option, QPainter& painter);
bool drawBranch(const QStyleOption& option, QPainter& painter);
bool drawFrame(const QStyleOption& option, QPainter& painter);
bool drawMenuPanel(const QStyleOption& option, QPainter& painter);
bool drawTip(const QStyleOption& option, QPainter& painter);
/// No arrows at the ends: the groove is all of it.
QRect scrollBarPart(const QStyleOptionSlider& option, QStyle::SubControl part, int leastSlider);
bool drawScrollBar(const QProxyStyle& style, const QStyleOptionSlider& option, QPainter& painter,
                   const QWidget* widget);
bool drawProgress(const QStyleOptionProgressBar& option, QPainter& painter);
bool drawRubberBand(const QStyleOption& option, QPainter& painter);

} // namespace spacetow
