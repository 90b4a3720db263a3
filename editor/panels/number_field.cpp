#include "editor/panels/number_field.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr int decimals = 4; // as many as are shown
constexpr double large = 1e7;
constexpr int unitGap = 6; // px

QString shown(double number) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    if (std::abs(number) >= large || (number != 0 && std::abs(number) < 0.5e-4)) {
        return locale.toString(number, 'g', 6);
    }
    QString text = locale.toString(number, 'f', decimals);
    const QString point = locale.decimalPoint();
    while (text.contains(point) && (text.endsWith(locale.zeroDigit()) || text.endsWith(point))) {
        const bool done = text.endsWith(point);
        text.chop(done ? point.size() : 1);
        if (done) {
            break;
        }
    }
    return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

} // namespace

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
    connect(this, &QLineEdit::returnPressed, this, &NumberField::commit);
    connect(this, &QLineEdit::textEdited, this, [this] { setWrong(false); });
}

std::optional<double> NumberField::parsed(const QString& text) {
    QString plain = text.trimmed();
    plain.replace(QLatin1Char(','), QLatin1Char('.'));
    plain.replace(QChar(0x2212), QLatin1Char('-'));
    bool fine = false;
    const double number = QLocale::c().toDouble(plain, &fine);
    return fine && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

void NumberField::setSpec(const NumberSpec& spec) {
    m_spec = spec;
    const int unit = spec.unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(spec.unit) + unitGap;
    setTextMargins(0, 0, unit, 0);
    setToolTip(rangeText());
    refresh();
}

void NumberField::setValue(std::optional<double> value) {
    const bool same = !m_mixed && value == m_value;
    m_value = value;
    m_mixed = false;
    if (!same && !(hasFocus() && isModified())) {
        refresh();
    }
}

void NumberField::setMixed() {
    m_value.reset();
    m_mixed = true;
    if (!(hasFocus() && isModified())) {
        refresh();
    }
}

void NumberField::refresh() {
    setWrong(false);
    setText(m_value ? shown(*m_value) : QString());
    setPlaceholderText(m_mixed ? tr("mixed") : m_spec.none);
    setCursorPosition(0);
    setModified(false);
}

bool NumberField::accepts(double number) const {
    return (m_spec.openMin ? number > m_spec.min : number >= m_spec.min) && number <= m_spec.max &&
           (!m_spec.whole || number == std::floor(number));
}

QString NumberField::rangeText() const {
    if (!std::isfinite(m_spec.min) || !std::isfinite(m_spec.max)) {
        return {};
    }
    const QString kind = m_spec.whole ? tr("A whole number") : tr("A number");
    const QString range = m_spec.openMin ? tr("%1 above %2 and up to %3") : tr("%1 from %2 to %3");
    const QString text = range.arg(kind, shown(m_spec.min), shown(m_spec.max));
    return m_spec.mayBeEmpty ? tr("%1, or nothing").arg(text) : text;
}

void NumberField::commit() {
    if (!isModified()) {
        return;
    }
    if (text().trimmed().isEmpty() && (m_spec.mayBeEmpty || m_mixed)) {
        setModified(false);
        if (m_spec.mayBeEmpty) {
            Q_EMIT entered({});
        }
        return;
    }
    const std::optional<double> number = parsed(text());
    if (!number || !accepts(*number)) {
        setWrong(true);
        QToolTip::showText(mapToGlobal(QPoint(0, height())), rangeText(), this);
        return;
    }
    setModified(false);
    m_mixed = false;
    m_value = number;
    refresh();
    selectAll();
    Q_EMIT entered(number);
}

void NumberField::revert() {
    refresh();
}

void NumberField::stepBy(double steps) {
    const double from = parsed(text()).value_or(m_value.value_or(0));
    const double step = m_spec.whole ? std::max(1.0, std::abs(steps)) * (steps < 0 ? -1 : 1) : steps * m_spec.step;
    // Rounded, so that ten steps of 0.1 make 1.
    const double next = std::clamp(std::round((from + step) * 1e9) / 1e9, m_spec.min, m_spec.max);
    if (accepts(next)) {
        setText(shown(next));
        setModified(false);
        m_mixed = false;
        m_value = next;
        setWrong(false);
        Q_EMIT entered(next);
    }
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const double factor = event->modifiers().testFlag(Qt::ShiftModifier)     ? 0.1
                          : event->modifiers().testFlag(Qt::ControlModifier) ? 10
                                                                             : 1;
    switch (event->key()) {
    case Qt::Key_Up:
        stepBy(factor);
        return;
    case Qt::Key_Down:
        stepBy(-factor);
        return;
    case Qt::Key_Escape:
        if (isModified() || m_wrong) {
            revert();
            return;
        }
        break;
    default:
        break;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (hasFocus() && event->angleDelta().y() != 0) {
        stepBy(event->angleDelta().y() > 0 ? 1 : -1);
        event->accept();
    } else {
        event->ignore(); // the panel scrolls
    }
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    commit();
    if (m_wrong || isModified()) {
        revert();
    }
    QLineEdit::focusOutEvent(event);
}

void NumberField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        setSpec(m_spec);
    }
    QLineEdit::changeEvent(event);
}

void NumberField::setWrong(bool wrong) {
    if (m_wrong != wrong) {
        m_wrong = wrong;
        update();
    }
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    if (!m_spec.unit.isEmpty()) {
        painter.setPen(palette().color(isEnabled() ? QPalette::PlaceholderText : QPalette::Dark));
        painter.drawText(rect().adjusted(0, 0, -unitGap, 0), Qt::AlignRight | Qt::AlignVCenter, m_spec.unit);
    }
    if (m_wrong) {
        painter.setPen(QPen(QColor(226, 60, 48), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

QSize NumberField::sizeHint() const {
    QSize size = QLineEdit::sizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.0000")) + textMargins().right() + 8);
    return size;
}

QSize NumberField::minimumSizeHint() const {
    QSize size = QLineEdit::minimumSizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-00.000")) + textMargins().right() + 12);
    return size;
}

} // namespace spacetow
