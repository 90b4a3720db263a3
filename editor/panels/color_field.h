#pragma once
// A button that shows a colour and lets the user choose another one.

#include <QColor>
#include <QToolButton>

#include <functional>

namespace spacetow {

class ColorField : public QToolButton {
    Q_OBJECT

  public:
    explicit ColorField(QWidget* parent = nullptr);

    /// An invalid colour for none, and for several.
    void setValue(const QColor& color, bool isMixed);
    const QColor& value() const { return m_color; }

    std::function<void(const QColor&)> enter;

  private:
    QColor m_color;
};

} // namespace spacetow
