#include "editor/canvas/board_picture.h"

#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "editor/canvas/board_changes.h"
#include "editor/canvas/highlight_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/scene_painter.h"
#include "editor/canvas/wall_painter.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int cheap = 400;   // segments; what has more is rather drawn elsewhere than painted, when it has only moved
constexpr int enough = 5000; // segments; nobody needs to know how many more there are

/// Painting many small regions takes longer than painting what lies between them.
QRegion coarse(const QRegion& region) {
    constexpr int few = 12; // rectangles
    return region.rectCount() <= few ? region : QRegion(region.boundingRect());
}

std::vector<int> symmetricDifference(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> places;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(places));
    return places;
}

bool isHighlighting(const BoardRequest& request) {
    return request.highlighted && !request.highlighted->empty();
}

/// What is selected or highlighted.
std::vector<int> placesMarked(const Level& level, const BoardRequest& request) {
    std::vector<int> places = level.objects.indicesOf(withMembers(level, request.selection.keys()));
    if (isHighlighting(request)) {
        std::vector<int> all;
        std::ranges::set_union(places, level.objects.indicesOf(*request.highlighted), std::back_inserter(all));
        return all;
    }
    return places;
}

} // namespace

/// Finds out what has to be done to each layer.
class BoardPicture::Planner {
  public:
    Planner(const BoardPicture& picture, const BoardRequest& request) : m_picture(picture), m_request(request) {}

    Plan plan() {
        Plan plan;
        plan.request = m_request;
        plan.moving = moving();
        m_moving = &plan.moving;
        for (const BoardLayer layer : {BoardLayer::Rock, BoardLayer::Objects, BoardLayer::Moving, BoardLayer::Overlays,
                                       BoardLayer::Marks, BoardLayer::Hover}) {
            Step& step = plan.steps[static_cast<std::size_t>(layer)];
            step = stepFor(layer);
            plan.work += step.work;
        }
        return plan;
    }

  private:
    /// As long as a gesture goes on, what it has moved once counts as moving.
    std::vector<int> moving() const {
        if (!m_request.live) {
            return {};
        }
        std::vector<int> places =
            m_request.level != m_request.base ? placesChanged(*m_request.base, *m_request.level) : std::vector<int>{};
        if (m_picture.m_shown.base == m_request.base && !m_picture.m_moving.empty()) {
            std::vector<int> all;
            std::ranges::set_union(places, m_picture.m_moving, std::back_inserter(all));
            // What the gesture drew may be gone again, as a rectangle that has no height any more.
            const int size = m_request.level->objects.size();
            std::erase_if(all, [size](int place) { return place >= size; });
            return all;
        }
        return places;
    }

    bool hasSomething(BoardLayer layer) const {
        switch (layer) {
        case BoardLayer::Rock:
            return !rockMakers(*m_request.level).empty();
        case BoardLayer::Objects:
            return true;
        case BoardLayer::Moving:
            return !m_moving->empty();
        case BoardLayer::Overlays:
            return m_request.overlays.any();
        case BoardLayer::Hover:
            return m_request.hovered != 0;
        case BoardLayer::Marks:
            break;
        }
        return !m_request.selection.empty() || isHighlighting(m_request);
    }
    const std::shared_ptr<const Level>& levelFor(BoardLayer layer) const {
        return layer == BoardLayer::Objects ? m_request.base : m_request.level;
    }

