// Which changes make two levels different, and which of them need which.
#include "core/level/groups.h"
#include "core/level/kept_changes.h"
#include "core/level/tag_edits.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace spacetow {

namespace {

constexpr std::string_view placePart = "place";
constexpr std::string_view endsPart = "ends";
constexpr std::string_view tagsPart = "tags";
constexpr std::string_view groupPart = "group";
constexpr std::string_view orderPart = "order";
constexpr std::string_view unknownPart = "unknown";
constexpr std::string_view wholePart = "whole"; // come, gone, or of another kind

/// What of an object is changed by one entry.
std::string partOf(const std::string& id, bool isConnector) {
    struct Row {
        std::string_view id, part;
    };
    static constexpr std::array<Row, 9> rows{{{"position.x", placePart},
                                              {"position.y", placePart},
                                              {"angle", placePart},
                                              {"tags", tagsPart},
                                              {"touches", tagsPart},
                                              {"parent", groupPart},
                                              {"layer", groupPart},
                                              {"velocity.x", "velocity"},
                                              {"velocity.y", "velocity"}}};
    if (const auto found = std::ranges::find(rows, id, &Row::id); found != rows.end()) {
        return std::string(found->part);
    }
    if (isConnector && (id == "a" || id == "b" || id.starts_with("anchor"))) {
        return std::string(endsPart);
    }
    return id == "a.x" || id == "a.y" || id == "b.x" || id == "b.y" ? std::string(placePart) : id;
}

/// What an object refers to.
struct References {
    Key parent = 0;
    std::array<Key, 2> ends{0, 0};

    explicit References(const Object& object) : parent(object.parent) {
        if (const auto* connector = std::get_if<ConnectorObject>(&object.data)) {
            ends = {connector->a, connector->b};
        }
    }
    bool holds(Key key) const { return ends[0] == key || ends[1] == key; }
};

bool isGroup(const Object& object) {
    return std::holds_alternative<GroupObject>(object.data);
}

class ChangeList {
  public:
    ChangeList(const Level& before, const Level& after) : m_before(before), m_after(after) {}

    std::vector<LevelChange> changes() {
        const LevelDifference difference = differenceBetween(m_before, m_after);
        listOfLevel(difference);
        for (const ObjectDifference& object : difference.objects) {
            listOfObject(object);
        }
        needWhatBelongsToTheLevel();
        for (const LevelChange& change : m_changes) {
            if (change.object != 0) {
                needOfObject(change.what.objects.front());
            }
        }
        needWhoLetsGo();
        needAllGroupsTogether();
        for (LevelChange& change : m_changes) {
            std::ranges::sort(change.needs);
            change.needs.erase(std::unique(change.needs.begin(), change.needs.end()), change.needs.end());
        }
        return std::move(m_changes);
    }

  private:
    // The entries

    LevelChange& add() { return m_changes.emplace_back(); }
    int last() const { return static_cast<int>(m_changes.size()) - 1; }

    void listOfLevel(const LevelDifference& difference) {
        std::map<std::string, int> places; // of both parts of a point
        for (const FieldDifference& field : difference.fields) {
            const bool isPart = field.id.ends_with(".x") || field.id.ends_with(".y");
            const std::string name = isPart ? field.id.substr(0, field.id.size() - 2) : field.id;
            const auto [found, isNew] = places.emplace(name, last() + 1);
            LevelChange& change = isNew ? add() : m_changes[static_cast<std::size_t>(found->second)];
            change.what.fields.push_back(field);
        }
        for (const TagDifference& tag : difference.tags) {
            add().what.tags = {tag};
            m_tags[tag.index] = last();
        }
        if (m_before.guides != m_after.guides) {
            LevelChange& change = add();
            change.guides = true;
            change.what.guidesAdded = difference.guidesAdded;
            change.what.guidesRemoved = difference.guidesRemoved;
        }
        if (difference.hiddenProblems) {
            add().what.hiddenProblems = true;
        }
        if (difference.unknownFields) {
            add().what.unknownFields = true;
        }
    }

    void listOfObject(const ObjectDifference& object) {
        const bool isWhole =
            object.change == ObjectChange::Added || object.change == ObjectChange::Removed || object.otherKind;
        if (isWhole) {
            ObjectDifference& what = part(object.key, wholePart);
            what = object;
            what.reordered = false;
        } else {
            listParts(object);
        }
        if (object.reordered) {
            ObjectDifference& what = part(object.key, orderPart);
            what.change = ObjectChange::Reordered;
            what.reordered = true;
        }
    }
    void listParts(const ObjectDifference& object) {
        const bool isConnector = std::holds_alternative<ConnectorObject>(m_after.objects.find(object.key)->data);
        for (const FieldDifference& field : object.fields) {
            const std::string name = partOf(field.id, isConnector);
            ObjectDifference& what = part(object.key, name);
            what.fields.push_back(field);
            what.change = name == placePart  ? ObjectChange::Moved
                          : name == tagsPart ? ObjectChange::Retagged
                                             : ObjectChange::Changed;
        }
        const bool anyShape = object.shapesMoved || object.shapesChanged;
        if (anyShape) { // where the shapes are is where the body is, and the other way round
            ObjectDifference& what = part(object.key, placePart);
            what.shapesMoved = object.shapesMoved;
            what.shapesChanged = object.shapesChanged;
            what.change = object.shapesMoved ? ObjectChange::Moved : ObjectChange::Changed;
        }
        if (object.unknownFields) { // they are known by the number of the shape
            ObjectDifference& what = part(object.key, anyShape ? placePart : unknownPart);
            what.unknownFields = true;
            what.change = ObjectChange::Changed;
        }
    }
    ObjectDifference& part(Key key, std::string_view name) {
        const auto [found, isNew] = m_parts.emplace(std::pair(key, std::string(name)), last() + 1);
        if (isNew) {
            LevelChange& change = add();
            change.object = key;
            change.what.objects.push_back({.key = key});
        }
        return m_changes[static_cast<std::size_t>(found->second)].what.objects.front();
    }

