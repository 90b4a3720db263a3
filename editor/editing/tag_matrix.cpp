#include "editor/editing/tag_matrix.h"

#include "core/level/tag_edits.h"
#include "editor/editing/collisions.h"

#include <map>

namespace spacetow {

namespace {

/// How many objects of one tag touch another tag.
struct Side {
    int touching = 0;
    int changeable = 0; // bodies; what ship, payload and finish touch is laid down
    int all = 0;

    bool isNone() const { return all > 0 && touching == 0; }
    bool isAll() const { return touching == all; }
    /// Whether no edit could make it touch.
    bool isBarred() const { return isNone() && changeable == 0; }
};

struct Counts {
    int objects = 0;
    int bodies = 0;
};

TagMatrix::Cell cellOf(const Side& one, const Side& other) {
    TagMatrix::Cell cell;
    if (one.all == 0 && other.all == 0) {
        return cell;
    }
    cell.meeting = one.isNone() || other.isNone() ? TagMeeting::None
                   : one.isAll() && other.isAll() ? TagMeeting::All
                                                  : TagMeeting::Some;
    const bool canPart = one.changeable > 0 || other.changeable > 0;
    cell.isFixed = !canPart || one.isBarred() || other.isBarred();
    return cell;
}

} // namespace

TagMatrix tagMatrix(const Level& level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Counts> filters; // few, however many objects there are
    for (const Object& object : level.objects) {
        if (const std::optional<Filter> filter = filterOf(object)) {
            Counts& counts = filters[{filter->tags.bits, filter->touches.bits}];
            ++counts.objects;
            counts.bodies += std::holds_alternative<BodyObject>(object.data) ? 1 : 0;
        }
    }
    std::array<std::array<Side, TagTable::size>, TagTable::size> sides{};
    TagMatrix matrix;
    TagMask used = level.tags.named();
    for (const auto& [filter, counts] : filters) {
        used = used | TagMask{filter.first};
        for (std::size_t a = 0; a < TagTable::size; ++a) {
            if (!TagMask{filter.first}.contains(static_cast<int>(a))) {
                continue;
            }
            matrix.objects[a] += counts.objects;
            for (std::size_t b = 0; b < TagTable::size; ++b) {
                Side& side = sides[a][b];
                side.all += counts.objects;
                side.changeable += counts.bodies;
                side.touching += TagMask{filter.second}.contains(static_cast<int>(b)) ? counts.objects : 0;
            }
        }
    }
    for (int a = 0; a < TagTable::size; ++a) {
        if (used.contains(a)) {
            matrix.tags.push_back(a);
        }
    }
    for (const int a : matrix.tags) {
        for (const int b : matrix.tags) {
            const auto i = static_cast<std::size_t>(a);
            const auto j = static_cast<std::size_t>(b);
            matrix.cells[i][j] = cellOf(sides[i][j], sides[j][i]);
        }
    }
    return matrix;
}

} // namespace spacetow