    Step stepFor(BoardLayer layer) {
        const Part& part = m_picture.part(layer);
        Step step;
        step.level = levelFor(layer);
        step.blank = !hasSomething(layer);
        step.frame = frameFor(part, m_request.frame);
        if (step.blank) {
            return step;
        }
        step.other = isOther(layer);
        const bool fresh = !part.picture.canShiftTo(step.frame) || m_picture.m_shown.theme != m_request.theme ||
                           !part.level || part.picture.isBlank() || step.other;
        step.region = (fresh ? QRegion(step.frame.all()) : missing(part, step.frame)) & contents(layer, step);
        if (!fresh) {
            add(step.region, step.frame, changed(layer));
        }
        const bool asOne = layer == BoardLayer::Overlays && m_request.overlays.names; // else names would be cut
        step.region = asOne && !step.region.isEmpty() ? step.frame.all() : coarse(step.region);
        step.work = workIn(layer, step);
        if (!fresh && step.work > cheap && m_request.live) {
            tryMoving(layer, step);
        }
        return step;
    }
    /// Where in the frame the layer has anything to show.
    QRect contents(BoardLayer layer, const Step& step) const {
        constexpr std::size_t many = 1000;
        const bool areFewMarks = m_request.selection.keys().size() <= many && !isHighlighting(m_request);
        if (!showsSome(layer) || (layer == BoardLayer::Marks && !areFewMarks)) {
            return step.frame.all();
        }
        const std::vector<int> places = shownBy(layer, *step.level);
        if (places.size() > many) {
            return step.frame.all();
        }
        const LevelIndex& index = levelIndex(*step.level);
        QRect rect;
        for (const int place : places) {
            rect |= step.frame.deviceRect(index.boundsOf(place), bandBehind(index.reachOf(place)));
        }
        return rect;
    }
    /// What was painted ahead is kept as long as the view is in it.
    static Frame2D frameFor(const Part& part, const Frame2D& wanted) {
        const bool inside =
            part.picture.canShiftTo(wanted) && part.picture.frame().all().contains(part.picture.frame().rectOf(wanted));
        return inside ? part.picture.frame() : wanted;
    }
    /// A picture that is drawn elsewhere shows nothing where it belongs.
    static QRegion missing(const Part& part, const Frame2D& frame) {
        return part.moved == Vec2(0, 0) ? part.picture.missingIn(frame) : QRegion(frame.all());
    }
    static void add(QRegion& region, const Frame2D& frame, const ChangedAreas& areas) {
        if (areas.everything) {
            region = frame.all();
            return;
        }
        for (const Aabb& box : areas.boxes) {
            region += frame.deviceRect(box, 0);
        }
    }

    ChangedAreas changed(BoardLayer layer) const {
        const Part& part = m_picture.part(layer);
        const Level& after = *levelFor(layer);
        ChangedAreas areas;
        if (part.level != levelFor(layer)) {
            const LevelChanges changes = boardChangesBetween(*part.level, after);
            areas = layer == BoardLayer::Rock ? changes.rock : changes.objects;
            areas.everything = areas.everything || layer == BoardLayer::Overlays;
        }
        if (layer == BoardLayer::Overlays && (m_picture.m_shown.overlays != m_request.overlays ||
                                              m_picture.m_shown.palette != m_request.palette || !hasSameNames())) {
            areas.everything = true;
        }
        if (layer == BoardLayer::Moving && m_picture.m_moving != *m_moving) {
            areas.everything = true;
        }
        if (layer == BoardLayer::Objects && m_picture.m_moving != *m_moving) {
            addObjects(areas, after, symmetricDifference(m_picture.m_moving, *m_moving));
        }
        return areas;
    }
    /// Whether it has to show other things than before.
    bool isOther(BoardLayer layer) const {
        return (layer == BoardLayer::Marks && !hasSameMarks()) ||
               (layer == BoardLayer::Hover && m_picture.m_shown.hovered != m_request.hovered);
    }
    /// Whether it shows some objects alone.
    static bool showsSome(BoardLayer layer) {
        return layer == BoardLayer::Moving || layer == BoardLayer::Marks || layer == BoardLayer::Hover;
    }
    bool hasSameMarks() const {
        return m_picture.m_shown.selection == m_request.selection &&
               m_picture.m_shown.highlighted == m_request.highlighted;
    }
    bool hasSameNames() const {
        const BoardRequest& shown = m_picture.m_shown;
        return !m_picture.leftOut(shown.frame.view).names ||
               (shown.selection == m_request.selection && shown.pointed == m_request.pointed);
    }
    static void addObjects(ChangedAreas& areas, const Level& level, const std::vector<int>& places) {
        constexpr std::size_t many = 1000;
        areas.everything = areas.everything || places.size() > many;
        const LevelIndex& index = levelIndex(level);
        for (std::size_t i = 0; !areas.everything && i < places.size(); ++i) {
            if (places[i] < level.objects.size()) {
                areas.add(index.boundsOf(places[i]).grown(bandBehind(index.reachOf(places[i]))));
            }
        }
    }

