#include "editor/panels/number_field.h"

#include "core/base/codes.h"
#include "core/base/decimal.h"
#include "editor/panels/form_colors.h"
#include "editor/panels/history_keys.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"
#include "editor/panels/scrub_label.h"

#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

constexpr int unitGap = 6; // px
constexpr int tenthsOfStep = 10;
constexpr int pixelsOfStep = 5;
constexpr int notch = 120; // eighths of a degree of the wheel

/// Whether two numbers are the same but for what a change of unit and back may do.
bool areAlike(double a, double b) {
    return std::abs(a - b) <= 1e-15 * std::max(std::abs(a), std::abs(b));
}

} // namespace

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
    connect(this, &QLineEdit::returnPressed, this, [this] {
        commit();
        if (m_fault.isEmpty()) {
            setSelection(static_cast<int>(text().size()), -static_cast<int>(text().size())); // its head stays in sight
        }
    });
    connect(this, &QLineEdit::textEdited, this, [this] { setFault({}); });
    setStatusTip(
        tr("Type a number or an expression such as 2*pi/3, 20 cm, +=0.5 or *=2 · Up, Down, wheel: step · Shift: "
           "finer · Ctrl: coarser"));
}

NumberField::~NumberField() = default;

void NumberField::setSpec(const NumberSpec& spec) {
    if (spec == m_spec) {
        return;
    }
    m_spec = spec;
    placeMargins();
    refresh();
}

void NumberField::setAxis(const QString& axis) {
    m_axis = std::make_unique<ScrubLabel>(axis, *this, this);
    m_axis->setForegroundRole(QPalette::PlaceholderText);
    m_axis->show();
    placeMargins();
}

void NumberField::placeMargins() {
    const int unit = m_spec.unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(m_spec.unit) + unitGap;
    const int axis = m_axis ? m_axis->sizeHint().width() + unitGap : 0;
    setTextMargins(axis, 0, unit, 0);
    if (m_axis) {
        m_axis->setGeometry(unitGap, 1, m_axis->sizeHint().width(), height() - 2);
    }
}

void NumberField::resizeEvent(QResizeEvent* event) {
    QLineEdit::resizeEvent(event);
    placeMargins();
}

void NumberField::setValue(std::optional<double> value) {
    const bool isSame = !m_mixed && value == m_value;
    m_value = value;
    m_mixed = false;
    follow(isSame);
}

void NumberField::setMixed() {
    const bool isSame = m_mixed;
    m_value.reset();
    m_mixed = true;
    follow(isSame);
}

void NumberField::follow(bool isSame) {
    if (!isModified() || (!hasFocus() && !isSame)) {
        revert();
    }
}

void NumberField::refresh() {
    if (!isModified() || (!hasFocus() && m_fault.isEmpty())) {
        revert(); // else it is being typed, or to be mended
    }
}

void NumberField::revert() {
    setFault({});
    const QString wanted = !m_value ? QString() : hasFocus() ? exactNumberText(*m_value) : shortNumberText(*m_value);
    if (wanted != text() || isModified()) {
        setText(wanted);
        setCursorPosition(0);
    }
    setPlaceholderText(m_mixed ? tr("mixed") : m_spec.none);
    setModified(false);
    QStringList lines{m_spec.meaning, rangeText()};
    if (m_value && shortNumberText(*m_value) != exactNumberText(*m_value)) {
        lines << tr("Exactly %1 %2").arg(exactNumberText(*m_value), m_spec.unit).trimmed();
    }
    lines.removeAll(QString());
    setToolTip(lines.join(QLatin1Char('\n')));
}

bool NumberField::isWithin(double number) const {
    return std::isfinite(number) && (m_spec.openMin ? number > m_spec.min : number >= m_spec.min) &&
           number <= m_spec.max && (!m_spec.whole || number == std::floor(number));
}

QString NumberField::rangeText() const {
    const QString kind = m_spec.whole ? tr("A whole number") : tr("A number");
    const QString least = shortNumberText(m_spec.min);
    const QString most = shortNumberText(m_spec.max);
    QString text;
    if (std::isfinite(m_spec.min) && std::isfinite(m_spec.max)) {
        text = (m_spec.openMin ? tr("%1 above %2 and up to %3") : tr("%1 from %2 to %3")).arg(kind, least, most);
    } else if (std::isfinite(m_spec.min)) {
        text = (m_spec.openMin ? tr("%1 above %2") : tr("%1 of %2 or more")).arg(kind, least);
    } else {
        return {};
    }
    return m_spec.mayBeEmpty ? tr("%1, or nothing").arg(text) : text;
}

