#include "core/geometry/supporting_corners.h"

namespace spacetow {

namespace {

/// Whether the corner may meet the face. One at the end of a face that lies flat on it does so with what of that
/// belongs to the outline and is over the face.
bool supports(const ConvexPart& part, int corner, const Vec2& normal, const Span& span) {
    if (!cornerSupports(part, corner, -normal)) {
        return false;
    }
    bool isFlat = false;
    for (const int face : {corner, cornerBefore(part, corner)}) {
        if (liesFlat(part, face, normal)) {
            isFlat = true;
            if (isOuterFace(part, face) &&
                span.overlaps(cornerOf(part, face), cornerOf(part, cornerAfter(part, face)))) {
                return true;
            }
        }
    }
    return !isFlat;
}

bool continuesInside(const ConvexPart& part, int face, int beside) {
    return !isOuterFace(part, beside) && normalOf(part, face).dot(normalOf(part, beside)) > 1 - 1e-9;
}

} // namespace

bool levelSupports(const ConvexPart& part, int corner, const ConvexPart& reference, int face) {
    if (!isCut(part)) {
        return true;
    }
    const Vec2& normal = normalOf(reference, face);
    const double depth = normal.dot(cornerOf(part, corner));
    const Span span(reference, face);
    for (int k = 0; k < part.count; ++k) {
        if (std::fabs(normal.dot(cornerOf(part, k)) - depth) <= sameDepth && supports(part, k, normal, span)) {
            return true;
        }
    }
    return false;
}

bool mayBeReferenceFace(const ConvexPart& reference, int face, const ConvexPart& other) {
    const int before = cornerBefore(reference, face);
    if (!continuesInside(reference, face, before) && !continuesInside(reference, face, cornerAfter(reference, face))) {
        return true;
    }
    const Span span(reference, face);
    return span.overlaps(cornerOf(other, deepestCorner(other, span.along)),
                         cornerOf(other, deepestCorner(other, -span.along)));
}

} // namespace spacetow
