#pragma once
// Arithmetic of numbers as they are written, without the last bit's noise.

namespace spacetow {

/// Sum as of the shortest decimal spellings: 0.1 and 0.2 make 0.3. That of doubles where more digits would be needed
/// than a double has.
double decimalSum(double a, double b);
/// `count` times the number as it is written: 3 times 0.1 is 0.3.
double decimalMultiple(double number, int count);

} // namespace spacetow
