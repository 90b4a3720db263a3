#include "core/level/leak.h"

#include "core/level/leak_openings.h"

#include <algorithm>
#include <limits>
#include <set>

namespace spacetow {

namespace {

constexpr double greatestShare = 0.35; // of openings in the way round a cave
constexpr double worthLookingAt = 2;   // times the cost of what closes a cave, of something better
constexpr std::size_t mostOpenings = 8;
constexpr int mostTrialsAtAll = 64; // closures that are tried before the level counts as open

/// The search in one level.
class LeakSearch {
  public:
    LeakSearch(const Level& level, std::vector<LeakWall> walls, const Vec2& ship, const std::stop_token& stop)
        : m_level(level), m_walls(std::move(walls)), m_ship(ship), m_stop(stop),
          m_mesh(m_walls, ship, leastShipWidth(), stop) {}

    std::vector<Leak> leaks() {
        std::vector<Leak> found;
        if (!m_mesh.isSound() || !escapes()) {
            return found;
        }
        // What one-way walls keep in if they are solid from both sides is lost through openings, the rest through
        // walls.
        m_mesh.shutAll(true);
        m_ends = looseEnds(m_mesh);
        if (!closeOpenings() || m_stop.stop_requested()) {
            return found;
        }
        const bool isWay = !m_openings.empty() && (isGoalBeyond() || !isSmall());
        if (!isWay) {
            for (Opening& opening : m_openings) {
                m_mesh.open(opening.closure);
                opening.leak.path = escape().points;
                m_mesh.closeAgain(opening.closure);
                found.push_back(opening.leak);
            }
        }
        if (std::optional<Leak> leak = reversedWalls(); leak && !isWay) {
            found.push_back(std::move(*leak));
        }
        return m_stop.stop_requested() ? std::vector<Leak>() : found;
    }

  private:
    struct Opening {
        int closure = -1;
        Leak leak;
    };

    bool escapes() const { return reachOf(m_mesh, m_stop).isOutside; }
    Escape escape() const { return shortestEscape(m_mesh, m_ship, 0.5 * leastShipWidth(), m_stop); }
    const LeakWall& wall(int i) const { return m_walls[static_cast<std::size_t>(i)]; }

    LeakPlace placeOf(int vertex) const {
        LeakPlace place;
        place.at = m_mesh.at(vertex);
        place.isEnd = std::ranges::binary_search(m_ends, vertex);
        if (const int i = wallAt(m_mesh, vertex); i >= 0) {
            place.object = wall(i).object;
            place.shape = wall(i).shape;
            place.segment = wall(i).segment;
            if (place.isEnd) { // without the rounding of the mesh
                const bool isA = (wall(i).a - place.at).norm() < (wall(i).b - place.at).norm();
                place.at = isA ? wall(i).a : wall(i).b;
            }
        }
        return place;
    }

    /// False when no few closures enclose the ship.
    bool closeOpenings() {
        while (m_openings.size() < mostOpenings) {
            const Escape way = escape();
            if (way.edges.empty() || m_stop.stop_requested()) {
                dropNeedless();
                return true;
            }
            const std::optional<Opening> opening = openingOn(way.points);
            if (!opening) {
                return false;
            }
            m_openings.push_back(*opening);
        }
        return !escapes();
    }

    /// What is closed to keep the ship from this way: what keeps it in altogether, else what is likeliest.
    std::optional<Opening> openingOn(const std::vector<Vec2>& points) {
        constexpr int mostTrials = 16;
        constexpr double furthest = 50; // m, of a wall from the end of another
        OpeningSides sides{endsBeside(m_mesh, m_ends, points), {}};
        for (const int end : sides.ends) {
            for (const int nearest : m_mesh.addNearestTo(end, furthest)) {
                sides.nearestWalls.emplace_back(end, nearest);
            }
        }
        const Escape way = escape(); // the same, through what is there now
        Choice choice;
        int trials = 0;
        for (const Closure& closure : likelyClosures(m_mesh, m_walls, sides, way)) {
            const bool isDear = choice.isEnough && closure.cost > worthLookingAt * choice.cost;
            if (isDear || trials == mostTrials || m_trials > mostTrialsAtAll || m_stop.stop_requested()) {
                break;
            }
            trials += consider(closure, choice) ? 1 : 0;
        }
        if (choice.mesh) {
            m_mesh = std::move(*choice.mesh);
        }
        return choice.opening;
    }

