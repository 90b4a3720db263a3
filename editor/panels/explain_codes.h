#pragma once
// Why two objects do not collide, and what would cure it.

#include "core/base/code.h"

namespace spacetow {

inline constexpr std::string_view explainCodes[] = {
    "apart-touch",       "apart-same-body",  "apart-inactive",  "apart-unmovable", "apart-no-tags",
    "apart-mask",        "apart-both-masks", "apart-connected", "apart-rope",      "apart-intangible",
    "apart-felt",        "apart-walls",      "apart-passing",   "apart-behind",    "apart-distance",
    "apart-next-update", "cure-tick-tag",    "cure-give-tag",   "cure-make-solid", "cure-let-collide",
};

using ExplainCode = CodeOf<explainCodes>;

} // namespace spacetow
