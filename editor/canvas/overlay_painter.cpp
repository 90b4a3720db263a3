#include "editor/canvas/overlay_painter.h"

#include "core/level/groups.h"
#include "editor/canvas/painter_draw.h"

#include <QFont>
#include <QFontMetricsF>

#include <algorithm>
#include <iterator>

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

void placeNames(PainterDraw& marks, const QFontMetricsF& metrics, const OverlayRequest& request) {
    marks.placeNames(metrics, [&request](std::uint64_t user) {
        const bool isFirst = user == request.pointed || std::ranges::binary_search(request.selected, user);
        return isFirst ? 0 : std::ranges::binary_search(request.named, user) ? 1 : 2;
    });
}

/// A view of what is drawn, and what it was made from.
struct Drawn {
    const World& world;
    const DebugView& view;
    const OverlayRequest& request;
};

void draw(const Stage& stage, const Drawn& drawn, OverlayGaps& gaps) {
    const auto& [world, view, request] = drawn;
    if (!view.overlays.any()) {
        return;
    }
    PainterDraw marks(stage.view.size);
    drawWorld(world, view, marks);
    placeNames(marks, QFontMetricsF(stage.painter.font()), request);
    marks.paint(stage);
    const OverlayGaps more = gapsOf(marks, stage.view);
    gaps.names = gaps.names || more.names;
    gaps.named.insert(gaps.named.end(), more.named.begin(), more.named.end());
    gaps.dots.insert(gaps.dots.end(), more.dots.begin(), more.dots.end());
}

} // namespace

OverlayGaps gapsOf(const PainterDraw& marks, const Viewport& view) {
    OverlayGaps gaps{.dots = {}, .names = marks.leavesOutNames(), .named = marks.named()};
    std::ranges::transform(marks.dots(), std::back_inserter(gaps.dots),
                           [&view](const Vec2& dot) { return view.toWorld(dot); });
    return gaps;
}

OverlayGaps paintWorldOverlays(const Stage& stage, const World& world, const OverlayRequest& request) {
    const SavedPainter saved(stage.painter);
    OverlayGaps gaps;
    draw(stage, {world, debugView(stage.view, stage.theme.shade, request), request}, gaps);
    return gaps;
}

PainterDraw worldOverlays(const Viewport& view, Shade shade, const World& world, const OverlayRequest& request) {
    PainterDraw marks(view.size);
    drawWorld(world, debugView(view, shade, request), marks);
    placeNames(marks, QFontMetricsF(QFont()), request);
    return marks;
}

OverlayGaps paintLevelOverlays(const Stage& stage, const OverlayWorlds& worlds, const OverlayRequest& request) {
    const SavedPainter saved(stage.painter);
    OverlayGaps gaps;
    DebugView view = debugView(stage.view, stage.theme.shade, request);
    view.trails = worlds.trails;
    const std::vector<Key> hidden = request.level != nullptr ? hiddenKeys(*request.level) : std::vector<Key>();
    const auto showsOf = [&hidden](const World& world) {
        return [&hidden, &world](BodyId id) { return !std::ranges::binary_search(hidden, world.body(id).user); };
    };
    view.shows = showsOf(worlds.touched);
    const OverlayFlags& all = request.flags;
    view.overlays = {.islands = all.islands, .problems = false};
    draw(stage, {worlds.touched, view, request}, gaps);
    view.overlays = all;
    view.overlays.islands = view.overlays.contacts = view.overlays.tension = false;
    view.shows = showsOf(worlds.start);
    draw(stage, {worlds.start, view, request}, gaps);
    view.shows = showsOf(worlds.touched);
    view.overlays = {.contacts = all.contacts, .tension = all.tension, .problems = false};
    draw(stage, {worlds.touched, view, request}, gaps);
    return gaps;
}

} // namespace spacetow
