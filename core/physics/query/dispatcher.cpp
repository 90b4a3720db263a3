#include "core/physics/query/dispatcher.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace spacetow {

namespace {

using Event = std::variant<TouchEvent, TagsTouchedEvent, CrushedEvent, RemovedEvent>;

int iterationOf(const Event& event) {
    return std::visit([](const auto& e) { return e.iteration; }, event);
}

std::vector<Event> inOrder(const Events& events) {
    std::vector<Event> all(events.began.begin(), events.began.end());
    all.insert(all.end(), events.tagsTouched.begin(), events.tagsTouched.end());
    all.insert(all.end(), events.crushed.begin(), events.crushed.end());
    all.insert(all.end(), events.removed.begin(), events.removed.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Event& a, const Event& b) { return iterationOf(a) < iterationOf(b); });
    return all;
}

} // namespace

void Dispatcher::set(BodyId body, BodyHandler handler) {
    m_handlers[body] = std::make_shared<const BodyHandler>(std::move(handler));
}

void Dispatcher::remove(BodyId body) {
    m_handlers.erase(body);
}

bool Dispatcher::contains(BodyId body) const {
    return m_handlers.contains(body);
}

void Dispatcher::dispatch(const World& world) {
    if (m_handlers.empty()) {
        return;
    }
    for (const Event& event : inOrder(world.events())) {
        std::visit([this](const auto& e) { tell(e); }, event);
    }
    std::vector<BodyId> gone;
    for (const auto& [body, handler] : m_handlers) {
        if (!world.contains(body)) {
            gone.push_back(body);
        }
    }
    for (const BodyId body : gone) {
        tell(RemovedEvent{-1, body, 0});
    }
}

Dispatcher::Handler Dispatcher::find(BodyId body) const {
    const auto found = m_handlers.find(body);
    return found != m_handlers.end() ? found->second : nullptr;
}

void Dispatcher::tell(const TouchEvent& touch) {
    for (const auto& [body, other] : {std::pair(touch.a, touch.b), std::pair(touch.b, touch.a)}) {
        if (const Handler handler = find(body); handler && handler->touched) {
            handler->touched(other, touch);
        }
    }
}

void Dispatcher::tell(const TagsTouchedEvent& touched) {
    if (const Handler handler = find(touched.body); handler && handler->tagsTouched) {
        handler->tagsTouched(touched.tags, touched.iteration);
    }
}

void Dispatcher::tell(const CrushedEvent& crushed) {
    if (const Handler handler = find(crushed.body); handler && handler->crushed) {
        handler->crushed(crushed);
    }
}

void Dispatcher::tell(const RemovedEvent& removed) {
    const Handler handler = find(removed.body);
    m_handlers.erase(removed.body);
    if (handler && handler->removed) {
        handler->removed();
    }
}

} // namespace spacetow