QString NumberField::objectionTo(double number) const {
    if (isWithin(number)) {
        return {};
    }
    if (!std::isfinite(number)) {
        return words ? words(Error{BaseCode("expression-not-finite"), {}}) : tr("The result is too large.");
    }
    return tr("%1 is not possible: %2.").arg(shortNumberText(number), rangeText());
}

std::optional<NumberChange> NumberField::read() {
    const Result<NumberChange> change = numberChange(withPlainDigits(text()).toStdString(), m_spec.unit.toStdString());
    if (!change) {
        setFault(words ? words(change.error()) : tr("“%1” is no number.").arg(text()));
        return {};
    }
    const bool isKnown = m_value || !change.value().isRelative();
    const QString objection = isKnown ? objectionTo(applied(change.value(), m_value.value_or(0))) : QString();
    if (!objection.isEmpty()) {
        setFault(objection);
        return {};
    }
    return change.value();
}

void NumberField::commit() {
    if (!isModified()) {
        return;
    }
    if (text().trimmed().isEmpty() && (m_spec.mayBeEmpty || m_mixed)) {
        // Several values that nobody typed over stay what they are.
        const bool isMeant = m_spec.mayBeEmpty && (!m_mixed || hasFocus());
        const QString objection = isMeant && enter ? enter({}) : QString();
        setModified(false);
        revert();
        setFault(objection);
        if (isMeant && !enter) {
            keep({});
        }
        return;
    }
    if (const std::optional<NumberChange> change = read()) {
        send(*change, false);
    }
}

bool NumberField::enterTyped() {
    commit();
    return m_fault.isEmpty();
}

void NumberField::send(const NumberChange& change, bool isStep) {
    if (!enter) {
        keep(applied(change, m_value.value_or(0)));
        return;
    }
    const QString objection = enter({change, NumberEntry::Phase::Final, isStep});
    if (!objection.isEmpty()) {
        setFault(objection);
        return;
    }
    revert();
}

void NumberField::keep(std::optional<double> value) {
    m_value = value;
    m_mixed = false;
    revert();
    Q_EMIT entered(value);
}

void NumberField::stepBy(int tenths) {
    commit();
    if (!m_fault.isEmpty()) {
        return;
    }
    const double unit = m_spec.whole ? 1 : m_spec.step / tenthsOfStep;
    int count = m_spec.whole ? (tenths < 0 ? -1 : 1) * std::max(1, std::abs(tenths) / tenthsOfStep) : tenths;
    if (m_mixed) {
        send({NumberChange::Kind::Add, decimalMultiple(unit, count)}, true);
        return;
    }
    double from = m_value.value_or(0);
    if (m_steps && m_value && areAlike(m_steps->result, *m_value)) {
        from = m_steps->from;
        count += m_steps->tenths;
    }
    const double wanted = decimalSum(from, decimalMultiple(unit, count));
    const double next = std::clamp(wanted, m_spec.min, m_spec.max);
    if (!isWithin(next) || next == m_value) {
        return;
    }
    m_steps = next == wanted ? Steps{from, count, next} : Steps{next, 0, next};
    send({NumberChange::Kind::Set, next}, true);
}

void NumberField::beginScrub() {
    commit();
    m_scrub.reset();
    if (m_fault.isEmpty()) {
        m_scrub = Scrub{m_mixed ? std::nullopt : std::optional(m_value.value_or(0)), {}};
    }
}

double NumberField::scrubbed(double from, int pixels, Qt::KeyboardModifiers modifiers) const {
    if (m_spec.whole) {
        return from + std::round(double(pixels) / pixelsOfStep);
    }
    const int slower = modifiers.testFlag(Qt::ShiftModifier) ? 10 : 1;
    const double wanted = decimalSum(from, decimalMultiple(m_spec.step / pixelsOfStep / slower, pixels));
    if (modifiers.testFlag(Qt::ControlModifier)) {
        const double step = m_spec.step / slower;
        return decimalMultiple(step, static_cast<int>(std::clamp(std::round(wanted / step), -1e9, 1e9)));
    }
    return wanted;
}