    /// How much there is to paint of the layer in the region.
    int workIn(BoardLayer layer, const Step& step) const {
        int work = 0;
        if (step.region.isEmpty()) {
            return 0;
        }
        const LevelIndex& index = levelIndex(*step.level);
        const std::vector<int> only = showsSome(layer) ? shownBy(layer, *step.level) : std::vector<int>();
        if (layer == BoardLayer::Overlays && !m_picture.hasWorldsOf(step.level, m_request.overlays)) {
            work += workOfWorlds(*step.level, m_request.overlays);
        }
        const bool hasBands = layer == BoardLayer::Objects || layer == BoardLayer::Moving;
        const int layers = rimLayers(step.frame.view.scale);
        for (const QRect& rect : step.region) {
            const Aabb box = step.frame.worldIn(rect).grown(fadeDepth);
            const auto count = [&](int place) {
                if (work < enough && index.boundsOf(place).overlaps(box)) {
                    const bool isLayered = hasBands && hasFadingBand(step.level->objects[place]);
                    work += (isLayered ? layers : 1) * index.segmentsNear(place, box);
                }
            };
            if (showsSome(layer)) {
                std::ranges::for_each(only, count);
            } else {
                index.visitObjects(box, count);
            }
        }
        return work;
    }

    /// Leaves the picture as it is and has it drawn elsewhere, if all that it shows has moved alike.
    void tryMoving(BoardLayer layer, Step& step) {
        const Part& part = m_picture.part(layer);
        const bool same = layer == BoardLayer::Rock ||
                          (layer == BoardLayer::Moving && m_picture.m_moving == *m_moving) ||
                          layer == BoardLayer::Marks || layer == BoardLayer::Hover;
        if (!same || part.level == step.level) {
            return;
        }
        const std::optional<Vec2> move = commonMove(*part.level, *step.level, shownBy(layer, *part.level));
        if (!move) {
            return;
        }
        Frame2D wanted = m_request.frame;
        wanted.view.center -= *move;
        wanted.view = alignedToPixels(wanted.view, wanted.pixelRatio);
        step.moved = *move;
        step.level = part.level;
        step.frame = frameFor(part, wanted);
        step.region = coarse(part.picture.missingIn(step.frame));
        step.work = workIn(layer, step);
    }
    std::vector<int> shownBy(BoardLayer layer, const Level& level) const {
        if (layer == BoardLayer::Moving) {
            return *m_moving;
        }
        if (layer == BoardLayer::Hover) {
            return level.objects.indicesOf(withMembers(level, std::span(&m_request.hovered, 1)));
        }
        return layer == BoardLayer::Marks ? placesMarked(level, m_request) : rockMakers(level);
    }

    const BoardPicture& m_picture;
    const BoardRequest& m_request;
    const std::vector<int>* m_moving = nullptr;
};

BoardPicture::Plan BoardPicture::planFor(const BoardRequest& request) const {
    return Planner(*this, request).plan();
}

bool BoardPicture::follow(const Plan& plan) {
    bool still = false;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const Step& step = plan.steps[i];
        if (step.level == m_parts[i].level && step.moved != m_parts[i].moved) {
            m_parts[i].moved = step.moved;
            still = still || i <= static_cast<std::size_t>(BoardLayer::Objects);
        }
    }
    return still;
}

void BoardPicture::makeWorlds(const Plan& plan) {
    const Step& step = plan.steps[static_cast<std::size_t>(BoardLayer::Overlays)];
    const OverlayFlags& overlays = plan.request.overlays;
    m_leftOut.forget(step.frame, overlays.any() ? step.region : step.frame.all());
    if (!overlays.any()) {
        m_worlds.reset();
    } else if (!step.region.isEmpty() && !hasWorldsOf(step.level, overlays)) {
        m_worlds = std::make_shared<const Worlds>(Worlds{step.level, overlayWorlds(*step.level, overlays)});
    }
}

