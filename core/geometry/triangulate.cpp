#include "core/geometry/triangulate.h"

#include "core/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace spacetow {

namespace {

constexpr double flat = 1e-12;           // sine below which a corner counts as straight
constexpr std::size_t fewVertices = 200; // up to here the best ear is looked for, beyond it the next one will do

using Piece = std::vector<int>;

/// A straight or folded corner b between a and c, or one that repeats a neighbour.
bool addsNothing(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 u = b - a;
    const Vec2 v = c - b;
    const double scale = u.norm() * v.norm();
    return !(std::fabs(cross(u, v)) > flat * scale);
}

/// Clips ears from a doubly linked ring of vertices. What was found of a corner is kept until it changes: clipping an
/// ear changes the triangles of its two neighbours alone, and a reflex corner that is in the way stays there until it
/// is clipped or no longer reflex.
class EarClipper {
  public:
    EarClipper(std::span<const Vec2> outline, std::size_t* looks)
        : m_points(outline), m_ring(outline.size()), m_isReflex(outline.size(), false),
          m_found(outline.size(), unknown), m_left(outline.size()), m_looks(looks) {
        const int count = static_cast<int>(outline.size());
        for (int i = 0; i < count; ++i) {
            m_ring[at(i)] = {(i + count - 1) % count, (i + 1) % count};
        }
        for (int i = 0; i < count; ++i) {
            if (turn(i) <= 0) {
                m_reflex.push_back(i);
                m_isReflex[at(i)] = true;
            }
        }
        std::sort(m_reflex.begin(), m_reflex.end(), [this](int i, int j) { return isLeftOf(i, j); });
    }

    std::vector<Piece> triangles() {
        std::vector<Piece> result;
        int current = 0;
        while (m_left > 3) {
            const int ear = m_left <= fewVertices ? bestEar(current) : nextEar(current);
            const int before = m_ring[at(ear)].before;
            const int after = m_ring[at(ear)].after;
            if (turn(ear) > 0) {
                result.push_back({before, ear, after});
            }
            m_ring[at(before)].after = after;
            m_ring[at(after)].before = before;
            forgetReflex(ear);
            for (const int neighbour : {before, after}) {
                m_found[at(neighbour)] = unknown;
                if (turn(neighbour) > 0) {
                    forgetReflex(neighbour);
                }
            }
            --m_left;
            current = after;
        }
        if (turn(current) > 0) {
            result.push_back({m_ring[at(current)].before, current, m_ring[at(current)].after});
        }
        return result;
    }

  private:
    struct Link {
        int before, after;
    };
    // What is known of a corner, if not the number of a reflex one in its triangle.
    static constexpr int unknown = -1;
    static constexpr int nobody = -2; // is in its triangle

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    bool isLeftOf(int i, int j) const {
        return m_points[at(i)].x() != m_points[at(j)].x() ? m_points[at(i)].x() < m_points[at(j)].x() : i < j;
    }

    void forgetReflex(int i) {
        if (m_isReflex[at(i)]) {
            m_isReflex[at(i)] = false;
            m_reflex.erase(
                std::lower_bound(m_reflex.begin(), m_reflex.end(), i, [this](int a, int b) { return isLeftOf(a, b); }));
        }
    }

    /// Twice the area of the triangle at corner i.
    double turn(int i) const {
        const Vec2& p = m_points[at(i)];
        return cross(p - m_points[at(m_ring[at(i)].before)], m_points[at(m_ring[at(i)].after)] - p);
    }

    bool isEar(int i) {
        if (turn(i) <= 0) {
            return false;
        }
        int& found = m_found[at(i)];
        if (found == unknown || (found != nobody && !m_isReflex[at(found)])) {
            found = someoneIn(i);
        }
        return found == nobody;
    }

    /// A reflex corner in the triangle at corner i, its own corners apart.
    int someoneIn(int i) {
        const Vec2& a = m_points[at(m_ring[at(i)].before)];
        const Vec2& b = m_points[at(i)];
        const Vec2& c = m_points[at(m_ring[at(i)].after)];
        // Rounding takes what is hardly beside a triangle as in it, and in line with one that is hardly any, far away
        // too.
        constexpr double hardly = 1e-6;
        const auto [least, most] = std::minmax({a.x(), b.x(), c.x()});
        const double room = quality(i) > hardly ? hardly * (most - least) : std::numeric_limits<double>::infinity();
        const double left = least - room;
        const double right = most + room;
        auto next = std::lower_bound(m_reflex.begin(), m_reflex.end(), left,
                                     [this](int j, double x) { return m_points[at(j)].x() < x; });
        for (; next != m_reflex.end() && m_points[at(*next)].x() <= right; ++next) {
            const Vec2& p = m_points[at(*next)];
            *m_looks += 1;
            if (p != a && p != b && p != c && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
                cross(a - c, p - c) >= 0) {
                return *next;
            }
        }
        return nobody;
    }

    /// Height of the triangle at corner i over its longest side in relation to that side: slivers score low.
    double quality(int i) const {
        const Vec2& a = m_points[at(m_ring[at(i)].before)];
        const Vec2& b = m_points[at(i)];
        const Vec2& c = m_points[at(m_ring[at(i)].after)];
        return turn(i) / std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    }

    /// Without any ear, as in an outline that crosses itself, the best convex corner, or any at all.
    int bestEar(int start) {
        int best = start;
        double bestScore = -1e300;
        int i = start;
        do {
            const double score = quality(i) + (turn(i) > 0 && isEar(i) ? 2 : 0);
            if (score > bestScore) {
                best = i;
                bestScore = score;
            }
            i = m_ring[at(i)].after;
        } while (i != start);
        return best;
    }

