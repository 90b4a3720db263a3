#pragma once
// Maps the world to a picture: one scale for both axes, so that circles stay round whatever the shape of the picture,
// and y turned over. World coordinates in metres, picture coordinates from its top left corner, y down.

#include "core/math/aabb.h"

#include <algorithm>

namespace spacetow {

struct ViewTransform {
    Vec2 center{0, 0};   // world point in the middle of the picture
    double scale = 66;   // picture units a metre, > 0
    Vec2 size{880, 660}; // of the picture

    /// The whole box in the middle of the picture, as large as fits. The picture shows more of the world on two sides
    /// unless it has the same shape. Neither may be empty.
    static ViewTransform fitting(const Aabb& box, const Vec2& size) {
        const Vec2 extent = box.size();
        return {box.center(), std::min(size.x() / extent.x(), size.y() / extent.y()), size};
    }

    Vec2 toView(const Vec2& world) const {
        return {size.x() / 2 + (world.x() - center.x()) * scale, size.y() / 2 - (world.y() - center.y()) * scale};
    }
    Vec2 toWorld(const Vec2& view) const {
        return {center.x() + (view.x() - size.x() / 2) / scale, center.y() - (view.y() - size.y() / 2) / scale};
    }
    /// `min` is the top left corner.
    Aabb toView(const Aabb& world) const {
        return {toView(Vec2(world.min.x(), world.max.y())), toView(Vec2(world.max.x(), world.min.y()))};
    }
    double toView(double metres) const { return metres * scale; }
};

} // namespace spacetow
