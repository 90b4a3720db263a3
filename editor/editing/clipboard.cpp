#include "editor/editing/clipboard.h"

#include "core/base/random.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/editing/verbs.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace spacetow {

namespace {

/// Fresh keys for many objects at once; asking the level for each would be quadratic.
class KeySource {
  public:
    KeySource(const Level& level, std::uint64_t seed) : m_random(seed) {
        for (const Object& object : level.objects) {
            m_used.insert(object.key);
        }
    }
    Key next() {
        Key key = 0;
        do {
            key = m_random.next();
        } while (key == 0 || !m_used.insert(key).second);
        return key;
    }

  private:
    Random m_random;
    std::set<Key> m_used;
};

/// Whether the level has its only object of this kind already.
bool isTaken(const Level& level, const ObjectData& data) {
    return (std::holds_alternative<ShipObject>(data) && firstOf<ShipObject>(level)) ||
           (std::holds_alternative<PayloadObject>(data) && firstOf<PayloadObject>(level)) ||
           (std::holds_alternative<FinishObject>(data) && firstOf<FinishObject>(level));
}

struct Pasted {
    Level level;
    std::vector<Key> keys;
    Aabb bounds;
};

Pasted withObjects(Level level, std::vector<Object> objects, std::uint64_t seed) {
    KeySource source(level, seed);
    Pasted pasted{std::move(level), {}, {}};
    std::map<Key, Key> fresh; // of the keys in the text
    const auto append = [&](Object object) {
        object.key = fresh[object.key] = source.next();
        pasted.keys.push_back(object.key);
        pasted.level.objects.append(std::move(object));
    };
    const auto connectors = std::stable_partition(objects.begin(), objects.end(), [](const Object& object) {
        return !std::holds_alternative<ConnectorObject>(object.data);
    });
    std::for_each(objects.begin(), connectors, [&](Object& object) {
        if (!isTaken(pasted.level, object.data)) {
            pasted.bounds.include(boundsOf(pasted.level, object));
            append(std::move(object));
        }
    });
    std::for_each(connectors, objects.end(), [&](Object& object) {
        auto& connector = std::get<ConnectorObject>(object.data);
        if (fresh.contains(connector.a) && fresh.contains(connector.b)) {
            connector.a = fresh[connector.a];
            connector.b = fresh[connector.b];
            append(std::move(object));
        }
    });
    return pasted;
}

} // namespace

std::string copied(const Edit& edit) {
    return edit.selection.empty() ? std::string() : objectsText(*edit.level, edit.selection.keys());
}

std::optional<FinishedEdit> cut(const ToolContext& context) {
    std::optional<FinishedEdit> finished = removeSelected(context);
    if (finished) {
        finished->label.code = "cut";
    }
    return finished;
}

std::optional<FinishedEdit> pasted(const ToolContext& context, std::string_view text, const std::optional<Vec2>& at) {
    const Level& level = *context.edit.level;
    std::vector<Problem> problems;
    Pasted result = withObjects(level, parseObjects(text, level.tags, problems), context.seed);
    if (result.keys.empty()) {
        return {};
    }
    if (at && !result.bounds.isEmpty()) {
        Vec2 delta = *at - result.bounds.center();
        if (context.snap.grid && context.snap.step > 0) {
            delta = onGrid(context.snap, delta);
        }
        result.level = moved(std::move(result.level), result.keys, delta);
    }
    const Label label{"paste", static_cast<int>(result.keys.size())};
    return FinishedEdit{label,
                        {std::make_shared<const Level>(std::move(result.level)), Selection(std::move(result.keys))}};
}

} // namespace spacetow
