#include "editor/panels/color_field.h"

#include <QColorDialog>
#include <QPainter>
#include <QPixmap>

namespace spacetow {

namespace {

constexpr QSize swatch(28, 14);

} // namespace

ColorField::ColorField(QWidget* parent) : QToolButton(parent) {
    setIconSize(swatch);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(this, &QToolButton::clicked, this, [this] {
        const QColor color =
            QColorDialog::getColor(m_color.isValid() ? m_color : QColor(Qt::gray), this, accessibleName());
        if (color.isValid() && enter) {
            enter(color);
        }
    });
    setValue({}, false);
}

void ColorField::setValue(const QColor& color, bool isMixed) {
    m_color = color;
    QPixmap picture(swatch * devicePixelRatioF());
    picture.setDevicePixelRatio(devicePixelRatioF());
    picture.fill(color.isValid() ? color : QColor(Qt::transparent));
    QPainter painter(&picture);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(QRect(QPoint(0, 0), swatch).adjusted(0, 0, -1, -1));
    painter.end();
    setIcon(picture);
    setText(isMixed ? tr("mixed") : color.isValid() ? color.name() : tr("none"));
}

} // namespace spacetow
