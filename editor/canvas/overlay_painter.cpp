#include "editor/canvas/overlay_painter.h"

#include "core/level/groups.h"
#include "editor/canvas/painter_draw.h"

#include <algorithm>

namespace spacetow {

namespace {

DebugView debugView(const Viewport& viewport, Shade shade, const OverlayRequest& request) {
    constexpr double spare = 8; // px, for pens and marks
    DebugView view;
    view.view = viewport.transform();
    view.shapes = false;
    view.overlays = request.flags;
    view.colors = overlayColors(request.palette, shade);
    view.area = viewport.visible().grown(spare * viewport.pixel());
    view.trails = request.trails;
    if (const Level* level = request.level; level != nullptr) {
        view.nameOf = [level](std::uint64_t user) {
            const Object* object = level->objects.find(user);
            return object != nullptr ? object->name : std::string();
        };
        view.tagColor = [level](int tag) -> std::optional<Color> {
            const TagInfo& info = level->tags[tag];
            return info.name.empty() ? std::nullopt : std::optional(toColor(QColor::fromRgb(info.color)));
        };
    }
    view.isSelected = [selected = request.selected](std::uint64_t user) {
        return user != 0 && std::ranges::binary_search(selected, user);
    };
    return view;
}

/// What the editor does not show; ascending.
std::vector<Key> hiddenKeys(const Level& level) {
    const GroupTree groups(level);
    std::vector<Key> hidden;
    for (const Object& object : level.objects) {
        if (!groups.isVisible(object)) {
            hidden.push_back(object.key);
        }
    }
    std::ranges::sort(hidden);
    return hidden;
}

/// Whether it left marks out.
bool draw(const Stage& stage, const World& world, const DebugView& view) {
    if (!view.overlays.any()) {
        return false;
    }
    PainterDraw marks(stage.view.size);
    drawWorld(world, view, marks);
    marks.paint(stage);
    return marks.leavesOut();
}

} // namespace

bool paintWorldOverlays(const Stage& stage, const World& world, const OverlayRequest& request) {
    const SavedPainter saved(stage.painter);
    return draw(stage, world, debugView(stage.view, stage.theme.shade, request));
}

PainterDraw worldOverlays(const Viewport& view, Shade shade, const World& world, const OverlayRequest& request) {
    PainterDraw marks(view.size);
    drawWorld(world, debugView(view, shade, request), marks);
    return marks;
}

bool paintLevelOverlays(const Stage& stage, const OverlayWorlds& worlds, const OverlayRequest& request) {
    const SavedPainter saved(stage.painter);
    DebugView view = debugView(stage.view, stage.theme.shade, request);
    view.trails = worlds.trails;
    const std::vector<Key> hidden = request.level != nullptr ? hiddenKeys(*request.level) : std::vector<Key>();
    const auto showsOf = [&hidden](const World& world) {
        return [&hidden, &world](BodyId id) { return !std::ranges::binary_search(hidden, world.body(id).user); };
    };
    view.shows = showsOf(worlds.touched);
    const OverlayFlags& all = request.flags;
    view.overlays = {.islands = all.islands, .problems = false};
    bool leavesOut = draw(stage, worlds.touched, view);
    view.overlays = all;
    view.overlays.islands = view.overlays.contacts = view.overlays.tension = false;
    view.shows = showsOf(worlds.start);
    leavesOut = draw(stage, worlds.start, view) || leavesOut;
    view.shows = showsOf(worlds.touched);
    view.overlays = {.contacts = all.contacts, .tension = all.tension, .problems = false};
    return draw(stage, worlds.touched, view) || leavesOut;
}

} // namespace spacetow
