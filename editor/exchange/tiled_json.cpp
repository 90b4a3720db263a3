#include "editor/exchange/json_values.h"
#include "editor/exchange/tiled_map.h"
#include "editor/exchange/tiled_values.h"

#include <algorithm>
#include <charconv>

namespace spacetow {

namespace {

std::string jsonClass(const JsonView& object) {
    const std::string name = jsonText(object, "class");
    return name.empty() ? jsonText(object, "type") : name;
}

std::string spelledValue(const JsonView& value) {
    constexpr std::size_t longest = 1000;
    return value.isText() ? value.text() : value.spelled(longest);
}

std::vector<TiledProperty> jsonProperties(const JsonView& object) {
    std::vector<TiledProperty> properties;
    const std::optional<JsonView> list = jsonMember(object, "properties");
    if (!list) {
        return properties;
    }
    for (const JsonView one : *list) {
        if (list->isArray()) {
            const std::optional<JsonView> value = jsonMember(one, "value");
            properties.push_back(
                {jsonText(one, "name"), jsonText(one, "type"), value ? spelledValue(*value) : std::string()});
        } else if (list->isObject()) { // before Tiled 1.2
            properties.push_back({one.name(),
                                  one.isBool()     ? "bool"
                                  : one.isNumber() ? "float"
                                                   : "",
                                  spelledValue(one)});
        }
    }
    return properties;
}

std::vector<Vec2> jsonPoints(const JsonView& list) {
    std::vector<Vec2> points;
    if (list.isArray()) {
        for (const JsonView point : list) {
            points.emplace_back(jsonNumber(point, "x"), jsonNumber(point, "y"));
        }
    }
    return points;
}

TiledForm jsonForm(const JsonView& object, std::vector<Vec2>& points) {
    if (jsonMember(object, "template")) {
        return TiledForm::Template;
    }
    if (jsonMember(object, "gid")) {
        return TiledForm::Tile;
    }
    for (const bool isClosed : {true, false}) {
        if (const std::optional<JsonView> list = jsonMember(object, isClosed ? "polygon" : "polyline")) {
            points = jsonPoints(*list);
            return isClosed ? TiledForm::Polygon : TiledForm::Polyline;
        }
    }
    if (jsonMember(object, "capsule")) {
        return TiledForm::Other;
    }
    return jsonFlag(object, "ellipse")  ? TiledForm::Ellipse
           : jsonFlag(object, "point")  ? TiledForm::Point
           : jsonMember(object, "text") ? TiledForm::Text
                                        : TiledForm::Rectangle;
}

TiledObject jsonObject(const JsonView& json) {
    TiledObject object;
    object.name = jsonText(json, "name");
    object.className = jsonClass(json);
    object.at = {jsonNumber(json, "x"), jsonNumber(json, "y")};
    object.size = {jsonNumber(json, "width"), jsonNumber(json, "height")};
    object.degrees = jsonNumber(json, "rotation");
    object.visible = jsonFlag(json, "visible", true);
    object.form = jsonForm(json, object.points);
    object.properties = jsonProperties(json);
    object.line = json.line();
    return object;
}

TiledLayerKind jsonLayerKind(const JsonView& json) {
    const std::string type = jsonText(json, "type");
    return type == "tilelayer"    ? TiledLayerKind::Tiles
           : type == "imagelayer" ? TiledLayerKind::Image
           : type == "group"      ? TiledLayerKind::Group
                                  : TiledLayerKind::Objects;
}

std::string jsonEncoding(const JsonView& json) {
    const std::string encoding = jsonText(json, "encoding");
    const std::string compression = jsonText(json, "compression");
    return (encoding.empty() ? "csv" : encoding) + (compression.empty() ? std::string() : ", " + compression);
}

std::vector<TiledLayer> jsonLayers(const JsonView& parent) {
    std::vector<TiledLayer> layers;
    const std::optional<JsonView> list = jsonMember(parent, "layers");
    if (!list || !list->isArray()) {
        return layers;
    }
    for (const JsonView json : *list) {
        TiledLayer layer;
        layer.kind = jsonLayerKind(json);
        layer.name = jsonText(json, "name");
        layer.className = jsonText(json, "class");
        layer.encoding = layer.kind == TiledLayerKind::Tiles ? jsonEncoding(json) : std::string();
        layer.offset = {jsonNumber(json, "offsetx"), jsonNumber(json, "offsety")};
        layer.parallax = {jsonNumber(json, "parallaxx", 1), jsonNumber(json, "parallaxy", 1)};
        layer.opacity = jsonNumber(json, "opacity", 1);
        layer.visible = jsonFlag(json, "visible", true);
        layer.locked = jsonFlag(json, "locked");
        layer.color = tiledColor(jsonText(json, "color"));
        layer.properties = jsonProperties(json);
        layer.line = json.line();
        if (layer.kind == TiledLayerKind::Group) {
            layer.layers = jsonLayers(json);
        } else if (const std::optional<JsonView> objects = jsonMember(json, "objects"); objects && objects->isArray()) {
            for (const JsonView object : *objects) {
                layer.objects.push_back(jsonObject(object));
            }
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

} // namespace

TiledMap tiledMapFromJson(const JsonView& map, Report& report) {
    TiledMap out;
    out.orientation = jsonText(map, "orientation");
    out.tile = {jsonNumber(map, "tilewidth", 32), jsonNumber(map, "tileheight", 32)};
    out.tiles = {jsonNumber(map, "width"), jsonNumber(map, "height")};
    out.infinite = jsonFlag(map, "infinite");
    out.properties = jsonProperties(map);
    out.layers = jsonLayers(map);
    out.line = map.line();
    const std::optional<JsonView> sets = jsonMember(map, "tilesets");
    if (sets && sets->isArray()) {
        for (const JsonView set : *sets) {
            const std::string source = jsonText(set, "source");
            report.refuse("import-tilesets", set.line(), source.empty() ? jsonText(set, "name") : source);
        }
    }
    return out;
}

} // namespace spacetow
