#pragma once
// Numbers as text in the user's locale, and back to the digits that core/base/expression reads.

#include <QString>

#include <string>

namespace spacetow {

/// Four decimals at most, for reading.
QString shortNumberText(double number);
/// Every digit that tells the number from its neighbours.
QString exactNumberText(double number);

/// What is counted, in groups of digits.
QString countText(qint64 count);
/// Of a file or a memory, to the tenth: "8.4 MB".
QString sizeText(qint64 bytes);
/// A number that a level, a file or a hint spells, with all of its decimals; what is none stays as it is.
QString localNumberText(const std::string& spelled);
/// A translated text in which Qt has put the number for %n: the number in groups of digits.
QString counted(QString text, int number);

/// The digits of any script, and the exponent of the user's locale, as ASCII; all else is left as it is.
QString withPlainDigits(const QString& text);

} // namespace spacetow