    int nextEar(int start) {
        int i = start;
        do {
            if (isEar(i)) {
                return i;
            }
            i = m_ring[at(i)].after;
        } while (i != start);
        return start;
    }

    std::span<const Vec2> m_points;
    std::vector<Link> m_ring;
    std::vector<int> m_reflex; // from left to right
    std::vector<bool> m_isReflex;
    std::vector<int> m_found;
    std::size_t m_left = 0;
    std::size_t* m_looks;
};

/// A side shared by two pieces: from → to in the first, to → from in the second.
struct Diagonal {
    double lengthSquared;
    int from, to;
    std::size_t first, second;
};

std::vector<Diagonal> diagonalsOf(std::span<const Vec2> outline, const std::vector<Piece>& pieces) {
    struct DirectedSide {
        std::array<int, 2> key;
        int from;
        std::size_t piece;
    };
    std::vector<DirectedSide> sides;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (std::size_t k = 0; k < pieces[p].size(); ++k) {
            const int i = pieces[p][k];
            const int j = pieces[p][(k + 1) % pieces[p].size()];
            sides.push_back({{std::min(i, j), std::max(i, j)}, i, p});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const DirectedSide& s, const DirectedSide& t) {
        return s.key != t.key ? s.key < t.key : s.from < t.from;
    });
    std::vector<Diagonal> diagonals;
    for (std::size_t k = 1; k < sides.size(); ++k) {
        const DirectedSide& s = sides[k - 1];
        const DirectedSide& t = sides[k];
        if (s.key == t.key && s.from != t.from) {
            const Vec2 along = outline[static_cast<std::size_t>(t.from)] - outline[static_cast<std::size_t>(s.from)];
            diagonals.push_back({along.squaredNorm(), s.from, t.from, s.piece, t.piece});
        }
    }
    std::sort(diagonals.begin(), diagonals.end(), [](const Diagonal& s, const Diagonal& t) {
        return s.lengthSquared != t.lengthSquared ? s.lengthSquared > t.lengthSquared
                                                  : std::array{s.from, s.to} < std::array{t.from, t.to};
    });
    return diagonals;
}

/// The pieces on both sides of from → to as one, starting at `to`.
Piece merged(const Piece& first, const Piece& second, int from, int to) {
    Piece result(first);
    std::rotate(result.begin(), std::find(result.begin(), result.end(), to), result.end());
    Piece rest(second);
    std::rotate(rest.begin(), std::find(rest.begin(), rest.end(), from), rest.end());
    result.insert(result.end(), rest.begin() + 1, rest.end() - 1); // both diagonal ends are in the first one already
    return result;
}

bool isConvex(std::span<const Vec2> outline, const Piece& piece) {
    const std::size_t count = piece.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2& a = outline[static_cast<std::size_t>(piece[k])];
        const Vec2& b = outline[static_cast<std::size_t>(piece[(k + 1) % count])];
        const Vec2& c = outline[static_cast<std::size_t>(piece[(k + 2) % count])];
        if (cross(b - a, c - b) < -flat * (b - a).norm() * (c - b).norm()) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<Vec2> cleanOutline(std::span<const Vec2> outline) {
    std::vector<Vec2> kept(outline.begin(), outline.end());
    bool changed = true;
    while (changed && kept.size() >= 3) { // removing a spike can straighten the corners beside it
        changed = false;
        std::vector<Vec2> next;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const Vec2& before = next.empty() ? kept.back() : next.back();
            if (addsNothing(before, kept[i], kept[(i + 1) % kept.size()])) {
                changed = true;
            } else {
                next.push_back(kept[i]);
            }
        }
        kept = std::move(next);
    }
    if (kept.size() >= 3 && signedArea(kept) < 0) {
        std::reverse(kept.begin(), kept.end());
    }
    return kept.size() >= 3 ? kept : std::vector<Vec2>{};
}

std::vector<std::vector<int>> convexPieces(std::span<const Vec2> outline, int maxCorners, std::size_t* looks) {
    if (outline.size() < 3) {
        return {};
    }
    std::size_t uncounted = 0;
    Piece whole(outline.size());
    std::iota(whole.begin(), whole.end(), 0);
    if (outline.size() <= static_cast<std::size_t>(maxCorners) && isConvex(outline, whole) && isSimple(outline)) {
        return {whole};
    }
    std::vector<Piece> pieces = EarClipper(outline, looks != nullptr ? looks : &uncounted).triangles();
    std::vector<std::size_t> home(pieces.size()); // where a piece went, by following the numbers
    std::iota(home.begin(), home.end(), 0u);
    const auto find = [&home](std::size_t p) {
        while (home[p] != p) {
            p = home[p] = home[home[p]];
        }
        return p;
    };
    for (const Diagonal& diagonal : diagonalsOf(outline, pieces)) {
        const std::size_t first = find(diagonal.first);
        const std::size_t second = find(diagonal.second);
        const std::size_t corners = pieces[first].size() + pieces[second].size() - 2;
        if (first == second || corners > static_cast<std::size_t>(maxCorners)) {
            continue;
        }
        Piece joined = merged(pieces[first], pieces[second], diagonal.from, diagonal.to);
        if (isConvex(outline, joined)) {
            pieces[first] = std::move(joined);
            pieces[second].clear();
            home[second] = first;
        }
    }
    std::erase_if(pieces, [](const Piece& piece) { return piece.empty(); });
    return pieces;
}

} // namespace spacetow