void BoardPicture::bring(const Plan& plan) {
    makeWorlds(plan);
    const auto painter = [&](BoardLayer layer, const Step& step) -> PictureLayer::Paint {
        switch (layer) {
        case BoardLayer::Rock:
            return [&step](const Stage& stage) { paintRock(stage, *step.level, {}); };
        case BoardLayer::Objects:
            return [&](const Stage& stage) { paintObjects(stage, *step.level, {.without = &plan.moving}); };
        case BoardLayer::Moving:
            return [&](const Stage& stage) { paintObjects(stage, *step.level, {.only = &plan.moving}); };
        case BoardLayer::Overlays:
            return [&](const Stage& stage) {
                const BoardRequest& wanted = plan.request;
                const OverlayRequest marks{
                    wanted.overlays, wanted.palette, step.level.get(), wanted.selection.keys(), wanted.pointed, {}, {}};
                m_leftOut.add(paintLevelOverlays(stage, *m_worlds->worlds, marks));
            };
        case BoardLayer::Hover:
            return [&](const Stage& stage) { paintHovered(stage, *step.level, plan.request.hovered); };
        case BoardLayer::Marks:
            break;
        }
        return [&](const Stage& stage) {
            if (plan.request.highlighted) {
                paintHighlight(stage, *step.level, *plan.request.highlighted);
            }
            paintSelection(stage, *step.level, plan.request.selection);
        };
    };
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const Step& step = plan.steps[i];
        Part& part = m_parts[i];
        if (step.blank) {
            part.picture.erase();
        } else if (step.other) {
            part.picture.wipe();
        }
        part.picture.shiftTo(step.frame);
        part.picture.paint(step.region, *plan.request.theme, painter(static_cast<BoardLayer>(i), step));
        part.level = step.level;
        part.moved = step.moved;
    }
    m_shown = plan.request;
    m_moving = plan.moving;
}

void BoardPicture::draw(QPainter& painter, const Frame2D& frame, BoardLayer first, BoardLayer last) const {
    for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) {
        m_parts[i].picture.draw(painter, frame, m_parts[i].moved);
    }
}

std::optional<QRegion> BoardPicture::stillTouchedBy(const Plan& plan, const Frame2D& frame) const {
    QRegion touched;
    for (const BoardLayer layer : {BoardLayer::Rock, BoardLayer::Objects}) {
        const Step& step = plan.steps[static_cast<std::size_t>(layer)];
        const bool isKnown = step.moved == Vec2(0, 0) && part(layer).moved == Vec2(0, 0) &&
                             step.blank == part(layer).picture.isBlank() && step.frame.view.scale == frame.view.scale &&
                             step.frame.pixelRatio == frame.pixelRatio;
        if (!isKnown) {
            return {};
        }
        touched += step.region.translated(frame.rectOf(step.frame).topLeft());
    }
    return touched;
}

PictureLayer BoardPicture::flattened(const Theme& theme, BoardLayer first, BoardLayer last) const {
    const Frame2D& frame = part(BoardLayer::Objects).picture.frame();
    PictureLayer all;
    all.shiftTo(frame);
    all.paint(frame.all(), theme, [&](const Stage& stage) { draw(stage.painter, frame, first, last); });
    return all;
}

bool BoardPicture::isNearBorder(const Frame2D& frame) const {
    const Frame2D& painted = part(BoardLayer::Objects).picture.frame();
    if (painted.view.scale != frame.view.scale || painted.deviceSize() == frame.deviceSize()) {
        return false;
    }
    const QRect all = painted.all();
    const QRect inner = painted.rectOf(frame);
    const int margin = (all.width() - inner.width()) / 4; // half of what there is on each side
    return !all.adjusted(margin, margin, -margin, -margin).contains(inner);
}

} // namespace spacetow
