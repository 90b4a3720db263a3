#pragma once
// Readings that change all the time, as people read them: few digits and no exponent.

#include <QString>

namespace spacetow {

/// With four digits, or as many as stand before the decimal point; what is nothing but rounding reads 0.
QString figureText(double number);

} // namespace spacetow
