#pragma once
// The fixtures of a body of R.U.B.E. as shapes of a body of a level.

#include "core/level/json_tree.h"
#include "core/level/level.h"
#include "editor/exchange/report.h"

#include <array>
#include <string>

namespace spacetow {

/// Tags for the 16 bits of Box2D's filters, named as the scene names them. The first is the tag of walls.
class RubeTags {
  public:
    explicit RubeTags(const JsonView& root);

    Filter filterOf(const JsonView& fixture);
    const TagTable& table() const { return m_table; }

  private:
    int tagOf(int bit);
    TagTable m_table;
    std::array<std::string, 16> m_names;
};

/// A number that must lie in a range; what does not is brought there and reported as "import-range".
struct RubeRange {
    const char* name;
    double least, most;
    double otherwise;
};
double rubeNumber(const JsonView& object, const RubeRange& range, Report& report);

/// Shapes, material and filter of the body. One friction, restitution and density, and one filter, hold for all of its
/// fixtures here: where they differ those of the first are taken and it is reported.
void addFixtures(const JsonView& body, BodyObject& out, RubeTags& tags, Report& report);

} // namespace spacetow
