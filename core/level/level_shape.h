#pragma once
// The shapes of bodies in a level document. Local coordinates, metres.

#include "core/geometry/shape.h"

#include <atomic>
#include <initializer_list>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace spacetow {

/// One-way walls joined end to end: each is solid for what comes from its left on the way from vertex to vertex.
struct EdgeChain {
    std::vector<Vec2> vertices; // at least two
    bool closed = false;        // the last vertex joins the first
    double depth = noBack;      // m, of every wall of the chain

    bool operator==(const EdgeChain&) const = default;
};

/// Walls joined end to end that are solid from both sides.
struct LineChain {
    std::vector<Vec2> vertices; // at least two
    bool closed = false;

    bool operator==(const LineChain&) const = default;
};

using LevelShape = std::variant<EdgeChain, LineChain, Polygon, Circle>;

/// A vector of shapes that copies share until one of them is changed, so that moving a wall of a hundred thousand
/// vertices costs no more than moving a box. Whatever is not const counts as a change.
class ShapeList {
  public:
    using Vector = std::vector<LevelShape>;
    using value_type = LevelShape; // NOLINT(readability-identifier-naming): the library's name
    using iterator = Vector::iterator;
    using const_iterator = Vector::const_iterator;

    ShapeList() = default;
    ShapeList(Vector shapes) : m_shapes(std::make_shared<Vector>(std::move(shapes))) {}
    ShapeList(std::initializer_list<LevelShape> shapes) : ShapeList(Vector(shapes)) {}

    operator const Vector&() const { return all(); }
    operator Vector&() { return own(); }

    std::size_t size() const { return all().size(); }
    bool empty() const { return all().empty(); }
    const LevelShape& operator[](std::size_t index) const { return all()[index]; }
    LevelShape& operator[](std::size_t index) { return own()[index]; }
    const LevelShape& front() const { return all().front(); }
    LevelShape& front() { return own().front(); }
    const LevelShape& back() const { return all().back(); }
    LevelShape& back() { return own().back(); }
    const_iterator begin() const { return all().begin(); }
    const_iterator end() const { return all().end(); }
    iterator begin() { return own().begin(); }
    iterator end() { return own().end(); }

    // NOLINTBEGIN(readability-identifier-naming): the names are the library's
    void push_back(LevelShape shape) { own().push_back(std::move(shape)); }
    template <class... Arguments>
    LevelShape& emplace_back(Arguments&&... arguments) {
        return own().emplace_back(std::forward<Arguments>(arguments)...);
    }
    // NOLINTEND(readability-identifier-naming)
    template <class... Arguments>
    iterator insert(Arguments&&... arguments) {
        return own().insert(std::forward<Arguments>(arguments)...);
    }
    template <class... Arguments>
    iterator erase(Arguments&&... arguments) {
        return own().erase(std::forward<Arguments>(arguments)...);
    }
    void clear() { m_shapes.reset(); }

    /// Shared shapes are not looked into.
    bool operator==(const ShapeList& other) const { return m_shapes == other.m_shapes || all() == other.all(); }

  private:
    const Vector& all() const {
        static const Vector none;
        return m_shapes ? *m_shapes : none;
    }
    Vector& own() {
        if (!m_shapes) {
            m_shapes = std::make_shared<Vector>();
        } else if (m_shapes.use_count() > 1) {
            m_shapes = std::make_shared<Vector>(*m_shapes);
        }
        // Whoever let go of them last has finished reading.
        std::atomic_thread_fence(std::memory_order_acquire);
        return *m_shapes;
    }

    std::shared_ptr<Vector> m_shapes; // null for none
};

} // namespace spacetow