    /// What would be closed, and how good that is.
    struct Choice {
        std::optional<Opening> opening;
        std::optional<LeakMesh> mesh; // in which it is closed
        bool isEnough = false;        // nothing is open then
        double cost = 0;              // of the first that is enough
        std::size_t shapes = 0;       // that keep the ship in then
    };

    /// Of those that are enough, what makes use of the most walls; of those that are not, the first. False where there
    /// is no room for it.
    bool consider(const Closure& closure, Choice& choice) {
        LeakMesh trial = m_mesh;
        const int number = trial.close(closure.a, closure.b);
        if (number < 0) {
            return false;
        }
        ++m_trials;
        const Reach reach = reachOf(trial, m_stop);
        const bool isEnough = !reach.isOutside;
        if (isEnough && !choice.isEnough) {
            choice = {{}, {}, true, closure.cost, 0};
        }
        const std::size_t shapes = isEnough ? shapesAround(trial, reach).size() : 0;
        if (!choice.opening || (isEnough && shapes > choice.shapes)) {
            choice.opening = Opening{number, {Leak::Kind::Opening, placeOf(closure.a), placeOf(closure.b)}};
            choice.opening->leak.width = (m_mesh.at(closure.a) - m_mesh.at(closure.b)).norm();
            choice.mesh = std::move(trial);
            choice.shapes = shapes;
        }
        return true;
    }

    std::set<std::pair<int, int>> shapesAround(const LeakMesh& mesh, const Reach& reach) const {
        std::set<std::pair<int, int>> shapes;
        for (int edge = 0; edge < mesh.net().edgeCount(); ++edge) {
            const int i = reach.triangles[static_cast<std::size_t>(edge / 3)] != 0 ? mesh.wallOn(edge) : -1;
            if (i >= 0) {
                shapes.insert(shapeOf(i));
            }
        }
        return shapes;
    }

    void dropNeedless() {
        std::erase_if(m_openings, [this](const Opening& opening) {
            if (m_openings.size() == 1) {
                return false;
            }
            m_mesh.open(opening.closure);
            if (!escapes()) {
                return true;
            }
            m_mesh.closeAgain(opening.closure);
            return false;
        });
    }

    /// Whether payload or finish are where the ship only gets through the openings.
    bool isGoalBeyond() const {
        const Reach reach = reachOf(m_mesh, m_stop);
        const auto isBeyond = [&](const Vec2& place) {
            return isFinite(place) && reach.triangles[static_cast<std::size_t>(m_mesh.triangleAt(place))] == 0;
        };
        const Object* payload = firstOf<PayloadObject>(m_level);
        const Object* finish = firstOf<FinishObject>(m_level);
        if (payload != nullptr && isBeyond(std::get<PayloadObject>(payload->data).position)) {
            return true;
        }
        if (finish == nullptr) {
            return false;
        }
        const auto& line = std::get<FinishObject>(finish->data);
        return isBeyond(line.a) && isBeyond(line.b) && isBeyond(0.5 * (line.a + line.b));
    }

    /// Whether the openings are little of the way round what the ship can reach.
    bool isSmall() const {
        const Reach reach = reachOf(m_mesh, m_stop);
        double walls = 0;
        double openings = 0;
        for (int edge = 0; edge < m_mesh.net().edgeCount(); ++edge) {
            if (reach.triangles[static_cast<std::size_t>(edge / 3)] == 0 || m_mesh.lets(edge)) {
                continue;
            }
            const double length = (m_mesh.at(m_mesh.net().origin(edge)) - m_mesh.at(m_mesh.net().target(edge))).norm();
            (m_mesh.isClosure(edge) ? openings : walls) += length;
        }
        return openings <= greatestShare * (openings + walls);
    }

    /// One-way walls whose backs keep the ship in as long as they are shut, with nothing but the outside behind.
    std::set<int> wallsFromBehind() const {
        const Reach reach = reachOf(m_mesh, m_stop);
        std::set<int> walls;
        for (int edge = 0; edge < m_mesh.net().edgeCount(); ++edge) {
            const int i = m_mesh.wallFromBehind(edge);
            if (i >= 0 && reach.triangles[static_cast<std::size_t>(edge / 3)] != 0 &&
                reach.triangles[static_cast<std::size_t>(m_mesh.net().twin(edge) / 3)] == 0) {
                walls.insert(i);
            }
        }
        return walls;
    }