    // What they need

    /// −1 for none.
    int placeOf(Key key, std::string_view part) const {
        const auto found = m_parts.find({key, std::string(part)});
        return found == m_parts.end() ? -1 : found->second;
    }
    void need(int change, int needed) {
        if (change >= 0 && needed >= 0 && change != needed) {
            m_changes[static_cast<std::size_t>(change)].needs.push_back(needed);
        }
    }
    void needEachOther(int a, int b) {
        need(a, b);
        need(b, a);
    }

    void needWhatBelongsToTheLevel() {
        for (const auto& [tag, place] : m_tags) {
            for (const auto& [other, otherPlace] : m_tags) { // no two of one name
                if (!m_after.tags[tag].name.empty() && m_after.tags[tag].name == m_before.tags[other].name) {
                    need(place, otherPlace);
                }
            }
        }
        const bool unknown = m_before.unknownFields != m_after.unknownFields;
        for (int i = 0; unknown && i < static_cast<int>(m_changes.size()); ++i) {
            const LevelChange& change = m_changes[static_cast<std::size_t>(i)];
            const bool isList = change.guides || change.what.hiddenProblems || !change.what.tags.empty();
            for (int k = 0; isList && k < static_cast<int>(m_changes.size()); ++k) {
                if (m_changes[static_cast<std::size_t>(k)].what.unknownFields) {
                    needEachOther(i, k); // they are known by the number of what has them
                }
            }
        }
    }

    void needOfObject(const ObjectDifference& object) {
        const Object* const after = m_after.objects.find(object.key);
        if (after == nullptr) {
            return;
        }
        const References refers(*after);
        const int whole = placeOf(object.key, wholePart);
        const auto needBoth = [&](std::string_view part, Key key) {
            const int needed = key == 0 ? -1 : placeOf(key, wholePart);
            need(whole, needed);
            need(placeOf(object.key, part), needed);
        };
        needBoth(groupPart, refers.parent);
        needBoth(endsPart, refers.ends[0]);
        needBoth(endsPart, refers.ends[1]);
        const TagMask tags = tagsInUse(*after);
        for (const auto& [tag, place] : m_tags) {
            if (tags.contains(tag) && m_before.tags[tag].name != m_after.tags[tag].name) {
                need(whole, place);
                need(placeOf(object.key, tagsPart), place);
            }
        }
        need(placeOf(object.key, "kind"), placeOf(object.key, placePart)); // what moves has to have an area
        need(placeOf(object.key, placePart), placeOf(object.key, "kind"));
        if (whole >= 0 && after->data.index() != ObjectData(BodyObject{}).index()) {
            needTheOnlyOne(whole, *after);
        }
    }
    /// Of ship, payload and finish there is one: that of before goes first.
    void needTheOnlyOne(int whole, const Object& object) {
        const bool isOne = std::holds_alternative<ShipObject>(object.data) ||
                           std::holds_alternative<PayloadObject>(object.data) ||
                           std::holds_alternative<FinishObject>(object.data);
        for (auto each = m_before.objects.begin(); isOne && each != m_before.objects.end(); ++each) {
            if (each->data.index() == object.data.index()) {
                need(whole, placeOf(each->key, wholePart));
            }
        }
    }

    /// Who goes, or becomes something else, has to be let go of by those that referred to it.
    void needWhoLetsGo() {
        const bool anyWhole =
            std::ranges::any_of(m_parts, [](const auto& each) { return each.first.second == wholePart; });
        for (auto each = m_before.objects.begin(); anyWhole && each != m_before.objects.end(); ++each) {
            const References refers(*each);
            const Object* const after = m_after.objects.find(each->key);
            const int whole = placeOf(each->key, wholePart);
            const auto letGo = [&](Key key, std::string_view part) {
                const bool stays = after != nullptr && (part == groupPart ? References(*after).parent == key
                                                                          : References(*after).holds(key));
                const int gone = key == 0 || stays ? -1 : placeOf(key, wholePart);
                need(gone, whole);
                need(gone, placeOf(each->key, part));
            };
            letGo(refers.parent, groupPart);
            letGo(refers.ends[0], endsPart);
            letGo(refers.ends[1], endsPart);
        }
    }

    /// Or some would come to be in each other.
    void needAllGroupsTogether() {
        int first = -1;
        for (const auto& [key, place] : m_parts) {
            const Object* const after = m_after.objects.find(key.first);
            const Object* const before = m_before.objects.find(key.first);
            const bool isMoved = after != nullptr && before != nullptr && (isGroup(*after) || isGroup(*before)) &&
                                 (key.second == groupPart || key.second == wholePart);
            if (isMoved && first >= 0) {
                needEachOther(first, place);
            } else if (isMoved) {
                first = place;
            }
        }
    }

    const Level& m_before;
    const Level& m_after;
    std::vector<LevelChange> m_changes;
    std::map<std::pair<Key, std::string>, int> m_parts;
    std::map<int, int> m_tags; // by index
};

} // namespace

std::vector<LevelChange> changesBetween(const Level& before, const Level& after) {
    return ChangeList(before, after).changes();
}

} // namespace spacetow
