#include "editor/canvas/figure_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace spacetow {

QString figureText(double number) {
    constexpr double nothing = 1e-9;
    constexpr double most = 1e15; // of which a double knows every digit
    constexpr int digits = 4;
    const double size = std::abs(number);
    if (!(size < most)) {
        return QLocale().toString(number, 'g', digits);
    }
    if (size < nothing) {
        return QLocale().toString(0);
    }
    const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
    const double scale = std::pow(10, decimals);
    return QLocale().toString(std::round(number * scale) / scale, 'f', QLocale::FloatingPointShortest);
}

} // namespace spacetow
