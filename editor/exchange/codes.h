#pragma once
// Why a drawing cannot be imported, and what of it is left out.

#include "core/game/codes.h"

namespace spacetow {

inline constexpr std::string_view importCodes[] = {
    "import-not-xml",
    "import-entities",
    "import-too-deep",
    "import-too-many",
    "import-stopped",
    "import-compressed",
    "import-unknown",
    "import-level",
    "import-tileset",
    "import-too-far",
    "import-too-many-vertices",
    "import-nothing",
    "import-text",
    "import-image",
    "import-foreign",
    "import-animation",
    "import-script",
    "import-style",
    "import-hidden",
    "import-unpainted",
    "import-transform",
    "import-clip",
    "import-window",
    "import-stroke-width",
    "import-filter",
    "import-use",
    "import-bad-data",
    "import-flat",
    "import-holes",
    "import-large-polygon",
    "import-tangled",
    "import-tiles",
    "import-image-layer",
    "import-tilesets",
    "import-tile-objects",
    "import-templates",
    "import-tiled-form",
    "import-points",
    "import-property",
    "import-opacity",
    "import-parallax",
    "import-gravity",
    "import-range",
    "import-fixture",
    "import-filter-groups",
    "import-material",
    "import-sensors",
    "import-body-setting",
    "import-no-fixture",
    "import-joint",
    "import-rigid-joint",
    "import-one-only",
    "import-tags-full",
};

using ExchangeCode = GameCode::And<importCodes>;

} // namespace spacetow
