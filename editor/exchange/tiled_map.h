#pragma once
// A map of Tiled, as far as it can become part of a level: from XML (.tmx) or JSON (.tmj). Pixels, degrees clockwise,
// y down.

#include "core/level/json_tree.h"
#include "core/math/vec.h"
#include "editor/exchange/report.h"
#include "editor/exchange/xml_tree.h"

#include <optional>
#include <string>
#include <vector>

namespace spacetow {

struct TiledProperty {
    std::string name, type, value;
};

enum class TiledForm : std::uint8_t { Rectangle, Ellipse, Point, Polygon, Polyline, Text, Tile, Template, Other };

struct TiledObject {
    std::string name, className;
    Vec2 at{0, 0};
    Vec2 size{0, 0};
    double degrees = 0;
    bool visible = true;
    TiledForm form = TiledForm::Rectangle;
    std::vector<Vec2> points; // relative to `at`
    std::vector<TiledProperty> properties;
    int line = 0;
};

enum class TiledLayerKind : std::uint8_t { Objects, Group, Tiles, Image };

struct TiledLayer {
    TiledLayerKind kind = TiledLayerKind::Objects;
    std::string name, className;
    std::string encoding; // of tiles: "csv", "base64, zlib"
    Vec2 offset{0, 0};
    Vec2 parallax{1, 1};
    double opacity = 1;
    bool visible = true, locked = false;
    std::optional<std::uint32_t> color;
    std::vector<TiledProperty> properties;
    std::vector<TiledObject> objects;
    std::vector<TiledLayer> layers;
    int line = 0;
};

struct TiledMap {
    std::string orientation = "orthogonal";
    Vec2 tile{32, 32}; // px
    Vec2 tiles{0, 0};  // how many
    bool infinite = false;
    std::vector<TiledProperty> properties;
    std::vector<TiledLayer> layers;
    int line = 0;
};

/// Of tilesets is reported that they are not needed.
TiledMap tiledMapFromXml(const XmlElement& map, Report& report);
TiledMap tiledMapFromJson(const JsonView& map, Report& report);

} // namespace spacetow
