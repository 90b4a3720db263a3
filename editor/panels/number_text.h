#pragma once
// Numbers as text in the user's locale, and back to the digits that core/base/expression reads.

#include <QString>

namespace spacetow {

/// Four decimals at most, for reading.
QString shortNumberText(double number);
/// Every digit that tells the number from its neighbours.
QString exactNumberText(double number);

/// The digits of any script, and the exponent of the user's locale, as ASCII; all else is left as it is.
QString withPlainDigits(const QString& text);

} // namespace spacetow
