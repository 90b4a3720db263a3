#pragma once
// The path data of SVG (attribute "d") and other lists of numbers in it. y as in the file.

#include "editor/exchange/drawing.h"

#include <optional>
#include <string_view>

namespace spacetow {

/// Reads numbers as SVG spells them: "1-.5.5e1" are three.
class NumberScanner {
  public:
    explicit NumberScanner(std::string_view text) : m_rest(text) {}

    /// Skips blanks and commas.
    void skip();
    bool atEnd() const { return m_rest.empty(); }
    char peek() const { return m_rest.front(); }
    char take();
    /// The next number, what separates it skipped; nothing when there is none.
    std::optional<double> number();
    /// A flag of an arc: one digit, which needs no separator behind it.
    std::optional<bool> flag();
    /// The letters, or the percent sign, that come next without a gap.
    std::string_view word();

  private:
    std::string_view m_rest;
};

struct PathReading {
    std::vector<DrawnPath> paths;
    bool whole = true; // else there is a mistake, and the paths are what is drawn up to it, as SVG demands
};

PathReading readPathData(std::string_view text);
/// The points of a polyline; a coordinate too many is left out.
PathReading readPointList(std::string_view text, bool closed);

} // namespace spacetow
