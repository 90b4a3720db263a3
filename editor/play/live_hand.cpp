#include "editor/play/live_hand.h"

#include "core/level/object_geometry.h"
#include "editor/editing/select_gestures.h"
#include "editor/play/live_pose.h"

#include <algorithm>
#include <utility>

namespace spacetow {
namespace {

constexpr double dragDistance = 4; // px that a click may move and still be a click

bool standsStill(const Level& level, Key key) {
    const Object* const object = level.objects.find(key);
    const auto* body = object != nullptr ? std::get_if<BodyObject>(&object->data) : nullptr;
    return (body != nullptr && body->kind != BodyKind::Dynamic) ||
           (object != nullptr && std::holds_alternative<FinishObject>(object->data));
}

/// The one below what is selected, and the topmost after the last.
GroupPick nextBelow(const std::vector<GroupPick>& pile, const Selection& selection) {
    const auto at = std::ranges::find_if(pile, [&](const GroupPick& pick) { return selection.contains(pick.key); });
    return at == pile.end() || std::next(at) == pile.end() ? pile.front() : *std::next(at);
}

} // namespace

LiveHand::LiveHand(Document& document, Toolbox& toolbox, LiveRun& run)
    : m_document(document), m_toolbox(toolbox), m_run(run), m_picture(std::make_shared<const Snapshot>()) {}

LiveHand::~LiveHand() = default;

void LiveHand::see(const Snapshot& picture) {
    constexpr qint64 patience = 180; // ms, after which a press without a move is no click
    if (m_pressed && !m_grab && !m_band && !m_dragging && !m_run.isPaused() && m_held.elapsed() > patience) {
        takeHold();
    }
    if (picture.update != m_picture->update || m_run.isPaused() || !m_edit) {
        m_edit.reset();
        m_picture = std::make_shared<const Snapshot>(picture);
    }
}

const Edit& LiveHand::edit() const {
    const std::shared_ptr<const Level>& level = m_document.current().level;
    if (!m_edit || m_editOf != level) {
        m_editOf = level;
        m_edit = Edit{std::make_shared<const Level>(posed(*level, *m_picture)), {}};
    }
    m_edit->selection = m_document.current().selection;
    return *m_edit;
}

std::vector<GroupPick> LiveHand::under(const Pointer& pointer) const {
    const std::shared_ptr<const Level>& level = m_document.current().level;
    if (!m_standing || m_standingOf != level) {
        m_standingOf = level;
        m_standing = standing(*level);
    }
    const Aabb around = Aabb{pointer.world, pointer.world}.grown(2 * grabPixels * pointer.pixel);
    const auto near = std::make_shared<const Level>(posedNear(*level, *m_standing, *m_picture, around));
    return pickedMembers({near, m_document.current().selection}, pointer);
}

void LiveHand::press(const Pointer& pointer) {
    m_pressed = pointer;
    m_pointer = pointer;
    m_held.start();
    m_pile = under(pointer); // before it moves on
    m_inReach = grabAt(pointer);
}

void LiveHand::move(const Pointer& pointer) {
    m_pointer = pointer;
    if (m_pressed && !m_band && !m_dragging && !m_grab && (pointer.screen - m_pressed->screen).norm() > dragDistance) {
        beginDrag(*m_pressed);
    }
    if (m_band) {
        m_band->follow(pointer);
    } else if (m_grab) {
        m_grab->target = pointer.world;
        m_run.setGrab(m_grab);
    } else if (m_dragging) {
        m_toolbox.move(pointer);
    } else if (!m_pressed) {
        const std::vector<GroupPick> pile = under(pointer);
        m_hovered = pile.empty() ? 0 : pile.front().key;
    }
}

/// The body that a spring can pull there.
std::optional<Grab> LiveHand::grabAt(const Pointer& pointer) const {
    if (m_pile.empty()) {
        return {};
    }
    for (const BodyPicture& body : m_picture->moving) {
        if (body.look->key == m_pile.front().object && body.look->kind == BodyKind::Dynamic) {
            return Grab{body.look->key, body.pose.toLocal(pointer.world), pointer.world};
        }
    }
    return {};
}

void LiveHand::takeHold() {
    m_grab = m_inReach;
    if (m_grab) {
        m_grab->target = m_pointer.world;
        m_run.setGrab(m_grab);
    }
}

void LiveHand::letGo() {
    if (m_grab) {
        m_grab.reset();
        m_run.setGrab({});
    }
}

/// Takes what is under the pointer in hand, or begins a band.
void LiveHand::beginDrag(const Pointer& pointer) {
    const std::vector<GroupPick> pile = pointer.modifiers.shift ? std::vector<GroupPick>() : m_pile;
    if (!m_run.isPaused() && !pointer.modifiers.shift) {
        takeHold();
        if (m_grab) {
            return;
        }
    }
    if (m_run.isGame()) {
        return; // nobody edits by a slip of the hand while he flies
    }
    if (pile.empty()) {
        m_band = std::make_unique<BandGesture>(edit(), pointer.world, pointer.modifiers.shift);
        return;
    }
    const GroupPick& top = pile.front();
    if (!m_run.isPaused() && !standsStill(*edit().level, top.object)) {
        return;
    }
    if (!m_document.selection().contains(top.key)) {
        m_document.select(Selection({top.key}).entering(top.entered));
    }
    const Object* const object = m_document.level().objects.find(top.key);
    const std::optional<Vec2> place = object != nullptr ? placeOf(object->data) : std::nullopt;
    m_toolbox.begin(std::make_unique<MoveGesture>(m_toolbox.context(), pointer, place.value_or(pointer.world)),
                    pointer);
    m_dragging = m_toolbox.isDragging();
}

void LiveHand::release(const Pointer& pointer) {
    if (!m_pressed) {
        return;
    }
    const bool clicks =
        !m_band && !m_dragging && !m_grab && (pointer.screen - m_pressed->screen).norm() <= dragDistance;
    m_pressed.reset();
    letGo();
    if (const std::unique_ptr<Gesture> band = std::move(m_band)) {
        band->follow(pointer);
        m_document.select(band->at(pointer).selection);
    } else if (std::exchange(m_dragging, false)) {
        m_toolbox.release(pointer);
    } else if (clicks) {
        m_document.select(clicked(pointer));
    }
}

void LiveHand::loseMouse() {
    m_pressed.reset();
    m_band.reset();
    letGo();
    if (std::exchange(m_dragging, false)) {
        m_toolbox.loseMouse();
    }
}

/// As the Select tool has it, but for the handles, which do not go along with what moves.
Selection LiveHand::clicked(const Pointer& pointer) const {
    const Selection& selection = m_document.selection();
    const std::vector<GroupPick>& pile = m_pile;
    const Modifiers& held = pointer.modifiers;
    if (pile.empty()) {
        return held.shift || held.ctrl ? selection : Selection().entering(selection.entered());
    }
    const GroupPick& top = pile.front();
    if (held.ctrl && top.key != top.object) {
        return directly(edit(), top.object);
    }
    if (held.shift || held.ctrl) {
        return selection.toggled(top.key).entering(top.entered);
    }
    const GroupPick& chosen = held.alt ? nextBelow(pile, selection) : top;
    return Selection({chosen.key}).entering(chosen.entered);
}

Overlay LiveHand::overlay() const {
    return m_band ? m_band->overlay(m_pointer) : Overlay();
}

CursorShape LiveHand::cursor() const {
    return m_dragging || m_grab        ? CursorShape::Move
           : m_hovered != 0 && !m_band ? CursorShape::Pointing
                                       : CursorShape::Arrow;
}

} // namespace spacetow
