#pragma once
// What the parts of lint share: the list of problems they add to, and the checks one by one.

#include "core/level/problem.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spacetow {

/// What a problem is about: an object (its place in the level) or, with index −1, the level.
struct FindingPlace {
    int index = -1;
    Key key = 0;
    std::string path; // continues the pointer
};

class Findings {
  public:
    void add(Severity severity, const char* code, std::vector<std::string> arguments, const FindingPlace& place = {});
    /// Whether an error was found in this object so far: its numbers and shapes are then not to be trusted.
    bool isBad(int index) const { return m_bad.contains(index); }
    /// In the order of the objects, those of the level first.
    std::vector<Problem> sorted() &&;

  private:
    std::vector<std::pair<int, Problem>> m_found;
    std::set<int> m_bad;
};

// The checks, in the order in which they have to run.

/// Names of tags that could not be read back, or told apart.
void checkTags(const Level& level, Findings& findings);
/// Keys that are zero or taken.
void checkKeys(const Level& level, Findings& findings);
/// Numbers that are not finite or out of their range, in all objects and the level itself.
void checkRanges(const Level& level, Findings& findings);
/// Shapes that cannot be built: too few vertices, crossing sides, no length, no area.
void checkShapes(const Level& level, Findings& findings);
/// Bodies so small or light, or so large and heavy, that the physics cannot reckon with them and takes no such body.
void checkMasses(const Level& level, Findings& findings);
/// Bodies that no other can touch.
void checkFilters(const Level& level, Findings& findings);
/// Parents that are missing, no groups, or in a circle; layers that are not at the top; a hidden ship.
void checkGroups(const Level& level, Findings& findings);
/// Connectors without their ends, and springs that the sub-steps are too long for.
void checkConnectors(const Level& level, Findings& findings);
/// Ship, payload and finish: one each, or none at all in a sandbox; ship and payload free of the walls.
void checkStart(const Level& level, Findings& findings);

} // namespace spacetow
