#pragma once
// What the parts of lint share: the list of problems they add to, and the checks one by one.

#include "core/level/problem.h"

#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace spacetow {

/// What a problem is about: an object (its place in the level) or, with index −1, the level.
struct FindingPlace {
    int index = -1;
    Key key = 0;
    std::string path;             // continues the pointer
    std::vector<Vec2> place = {}; // as in Problem
    std::vector<Vec2> wayOut = {};
};

class Findings {
  public:
    explicit Findings(std::stop_token stop = {}) : m_stop(std::move(stop)) {}

    /// What takes long asks now and then.
    bool isStopped() const { return m_stop.stop_requested(); }
    const std::stop_token& stop() const { return m_stop; }
    void add(Severity severity, LevelCode code, std::vector<std::string> arguments, const FindingPlace& place = {});
    /// The first of the problems found so far for which `isIt(index, problem)`; null when there is none.
    template <class IsIt>
    Problem* find(IsIt isIt) {
        for (auto& [index, problem] : m_found) {
            if (isIt(index, problem)) {
                return &problem;
            }
        }
        return nullptr;
    }
    /// Whether an error was found in this object so far: its numbers and shapes are then not to be trusted.
    bool isBad(int index) const { return m_bad.contains(index); }
    /// In the order of the objects, those of the level first.
    std::vector<Problem> sorted() &&;

  private:
    std::stop_token m_stop;
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
/// Whether the game can be won at all: the finish itself, the pull of gravity, what flies through what.
void checkGame(const Level& level, Findings& findings);
/// What is wrong with walls as a whole; see lint_walls.h.
void checkWalls(const Level& level, Findings& findings);
/// Objects that are there twice.
void checkTwins(const Level& level, Findings& findings);
/// Where the ship can get out of its cave; see leak.h.
void checkLeaks(const Level& level, Findings& findings);

/// How a sentence names an object: its name, and for those without one what it is and where its middle is.
std::vector<std::string> whichObject(const Level& level, const Object& object, const BodyObject& body);
/// Whether the object, ship or payload, touches nothing that it would be stopped by. Bodies that cannot be built are
/// `unsound`.
bool startsFree(const Level& level, const Object& object, const std::set<Key>& unsound);
/// Vertices of an outline that lie exactly on the straight way from the one before to the one after.
std::vector<int> idlePoints(const std::vector<Vec2>& vertices, bool closed);
/// Rounded to centimetres.
std::string metres(double value);

} // namespace spacetow
