#include "core/level/shape_pieces.h"

#include "core/base/contract.h"
#include "core/level/edits.h"
#include "core/level/unknown_fields.h"

#include <algorithm>

namespace spacetow {

namespace {

/// One body while its shapes are changed.
class Reshaping {
  public:
    Reshaping(Object& object, std::vector<NodeRef>& kept) : m_object(object), m_kept(kept) {}

    void change(std::span<const NodeRef> nodes, const ShapeChange& change) {
        auto& body = std::get<BodyObject>(m_object.data);
        auto pieces = change(body, nodes.front(), nodes);
        const auto place = static_cast<std::size_t>(nodes.front().shape);
        if (!pieces) {
            m_nodes.insert(m_nodes.end(), nodes.begin(), nodes.end());
            return;
        }
        m_changed = true;
        if (pieces->empty()) {
            m_lost.push_back(static_cast<int>(place));
        }
        for (std::size_t i = 0; i < pieces->size(); ++i) {
            const std::size_t shape = i == 0 ? place : body.shapes.size();
            for (const int vertex : (*pieces)[i].nodes) {
                m_nodes.push_back({m_object.key, static_cast<int>(shape), vertex});
            }
            if (i == 0) {
                body.shapes[shape] = std::move((*pieces)[i].shape);
            } else {
                body.shapes.push_back(std::move((*pieces)[i].shape));
            }
        }
    }

    /// Whether the object is to be replaced in the level.
    bool finish() {
        auto& shapes = std::get<BodyObject>(m_object.data).shapes;
        for (auto lost = m_lost.rbegin(); lost != m_lost.rend(); ++lost) {
            shapes.erase(shapes.begin() + *lost);
            for (NodeRef& node : m_nodes) {
                node.shape -= node.shape > *lost ? 1 : 0;
            }
        }
        m_object.unknownFields = withoutEntries(m_object.unknownFields, "/shapes", m_lost);
        m_kept.insert(m_kept.end(), m_nodes.begin(), m_nodes.end());
        return m_changed;
    }

  private:
    Object& m_object;
    std::vector<NodeRef>& m_kept;
    std::vector<NodeRef> m_nodes;
    std::vector<int> m_lost; // shapes, ascending
    bool m_changed = false;
};

} // namespace

NodeEdit reshaped(Level level, std::span<const NodeRef> nodes, const ShapeChange& change) {
    EXPECTS(std::ranges::is_sorted(nodes));
    NodeEdit edit{std::move(level), {}};
    std::vector<Key> gone;
    for (auto own = nodes.begin(); own != nodes.end();) {
        const auto next = std::find_if(own, nodes.end(), [&](const NodeRef& node) { return node.key != own->key; });
        const int index = edit.level.objects.indexOf(own->key);
        if (index >= 0 && std::holds_alternative<BodyObject>(edit.level.objects[index].data)) {
            Object object = edit.level.objects[index];
            Reshaping reshaping(object, edit.nodes);
            for (auto of = own; of != next;) {
                const auto end = std::find_if(of, next, [&](const NodeRef& node) { return node.shape != of->shape; });
                if (std::all_of(of, end, [&](const NodeRef& node) {
                        return hasNode(edit.level.objects[index].data, node.shape, node.vertex);
                    })) {
                    reshaping.change({of, end}, change);
                }
                of = end;
            }
            if (reshaping.finish()) {
                if (std::get<BodyObject>(object.data).shapes.empty()) {
                    gone.push_back(object.key);
                } else {
                    edit.level.objects.replace(index, std::move(object));
                }
            }
        } else if (index >= 0) {
            edit.nodes.insert(edit.nodes.end(), own, next);
        }
        own = next;
    }
    if (!gone.empty()) {
        edit.level = removed(std::move(edit.level), gone);
    }
    std::ranges::sort(edit.nodes);
    return edit;
}

LevelShape withVertices(const LevelShape& shape, std::vector<Vec2> vertices, bool closed) {
    LevelShape result = shape;
    *verticesOf(result) = std::move(vertices);
    if (auto* edges = std::get_if<EdgeChain>(&result)) {
        edges->closed = closed;
    } else if (auto* lines = std::get_if<LineChain>(&result)) {
        lines->closed = closed;
    }
    return result;
}

bool isWhole(const LevelShape& shape) {
    const std::vector<Vec2>& vertices = *verticesOf(shape);
    const std::size_t least = std::holds_alternative<Polygon>(shape) ? 3 : 2;
    return vertices.size() >= least &&
           !std::ranges::all_of(vertices, [&vertices](const Vec2& vertex) { return vertex == vertices.front(); });
}

std::vector<std::vector<int>> splitRuns(int count, bool closed, const std::vector<bool>& split) {
    const auto first = std::ranges::find(split, true);
    std::vector<std::vector<int>> runs;
    if (count < 2 || (closed && first == split.end())) {
        return runs;
    }
    const int start = closed ? static_cast<int>(first - split.begin()) : 0;
    const int segments = closed ? count : count - 1;
    std::vector<int> run{start};
    for (int i = 1; i <= segments; ++i) {
        const int vertex = (start + i) % count;
        run.push_back(vertex);
        if (i == segments || split[static_cast<std::size_t>(vertex)]) {
            runs.push_back(std::move(run));
            run = {vertex};
        }
    }
    return runs;
}

LevelShape chainOf(const LevelShape& shape, const std::vector<int>& run) {
    const std::vector<Vec2>& all = *verticesOf(shape);
    std::vector<Vec2> vertices;
    vertices.reserve(run.size());
    for (const int vertex : run) {
        vertices.push_back(all[static_cast<std::size_t>(vertex)]);
    }
    return withVertices(shape, std::move(vertices), false);
}

} // namespace spacetow
