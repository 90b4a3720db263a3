#include "editor/window/zoom_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>

#include <cmath>

namespace spacetow {

namespace {

constexpr double choices[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr double keyStep = 1.25; // of the arrow keys

} // namespace

ZoomField::ZoomField(QWidget* parent) : QComboBox(parent) {
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setCompleter(nullptr);
    setFocusPolicy(Qt::ClickFocus);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(7);
    lineEdit()->setAlignment(Qt::AlignRight);
    setAccessibleName(tr("Zoom"));
    setToolTip(tr("Zoom: type a percentage, or choose one; Ctrl+0 shows the original size"));
    for (const double zoom : choices) {
        addItem(textFor(zoom), zoom);
    }
    connect(this, &QComboBox::activated, this, [this](int index) {
        Q_EMIT zoomChosen(itemData(index).toDouble());
        Q_EMIT left();
    });
    restore();
}

void ZoomField::setZoom(double zoom) {
    m_zoom = zoom;
    if (!lineEdit()->isModified()) {
        restore();
    }
}

std::optional<double> ZoomField::zoomIn(const QString& text) {
    const QString number = QString(text).remove(QLatin1Char('%')).simplified();
    bool good = false;
    double percent = QLocale().toDouble(number, &good);
    if (!good) {
        percent = QLocale::c().toDouble(number, &good);
    }
    if (!good || !std::isfinite(percent) || percent <= 0) {
        return {};
    }
    return percent / 100;
}

QString ZoomField::textFor(double zoom) {
    const double percent = 100 * zoom;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return tr("%1 %").arg(percent < 10 ? locale.toString(percent, 'g', 2)
                                       : locale.toString(std::round(percent), 'f', 0));
}

void ZoomField::enter() {
    if (const std::optional<double> zoom = zoomIn(currentText())) {
        Q_EMIT zoomChosen(*zoom);
    }
    restore();
    Q_EMIT left();
}

void ZoomField::restore() {
    setEditText(textFor(m_zoom));
    lineEdit()->setModified(false);
}

void ZoomField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        enter();
        break;
    case Qt::Key_Escape:
        restore();
        Q_EMIT left();
        break;
    case Qt::Key_Up:
        Q_EMIT zoomChosen(m_zoom * keyStep);
        break;
    case Qt::Key_Down:
        Q_EMIT zoomChosen(m_zoom / keyStep);
        break;
    default:
        QComboBox::keyPressEvent(event);
    }
}

void ZoomField::focusOutEvent(QFocusEvent* event) {
    QComboBox::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) {
        restore();
    }
}

} // namespace spacetow