void NumberField::scrub(int pixels, Qt::KeyboardModifiers modifiers) {
    if (!m_scrub) {
        return;
    }
    if (m_scrub->from) {
        const double next = std::clamp(scrubbed(*m_scrub->from, pixels, modifiers), m_spec.min, m_spec.max);
        if (!isWithin(next)) {
            return;
        }
        m_scrub->last = {NumberChange::Kind::Set, next};
    } else {
        m_scrub->last = {NumberChange::Kind::Add, scrubbed(0, pixels, modifiers)};
    }
    if (enter) {
        setFault(enter({m_scrub->last, NumberEntry::Phase::Preview, false}));
    } else if (!m_scrub->last->isRelative()) {
        keep(m_scrub->last->operand);
    }
}

void NumberField::endScrub(bool isMeant) {
    const std::optional<Scrub> scrub = std::exchange(m_scrub, std::nullopt);
    if (scrub && !enter && !isMeant && scrub->last && scrub->from) {
        keep(scrub->from);
    } else if (scrub && enter) {
        const bool anything = isMeant && scrub->last;
        const auto phase = anything ? NumberEntry::Phase::Final : NumberEntry::Phase::Cancelled;
        const QString objection = enter({scrub->last, phase, false});
        revert();
        setFault(objection);
    }
}

bool NumberField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_scrub) {
        event->accept(); // nothing else acts during a drag
        return true;
    }
    return isHistoryOfLevel(*event, isModified()) ? false : QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (m_scrub) {
        if (event->key() == Qt::Key_Escape) {
            endScrub(false);
        }
        return;
    }
    const int tenths = event->modifiers().testFlag(Qt::ShiftModifier)     ? 1
                       : event->modifiers().testFlag(Qt::ControlModifier) ? 10 * tenthsOfStep
                                                                          : tenthsOfStep;
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        stepBy(event->key() == Qt::Key_Up ? tenths : -tenths);
    } else if (event->key() == Qt::Key_Escape && (isModified() || !m_fault.isEmpty())) {
        revert();
        selectAll();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) {
        event->ignore(); // the panel scrolls
        return;
    }
    event->accept();
    m_wheel += event->angleDelta().y();
    const int notches = m_wheel / notch;
    m_wheel %= notch;
    if (notches != 0) {
        stepBy(notches * tenthsOfStep);
    }
}

void NumberField::focusInEvent(QFocusEvent* event) {
    m_wheel = 0;
    refresh();
    QLineEdit::focusInEvent(event);
    if (hasSelectedText() && selectedText() == text()) {
        setSelection(static_cast<int>(text().size()), -static_cast<int>(text().size())); // its beginning is seen
    }
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        endScrub(false);
        commit();
        refresh();
    }
    QLineEdit::focusOutEvent(event);
}

void NumberField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        placeMargins();
    }
    QLineEdit::changeEvent(event);
}

void NumberField::setFault(const QString& fault) {
    if (m_fault != fault) {
        m_fault = fault;
        setAccessibleDescription(fault);
        update();
        if (!enter && !fault.isEmpty()) {
            QToolTip::showText(mapToGlobal(QPoint(0, height())), plainToolTip(fault), this);
        }
        Q_EMIT faultChanged();
    }
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    if (!m_spec.unit.isEmpty()) {
        painter.setPen(palette().color(isEnabled() ? QPalette::PlaceholderText : QPalette::Dark));
        painter.drawText(rect().adjusted(0, 0, -unitGap, 0), Qt::AlignRight | Qt::AlignVCenter, m_spec.unit);
    }
    if (!m_fault.isEmpty()) {
        painter.setPen(QPen(faultColor(palette()), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

QSize NumberField::sizeHint() const {
    QSize size = QLineEdit::sizeHint();
    const QMargins margins = textMargins();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.0000")) + margins.left() + margins.right() + 8);
    return size;
}

QSize NumberField::minimumSizeHint() const {
    QSize size = QLineEdit::minimumSizeHint();
    const QMargins margins = textMargins();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-00.00")) + margins.left() + margins.right() + 12);
    return size;
}

} // namespace spacetow
