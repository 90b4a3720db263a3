#include "core/level/groups.h"
#include "core/level/key_text.h"
#include "core/level/lint_findings.h"

namespace spacetow {

namespace {

bool isPlayed(const Object& object) {
    return std::holds_alternative<ShipObject>(object.data) || std::holds_alternative<PayloadObject>(object.data) ||
           std::holds_alternative<FinishObject>(object.data);
}

/// Stops the ship or the payload, or may meet them.
bool isInTheWay(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr && body->tangible && !body->shapes.empty();
}

bool fliesAShip(const Level& level) {
    for (const Object& object : level.objects) {
        if (std::holds_alternative<ShipObject>(object.data)) {
            return true;
        }
    }
    return false;
}

/// The object, or the outermost of the groups it is in, that is hidden itself.
const Object& hiddenBy(const GroupTree& tree, const Object& object) {
    const Object* hidden = &object;
    for (const Object* each = &object; each != nullptr; each = tree.parentOf(*each)) {
        hidden = each->visible ? hidden : each;
    }
    return *hidden;
}

} // namespace

/// Warnings alone: the game does not ask who is in which group.
void checkGroups(const Level& level, Findings& findings) {
    const GroupTree tree(level);
    bool mayTellOfBody = fliesAShip(level); // of the first alone: while one draws, many may be hidden
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        const FindingPlace place{i, object.key, "/parent"};
        const Object* parent = object.parent == 0 ? nullptr : level.objects.find(object.parent);
        const auto* group = std::get_if<GroupObject>(&object.data);
        if (object.parent != 0 && parent == nullptr) {
            findings.add(Severity::Warning, "parent-missing", {keyText(object.parent)}, place);
        } else if (parent != nullptr && !std::holds_alternative<GroupObject>(parent->data)) {
            findings.add(Severity::Warning, "parent-no-group", {keyText(object.parent)}, place);
        } else if (parent != nullptr && group != nullptr && tree.parentOf(object) != parent) {
            findings.add(Severity::Warning, "parent-circle", {keyText(object.parent)}, place);
        } else if (parent != nullptr && group != nullptr && group->layer) {
            findings.add(Severity::Warning, "layer-in-group", {}, {i, object.key, "/layer"});
        }
        if (isPlayed(object) && !tree.isVisible(object)) {
            findings.add(Severity::Warning, "hidden-in-play", {}, {i, object.key, "/visible"});
        } else if (mayTellOfBody && isInTheWay(object) && !tree.isVisible(object)) {
            mayTellOfBody = false;
            const Object& hidden = hiddenBy(tree, object);
            findings.add(Severity::Warning, "hidden-in-play", {},
                         {level.objects.indexOf(hidden.key), hidden.key, "/visible"});
        }
    }
}

} // namespace spacetow
