#include "core/physics/query/present_manifold.h"

#include "core/geometry/passage.h"

namespace spacetow {

Manifold presentManifold(const Bodies& bodies, const PairTable& table, std::size_t index, double margin) {
    const Pair& pair = table.pairs[index];
    const Passage passage = table.flags[index].passage;
    const Transform a = bodies.pose(pair.bodyA);
    const Transform b = bodies.poseOfB(pair);
    const bool isOpen = passage == Passage::Behind || passage == Passage::Passing;
    return isOpen ? collideOpenWall(*pair.shapeA, a, *pair.shapeB, b, margin)
                  : collide(*pair.shapeA, a, *pair.shapeB, b, margin);
}

} // namespace spacetow
