#include "editor/editing/field_targets.h"

#include <algorithm>

namespace spacetow {

std::vector<ShapeRef> shapesOf(const Selection& selection) {
    std::vector<ShapeRef> shapes;
    for (const NodeRef& node : selection.nodes()) {
        const ShapeRef shape{node.key, node.shape};
        if (shapes.empty() || shapes.back() != shape) {
            shapes.push_back(shape);
        }
    }
    return shapes;
}

std::vector<int> shapesOf(std::span<const ShapeRef> shapes, Key key) {
    std::vector<int> indices;
    auto at = std::ranges::lower_bound(shapes, ShapeRef{key, 0});
    for (; at != shapes.end() && at->key == key; ++at) {
        indices.push_back(at->shape);
    }
    return indices;
}

} // namespace spacetow
