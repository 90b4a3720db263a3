#include "editor/panels/number_text.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr int decimals = 4; // of the short text
constexpr double large = 1e7;
constexpr double small = 0.5e-4;
constexpr double veryLarge = 1e15; // beyond these two an exponent is shorter
constexpr double verySmall = 1e-5;

QLocale plainLocale() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

} // namespace

QString shortNumberText(double number) {
    const QLocale locale = plainLocale();
    if (number == 0) {
        return locale.toString(0); // −0 has no sign
    }
    if (std::abs(number) >= large || std::abs(number) < small) {
        return locale.toString(number, 'g', 6);
    }
    QString text = locale.toString(number, 'f', decimals);
    const QString point = locale.decimalPoint();
    const QString zero = locale.zeroDigit();
    while (text.contains(point) && (text.endsWith(zero) || text.endsWith(point))) {
        const bool done = text.endsWith(point);
        text.chop(done ? point.size() : zero.size());
        if (done) {
            break;
        }
    }
    return text;
}

QString exactNumberText(double number) {
    const QLocale locale = plainLocale();
    const double size = std::abs(number);
    if (number == 0) {
        return locale.toString(0);
    }
    return locale.toString(number, size < veryLarge && size >= verySmall ? 'f' : 'g', QLocale::FloatingPointShortest);
}

QString countText(qint64 count) {
    return QLocale().toString(count);
}

QString sizeText(qint64 bytes) {
    const QLocale locale;
    const QString whole = locale.formattedDataSize(bytes, 0, QLocale::DataSizeSIFormat);
    const QString tenths = locale.formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
    return tenths.contains(locale.decimalPoint() + locale.zeroDigit()) ? whole : tenths;
}

QString localNumberText(const std::string& spelled) {
    const QString text = QString::fromStdString(spelled);
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text, &isNumber);
    if (!isNumber || !std::isfinite(number)) {
        return text;
    }
    const QLocale locale;
    const bool isWhole = std::ranges::all_of(text, [](QChar c) { return c.isDigit() || c == QLatin1Char('-'); });
    if (isWhole) { // a double would round what is long
        bool fits = false;
        const qlonglong whole = text.toLongLong(&fits);
        return fits ? locale.toString(whole) : text;
    }
    if (text.contains(QLatin1Char('e'), Qt::CaseInsensitive)) {
        return locale.toString(number, 'g', QLocale::FloatingPointShortest);
    }
    const qsizetype point = text.indexOf(QLatin1Char('.'));
    return locale.toString(number, 'f', static_cast<int>(text.size() - point - 1));
}

QString counted(QString text, int number) {
    constexpr int least = 1000; // of which there are groups
    return number < least ? text : text.replace(QString::number(number), countText(number));
}

QString withPlainDigits(const QString& text) {
    QString plain;
    for (const char32_t c : text.toUcs4()) {
        if (QChar::category(c) == QChar::Number_DecimalDigit) {
            plain += QLatin1Char(static_cast<char>('0' + QChar::digitValue(c)));
        } else {
            plain += QString::fromUcs4(&c, 1);
        }
    }
    // The exponent may have digits of its own, as in ×۱۰^.
    QString power = QLocale().exponential();
    if (power.compare(QLatin1String("e"), Qt::CaseInsensitive) != 0) {
        for (QChar& c : power) {
            c = c.isDigit() ? QLatin1Char(static_cast<char>('0' + c.digitValue())) : c;
        }
        plain.replace(power, QLatin1String("e"), Qt::CaseInsensitive);
    }
    static const QRegularExpression typographic(QStringLiteral("[×·]10\\^(?=[-+−]?[0-9])"));
    return plain.replace(typographic, QStringLiteral("e"));
}

} // namespace spacetow
