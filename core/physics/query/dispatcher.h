#pragma once
// Tells single bodies what happened to them: reads the events of an update and calls the handlers of the bodies that
// they are about. No handler runs in the middle of a step, so each may do anything to the world and to the dispatcher.

#include "core/physics/world/world.h"

#include <functional>
#include <map>
#include <memory>

namespace spacetow {

/// Any of the functions may be missing.
struct BodyHandler {
    /// The two begin to touch. By now `other` may be gone: see World::contains.
    std::function<void(BodyId other, const TouchEvent& touch)> touched;
    /// What a body that reports touches (BodyDef) touches in an iteration: called for each one in which it touches
    /// something.
    std::function<void(TagMask tags, int iteration)> tagsTouched;
    /// The body is no longer in the world. The last call; the handler is forgotten before it.
    std::function<void()> removed;
    /// The body begins to be crushed. By now the others may be gone.
    std::function<void(const CrushedEvent& crushed)> crushed;
};

class Dispatcher {
  public:
    /// Replaces the handler that the body had. Removing none is no mistake.
    void set(BodyId body, BodyHandler handler);
    void remove(BodyId body);
    bool contains(BodyId body) const;

    /// To be called after each update. Calls come in the order of the iterations; within an iteration touches come
    /// first, then tags, then who is crushed, then removals, each in the order of the world's events, and of a touch
    /// `a` hears before `b`. At the end come the removals that no event told of, because an update was not dispatched
    /// or another world was put in place of this one. Who hears of an event is looked up when its turn has come: a
    /// handler that is set meanwhile hears the rest, one that is removed nothing more. The events are those from before
    /// the first call, even if a handler updates the world.
    void dispatch(const World& world);

  private:
    /// Shared, so that a handler may be removed or replaced while it runs.
    using Handler = std::shared_ptr<const BodyHandler>;

    Handler find(BodyId body) const;
    void tell(const TouchEvent& touch);
    void tell(const TagsTouchedEvent& touched);
    void tell(const CrushedEvent& crushed);
    void tell(const RemovedEvent& removed);

    struct Before {
        bool operator()(BodyId a, BodyId b) const {
            return a.index != b.index ? a.index < b.index : a.generation < b.generation;
        }
    };

    std::map<BodyId, Handler, Before> m_handlers;
};

} // namespace spacetow
