#include "editor/panels/fault_label.h"

#include "editor/panels/form_colors.h"

#include <QEvent>

namespace spacetow {

FaultLabel::FaultLabel(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    tint();
    hide();
}

void FaultLabel::say(const QString& fault) {
    setText(fault);
    setVisible(!fault.isEmpty());
}

void FaultLabel::tint() {
    QPalette colors = palette();
    if (const QColor wanted = faultColor(colors); colors.color(QPalette::WindowText) != wanted) {
        colors.setColor(QPalette::WindowText, wanted);
        setPalette(colors);
    }
}

void FaultLabel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QLabel::changeEvent(event);
}

} // namespace spacetow
