#include "editor/editing/typing_hint.h"

namespace spacetow {

Hint typingHint(const TypedEntry& entry) {
    if (entry.faulty >= 0) {
        return {entry.fault, {entry.texts[static_cast<std::size_t>(entry.faulty)]}};
    }
    switch (entry.kind) {
    case TypedKind::SpeedAngle:
        return {"typing.speed-angle", {}};
    case TypedKind::WidthHeight:
        return {"typing.width-height", {}};
    case TypedKind::Radius:
        return {"typing.radius", {}};
    case TypedKind::LengthAngle:
        break;
    }
    return {"typing.length-angle", {}};
}

} // namespace spacetow
