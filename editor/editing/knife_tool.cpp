#include "editor/editing/knife_tool.h"

#include "core/level/groups.h"
#include "core/level/knife.h"
#include "editor/editing/snap_point.h"

namespace spacetow {

namespace {

std::vector<Key> keysToCut(const Edit& edit) {
    std::vector<Key> keys = edit.selection.keys();
    const GroupTree tree(*edit.level);
    if (keys.empty()) {
        for (const Object& object : edit.level->objects) {
            keys.push_back(object.key);
        }
    }
    keys = withMembers(*edit.level, keys);
    std::erase_if(keys, [&](Key key) {
        const Object* object = edit.level->objects.find(key);
        return object == nullptr || !tree.isVisible(*object) || tree.isLocked(*object);
    });
    return keys;
}

class KnifeGesture : public Gesture {
  public:
    KnifeGesture(const ToolContext& context, const Pointer& start)
        : m_context(context), m_edit(context.edit), m_start(snapped(context, start)), m_keys(keysToCut(m_edit)) {}

    Edit at(const Pointer& pointer) const override {
        CutLevel cut = cutAt(pointer);
        if (cut.places.empty()) {
            return m_edit;
        }
        return {std::make_shared<const Level>(std::move(cut.level)), m_edit.selection.withNodes({})};
    }
    Label label() const override { return {"knife", 1}; }
    Overlay overlay(const Pointer& pointer) const override {
        Overlay overlay;
        overlay.lines.push_back({OverlayStyle::Draft, {m_start, endAt(pointer)}});
        for (const Vec2& place : cutAt(pointer).places) {
            overlay.points.push_back({OverlayStyle::HotHandle, place});
        }
        return overlay;
    }
    Hint hint(const Pointer& pointer) const override {
        const std::size_t places = cutAt(pointer).places.size();
        return places == 0 ? Hint{"knife.nothing", {}} : Hint{"knife.cutting", {std::to_string(places)}};
    }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        return snapFrom(m_context, pointer, m_start);
    }

  private:
    Vec2 endAt(const Pointer& pointer) const { return snappedFrom(m_context, pointer, m_start); }
    CutLevel cutAt(const Pointer& pointer) const { return cutAlong(*m_edit.level, m_keys, m_start, endAt(pointer)); }

    ToolContext m_context;
    Edit m_edit;
    Vec2 m_start;
    std::vector<Key> m_keys;
};

} // namespace

std::unique_ptr<Gesture> KnifeTool::press(const ToolContext& context, const Pointer& pointer) {
    return std::make_unique<KnifeGesture>(context, pointer);
}

Overlay KnifeTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    Overlay overlay;
    overlay.points.push_back({OverlayStyle::Snap, snapped(context, pointer)});
    return overlay;
}

std::optional<SnapAnswer> KnifeTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    return snapOf(context, pointer);
}

Hint KnifeTool::hint(const ToolContext& context, const Pointer&) const {
    const int selected = context.edit.selection.size();
    return selected == 0 ? Hint{"knife.idle", {}} : Hint{"knife.selected", {std::to_string(selected)}};
}

} // namespace spacetow
