#include "core/level/arrays.h"

#include "core/base/contract.h"
#include "core/base/overloaded.h"
#include "core/base/random.h"
#include "core/level/arrange.h"
#include "core/level/groups.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <map>
#include <set>

namespace spacetow {

namespace {

bool isSingle(const ObjectData& data) {
    return std::holds_alternative<ShipObject>(data) || std::holds_alternative<PayloadObject>(data) ||
           std::holds_alternative<FinishObject>(data);
}

std::vector<Object> originalsOf(const Level& level, std::span<const Key> keys) {
    const std::vector<Key> wanted = withMembers(level, keys);
    std::vector<Object> originals;
    for (const Object& object : level.objects) {
        if (std::ranges::binary_search(wanted, object.key) && !isSingle(object.data)) {
            originals.push_back(object);
        }
    }
    return originals;
}

int copiesOf(const ArraySpec& spec) {
    return std::visit([](const auto& array) { return std::max(array.copies, 0); }, spec);
}

/// Where the copy of that number comes to be; `middle` is that of the originals.
Affine mapOf(const ArraySpec& spec, int number, const Vec2& middle) {
    return std::visit(Overloaded{[&](const LinearArray& array) {
                                     return Affine::translation(static_cast<double>(number) * array.step);
                                 },
                                 [&](const RadialArray& array) {
                                     const Affine turn = Affine::rotation(array.center, number * array.angle);
                                     return array.turns ? turn : Affine::translation(turn(middle) - middle);
                                 }},
                      spec);
}

/// Gives out keys that the level does not have.
class FreshKeys {
  public:
    FreshKeys(const Level& level, std::uint64_t seed) : m_level(level), m_random(seed) {}
    Key next() {
        Key key = 0;
        do {
            key = static_cast<Key>(m_random.next());
        } while (key == 0 || m_level.objects.find(key) != nullptr || !m_given.insert(key).second);
        return key;
    }

  private:
    const Level& m_level;
    Random m_random;
    std::set<Key> m_given;
};

/// Whether the connector joins two that are copied; it then joins the copies.
bool joinCopies(ConnectorObject& connector, const std::map<Key, Key>& copyOf) {
    const auto a = copyOf.find(connector.a);
    const auto b = copyOf.find(connector.b);
    if (a == copyOf.end() || b == copyOf.end()) {
        return false;
    }
    connector.a = a->second;
    connector.b = b->second;
    return true;
}

} // namespace

std::int64_t arraySize(const Level& level, std::span<const Key> keys, const ArraySpec& spec) {
    return static_cast<std::int64_t>(originalsOf(level, keys).size()) * copiesOf(spec);
}

Level arrayed(Level level, std::span<const Key> keys, const ArrayPlace& place, std::vector<Key>& copies) {
    const ArraySpec& spec = place.spec;
    EXPECTS(arraySize(level, keys, spec) <= maxArrayObjects);
    copies.clear();
    const std::vector<Object> originals = originalsOf(level, keys);
    const Aabb box = placedBounds(level, keys);
    const Vec2 middle = box.isEmpty() ? Vec2(0, 0) : box.center();
    const Level before = level;
    FreshKeys fresh(before, place.seed);
    for (int number = 1; number <= copiesOf(spec); ++number) {
        const Affine map = mapOf(spec, number, middle);
        std::map<Key, Key> copyOf;
        for (const Object& original : originals) {
            copyOf.emplace(original.key, fresh.next());
        }
        for (const Object& original : originals) {
            Object copy = original;
            auto* connector = std::get_if<ConnectorObject>(&copy.data);
            if (connector != nullptr && !joinCopies(*connector, copyOf)) {
                continue;
            }
            copy.key = copyOf.at(original.key);
            const auto parent = copyOf.find(original.parent);
            if (parent != copyOf.end()) {
                copy.parent = parent->second;
            } else {
                copies.push_back(copy.key);
            }
            transform(copy.data, map);
            level.objects.append(std::move(copy));
        }
    }
    return level;
}

} // namespace spacetow
