#include "editor/exchange/svg_path.h"
#include "editor/exchange/tiled_map.h"
#include "editor/exchange/tiled_values.h"

#include <algorithm>

namespace spacetow {

namespace {

double numberOf(const XmlElement& element, const char* name, double otherwise = 0) {
    return tiledNumber(element.attribute(name), otherwise);
}

const XmlElement* childOf(const XmlElement& element, std::string_view name) {
    const auto found = std::ranges::find(element.children, name, &XmlElement::name);
    return found == element.children.end() ? nullptr : &*found;
}

/// What was the type of an object is its class since Tiled 1.9, and the other way round again since 1.10.
std::string classOf(const XmlElement& element) {
    return element.has("class") ? element.attribute("class") : element.attribute("type");
}

std::vector<TiledProperty> xmlProperties(const XmlElement& element) {
    std::vector<TiledProperty> properties;
    if (const XmlElement* const list = childOf(element, "properties")) {
        for (const XmlElement& one : list->children) {
            if (one.name == "property") {
                properties.push_back({one.attribute("name"), one.attribute("type"),
                                      one.has("value") ? one.attribute("value") : one.text});
            }
        }
    }
    return properties;
}

std::vector<Vec2> pointsIn(const XmlElement& element) {
    std::vector<Vec2> points;
    NumberScanner scanner(element.attribute("points"));
    while (const std::optional<double> x = scanner.number()) {
        points.emplace_back(*x, scanner.number().value_or(0));
    }
    return points;
}

TiledForm xmlForm(const XmlElement& element, std::vector<Vec2>& points) {
    if (element.has("template")) {
        return TiledForm::Template;
    }
    if (element.has("gid")) {
        return TiledForm::Tile;
    }
    for (const XmlElement& child : element.children) {
        if (child.name == "polygon" || child.name == "polyline") {
            points = pointsIn(child);
            return child.name == "polygon" ? TiledForm::Polygon : TiledForm::Polyline;
        }
        if (child.name == "ellipse" || child.name == "point" || child.name == "text") {
            return child.name == "ellipse" ? TiledForm::Ellipse
                   : child.name == "point" ? TiledForm::Point
                                           : TiledForm::Text;
        }
        if (child.name != "properties") {
            return TiledForm::Other;
        }
    }
    return TiledForm::Rectangle;
}

TiledObject xmlObject(const XmlElement& element) {
    TiledObject object;
    object.name = element.attribute("name");
    object.className = classOf(element);
    object.at = {numberOf(element, "x"), numberOf(element, "y")};
    object.size = {numberOf(element, "width"), numberOf(element, "height")};
    object.degrees = numberOf(element, "rotation");
    object.visible = element.attribute("visible") != "0";
    object.form = xmlForm(element, object.points);
    object.properties = xmlProperties(element);
    object.line = element.line;
    return object;
}

std::string encodingOf(const XmlElement& element) {
    const XmlElement* const data = childOf(element, "data");
    if (data == nullptr || data->attribute("encoding").empty()) {
        return "XML";
    }
    const std::string& compression = data->attribute("compression");
    return data->attribute("encoding") + (compression.empty() ? std::string() : ", " + compression);
}

std::optional<TiledLayerKind> layerKind(const std::string& name) {
    return name == "objectgroup"  ? std::optional(TiledLayerKind::Objects)
           : name == "group"      ? std::optional(TiledLayerKind::Group)
           : name == "layer"      ? std::optional(TiledLayerKind::Tiles)
           : name == "imagelayer" ? std::optional(TiledLayerKind::Image)
                                  : std::nullopt;
}

std::vector<TiledLayer> xmlLayers(const XmlElement& parent) {
    std::vector<TiledLayer> layers;
    for (const XmlElement& element : parent.children) {
        const std::optional<TiledLayerKind> kind = layerKind(element.name);
        if (!kind) {
            continue;
        }
        TiledLayer layer;
        layer.kind = *kind;
        layer.name = element.attribute("name");
        layer.className = classOf(element);
        layer.encoding = *kind == TiledLayerKind::Tiles ? encodingOf(element) : std::string();
        layer.offset = {numberOf(element, "offsetx"), numberOf(element, "offsety")};
        layer.parallax = {numberOf(element, "parallaxx", 1), numberOf(element, "parallaxy", 1)};
        layer.opacity = numberOf(element, "opacity", 1);
        layer.visible = element.attribute("visible") != "0";
        layer.locked = element.attribute("locked") == "1";
        layer.color = tiledColor(element.attribute("color"));
        layer.properties = xmlProperties(element);
        layer.line = element.line;
        if (*kind == TiledLayerKind::Group) {
            layer.layers = xmlLayers(element);
        } else if (*kind == TiledLayerKind::Objects) {
            for (const XmlElement& child : element.children) {
                if (child.name == "object") {
                    layer.objects.push_back(xmlObject(child));
                }
            }
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

} // namespace

TiledMap tiledMapFromXml(const XmlElement& map, Report& report) {
    TiledMap out;
    out.orientation = map.attribute("orientation");
    out.tile = {numberOf(map, "tilewidth", 32), numberOf(map, "tileheight", 32)};
    out.tiles = {numberOf(map, "width"), numberOf(map, "height")};
    out.infinite = map.attribute("infinite") == "1";
    out.properties = xmlProperties(map);
    out.layers = xmlLayers(map);
    out.line = map.line;
    for (const XmlElement& child : map.children) {
        if (child.name == "tileset") {
            report.refuse("import-tilesets", child.line,
                          child.has("source") ? child.attribute("source") : child.attribute("name"));
        }
    }
    return out;
}

} // namespace spacetow
