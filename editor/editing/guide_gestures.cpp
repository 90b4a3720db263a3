#include "editor/editing/guide_gestures.h"

#include "core/level/guides.h"
#include "editor/editing/measure.h"
#include "editor/editing/pick.h"

#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double guideReach = 5;                   // px
constexpr double turnStep = std::numbers::pi / 12; // 15°
constexpr double degree = std::numbers::pi / 180;

bool isOnRuler(const Pointer& pointer) {
    return pointer.screen.x() < 0 || pointer.screen.y() < 0;
}

Edit guidedEdit(const Edit& start, Level level) {
    return {std::make_shared<const Level>(std::move(level)), start.selection};
}

/// A level or upright one is told by one coordinate.
std::string placeText(const Guide& guide) {
    const Vec2 along = directionOf(guide);
    if (along.y() == 0) {
        return "y " + lengthText(guide.point.y()) + " m";
    }
    if (along.x() == 0) {
        return "x " + lengthText(guide.point.x()) + " m";
    }
    return lengthText(guide.point.x()) + ", " + lengthText(guide.point.y()) + " m  " + degreesText(guide.angle) + "°";
}

Overlay marked(const Guide& guide) {
    Overlay overlay;
    overlay.points.push_back({OverlayStyle::Snap, guide.point});
    overlay.texts.push_back({guide.point, placeText(guide)});
    return overlay;
}

Hint hintFor(const char* code, const Guide& guide) {
    return {code, {lengthText(guide.point.x()), lengthText(guide.point.y()), degreesText(guide.angle)}};
}

} // namespace

std::optional<std::size_t> guideInReach(const ToolContext& context, const Pointer& pointer) {
    const Level& level = *context.edit.level;
    if (!context.guides) {
        return {};
    }
    std::optional<std::size_t> nearest;
    double least = guideReach * pointer.pixel;
    for (std::size_t i = 0; i < level.guides.size(); ++i) {
        const double distance = distanceTo(level.guides[i], pointer.world);
        if (distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    const bool covered = nearest && !picked(level, pointer.world, guideReach * pointer.pixel).empty();
    return covered ? std::nullopt : nearest;
}

NewGuideGesture::NewGuideGesture(const ToolContext& context, double angle)
    : m_context(context), m_start(context.edit), m_angle(angle) {}

std::optional<SnapAnswer> NewGuideGesture::snapAt(const Pointer& pointer) const {
    return isOnRuler(pointer) ? std::nullopt : std::optional(snapOf(m_context, pointer));
}

Guide NewGuideGesture::made(const Pointer& pointer) const {
    Guide guide;
    guide.point = snapped(m_context, pointer);
    guide.angle = m_angle;
    return guide;
}

Edit NewGuideGesture::at(const Pointer& pointer) const {
    return isOnRuler(pointer) ? m_start : guidedEdit(m_start, guideAdded(*m_start.level, made(pointer)));
}

Overlay NewGuideGesture::overlay(const Pointer& pointer) const {
    return isOnRuler(pointer) ? Overlay() : marked(made(pointer));
}

Hint NewGuideGesture::hint(const Pointer& pointer) const {
    return isOnRuler(pointer) ? Hint{"guide.outside", {}} : hintFor("guide.new", made(pointer));
}

MoveGuideGesture::MoveGuideGesture(const ToolContext& context, std::size_t index)
    : m_start(context.edit), m_settings(context.snap), m_index(index),
      m_snap(context, {.guide = static_cast<int>(index)}, m_start.level->guides[index].point) {}

std::optional<SnapAnswer> MoveGuideGesture::snapAt(const Pointer& pointer) const {
    return isOnRuler(pointer) || pointer.modifiers.shift ? std::nullopt
                                                         : std::optional(m_snap.to(pointer.world, pointer));
}

Guide MoveGuideGesture::changed(const Pointer& pointer) const {
    Guide guide = m_start.level->guides[m_index];
    if (!pointer.modifiers.shift) {
        guide.point = m_snap.to(pointer.world, pointer).point;
        return guide;
    }
    const Vec2 toward = pointer.world - guide.point;
    if (toward.norm() > pointer.pixel) {
        const double angle = std::atan2(toward.y(), toward.x());
        guide.angle = snaps(m_settings, pointer.modifiers) ? std::round(angle / turnStep) * turnStep
                                                           : std::round(angle / degree) * degree;
    }
    return guide;
}

Edit MoveGuideGesture::at(const Pointer& pointer) const {
    return guidedEdit(m_start, isOnRuler(pointer) ? guideRemoved(*m_start.level, m_index)
                                                  : guideReplaced(*m_start.level, m_index, changed(pointer)));
}

Overlay MoveGuideGesture::overlay(const Pointer& pointer) const {
    return isOnRuler(pointer) ? Overlay() : marked(changed(pointer));
}

Hint MoveGuideGesture::hint(const Pointer& pointer) const {
    return isOnRuler(pointer) ? Hint{"guide.delete", {}} : hintFor("guide.moving", changed(pointer));
}

} // namespace spacetow
