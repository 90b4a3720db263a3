#include "core/physics/query/world_bytes.h"

#include "core/physics/state/world_data.h"

namespace spacetow {
namespace {

template <class T>
std::size_t bytesOf(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

std::size_t bytesOf(const PairTable& table) {
    return bytesOf(table.pairs) + bytesOf(table.bounds) + bytesOf(table.flags);
}

template <class Batch>
std::size_t bytesOf(const Batches<Batch>& batches) {
    return batches.size() * (sizeof(Batch) + sizeof(typename Batch::Anchors) + sizeof(BatchFlags));
}

} // namespace

std::size_t copyBytes(const World& world) {
    const WorldData& data = world.data();
    constexpr std::size_t kept = sizeof(PlannedMotion) + sizeof(BodyExtent) + sizeof(double) + sizeof(BodyVelocity);
    constexpr std::size_t lists = 12 * sizeof(Slot); // about as many lists contain a body
    const std::size_t bodies = bytesOf(data.bodies.motions) + bytesOf(data.bodies.steps) +
                               bytesOf(data.bodies.records) + data.bodies.records.size() * (kept + lists);
    constexpr std::size_t places = sizeof(Aabb) + 4 * sizeof(std::uint32_t); // in the tree
    const std::size_t proxies =
        bytesOf(data.broadPhase.proxies) + bytesOf(data.broadPhase.boxes) + data.broadPhase.proxies.size() * places;
    const std::size_t contacts = bytesOf(data.contacts.pool) + bytesOf(data.constraints.circleContacts) +
                                 bytesOf(data.constraints.generalContacts) + bytesOf(data.constraints.batches.circles) +
                                 bytesOf(data.constraints.batches.general);
    const std::size_t events = bytesOf(data.events.began) + bytesOf(data.events.ended) +
                               bytesOf(data.events.tagsTouched) + bytesOf(data.impulses.impulses) +
                               bytesOf(data.impulses.places) + bytesOf(data.impulses.placed);
    return sizeof(WorldData) + bodies + proxies + bytesOf(data.contacts.table) + bytesOf(data.sleep.table) + contacts +
           events + bytesOf(data.forces.connectors) + bytesOf(data.forces.notColliding);
}

} // namespace spacetow