    bool isClosedBy(const std::set<int>& walls) {
        m_mesh.shutAll(false);
        for (const int i : walls) {
            m_mesh.shut(i, true);
        }
        return !escapes();
    }

    std::optional<Leak> reversedWalls() {
        const std::set<int> behind = wallsFromBehind();
        m_mesh.shutAll(false);
        const Escape way = escape();
        if (way.edges.empty()) {
            return {};
        }
        std::set<int> crossed;
        for (const int edge : way.edges) {
            if (const int i = m_mesh.wallFromBehind(edge); behind.contains(i)) {
                crossed.insert(i);
            }
        }
        std::set<int> related;
        for (const int i : behind) {
            const auto isSame = [&](int k) { return shapeOf(k) == shapeOf(i); };
            if (std::ranges::any_of(crossed, isSame)) {
                related.insert(i);
            }
        }
        for (const std::set<int>& some : {crossed, related, behind}) {
            if (!some.empty() && isClosedBy(some)) {
                return reversedLeak(some, way);
            }
        }
        return {};
    }

    Leak reversedLeak(const std::set<int>& walls, const Escape& way) const {
        const LeakWall& first = wall(*walls.begin());
        const auto place = [&first](const Vec2& at) {
            return LeakPlace{first.object, first.shape, first.segment, false, at};
        };
        Leak leak{Leak::Kind::Reversed, place(first.a), place(first.b)};
        leak.walls = static_cast<int>(walls.size());
        leak.isWhole = areWholeShape(walls);
        if (leak.isWhole) {
            const auto isOfShape = [&](const LeakWall& other) {
                return other.object == first.object && other.shape == first.shape;
            };
            leak.walls = static_cast<int>(std::ranges::count_if(m_walls, isOfShape));
        }
        for (const int i : walls) {
            leak.width += (wall(i).b - wall(i).a).norm();
        }
        leak.path = way.points;
        return leak;
    }

    /// Whether they are of one shape, of which the ship, kept in by them, meets no other wall: what is behind rocks
    /// may be turned with the rest.
    bool areWholeShape(const std::set<int>& walls) const {
        const auto shape = shapeOf(*walls.begin());
        if (std::ranges::any_of(walls, [&](int i) { return shapeOf(i) != shape; })) {
            return false;
        }
        const Reach reach = reachOf(m_mesh, m_stop);
        for (int edge = 0; edge < m_mesh.net().edgeCount(); ++edge) {
            const int i = reach.triangles[static_cast<std::size_t>(edge / 3)] != 0 ? m_mesh.wallOn(edge) : -1;
            if (i >= 0 && shapeOf(i) == shape && !walls.contains(i)) {
                return false;
            }
        }
        return true;
    }

    std::pair<int, int> shapeOf(int i) const { return {wall(i).object, wall(i).shape}; }

    const Level& m_level;
    std::vector<LeakWall> m_walls;
    Vec2 m_ship;
    const std::stop_token& m_stop;
    LeakMesh m_mesh;
    std::vector<int> m_ends; // ascending
    std::vector<Opening> m_openings;
    int m_trials = 0;
};

} // namespace

double leastShipWidth() {
    const std::array<Vec2, 4> outline = shipOutline();
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& a : outline) {
        for (const Vec2& b : outline) {
            // All is on one side of a line through two corners of the hull; where that is no side of it, it is wider.
            double low = 0;
            double high = 0;
            for (const Vec2& c : outline) {
                const double above = a == b ? 0 : cross(b - a, c - a) / (b - a).norm();
                low = std::min(low, above);
                high = std::max(high, above);
            }
            least = a == b ? least : std::min(least, high - low);
        }
    }
    return least;
}

std::vector<Leak> leaksOf(const Level& level, const std::function<bool(int object)>& isBad,
                          const std::stop_token& stop) {
    const Object* ship = firstOf<ShipObject>(level);
    if (ship == nullptr || !isFinite(std::get<ShipObject>(ship->data).position)) {
        return {};
    }
    std::vector<LeakWall> walls = leakWalls(level, isBad);
    if (walls.empty()) {
        return {};
    }
    return LeakSearch(level, std::move(walls), std::get<ShipObject>(ship->data).position, stop).leaks();
}

} // namespace spacetow
