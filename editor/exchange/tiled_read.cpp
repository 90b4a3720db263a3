#include "editor/exchange/tiled_read.h"

#include "editor/exchange/svg_values.h"
#include "editor/exchange/tiled_values.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// What objects get from the layers around them.
struct TiledPlace {
    Vec2 offset{0, 0}; // px
    std::vector<std::string> tags;
    int folder = -1;
};

class TiledReader {
  public:
    TiledReader(const TiledMap& map, Report& report) : m_map(map), m_report(report) {
        const Vec2 tile = map.tile;
        double height = map.tiles.y() * tile.y();
        if (map.orientation == "isometric" && tile.y() > 0) {
            const double half = tile.x() / (2 * tile.y());
            m_projection = Affine{{half, 0.5}, {-half, 0.5}, {0, 0}};
            height = (map.tiles.x() + map.tiles.y()) * tile.y() / 2;
            m_shift = Vec2(map.infinite ? 0 : map.tiles.y() * tile.x() / 2, 0);
        }
        m_page = Affine{{1, 0}, {0, -1}, {0, map.infinite ? 0 : height}};
    }

    Drawing read() {
        const double width = m_map.tile.x();
        m_drawing.metresPerUnit = width > 0 && width < 1e5 ? 1 / width : 1.0 / 32;
        for (const TiledProperty& property : m_map.properties) {
            m_report.refuse("import-property", m_map.line, property.name);
        }
        readLayers(m_map.layers, {});
        return std::move(m_drawing);
    }

  private:
    void readLayers(const std::vector<TiledLayer>& layers, const TiledPlace& around) {
        for (const TiledLayer& layer : layers) {
            if (layer.kind == TiledLayerKind::Tiles) {
                m_report.refuse("import-tiles", layer.line, layer.name + " (" + layer.encoding + ')');
            } else if (layer.kind == TiledLayerKind::Image) {
                m_report.refuse("import-image-layer", layer.line, layer.name);
            } else {
                readLayer(layer, around);
            }
        }
    }

    void readLayer(const TiledLayer& layer, const TiledPlace& around) {
        TiledPlace place = around;
        place.offset += layer.offset;
        m_drawing.items.push_back({layer.name, around.folder, layer.visible, layer.locked, layer.line,
                                   Folder{around.folder < 0, layer.color}});
        place.folder = static_cast<int>(m_drawing.items.size()) - 1;
        if (!layer.className.empty()) {
            place.tags.push_back(layer.className);
        }
        Figure settings;
        settings.tags = std::move(place.tags);
        for (const TiledProperty& property : layer.properties) {
            if (!takeTag(property, settings)) {
                m_report.refuse("import-property", layer.line, property.name);
            }
        }
        place.tags = std::move(settings.tags);
        if (layer.opacity < 1) {
            m_report.refuse("import-opacity", layer.line, layer.name);
        }
        if (layer.parallax != Vec2(1, 1)) {
            m_report.refuse("import-parallax", layer.line, layer.name);
        }
        for (const TiledObject& object : layer.objects) {
            readObject(object, place);
        }
        readLayers(layer.layers, place);
    }

    void readObject(const TiledObject& object, const TiledPlace& place) {
        if (const std::optional<ExchangeCode> code = refusalOf(object)) {
            m_report.refuse(*code, object.line, object.name);
            return;
        }
        const std::string role = lowered(object.className.empty() ? object.name : object.className);
        const Affine map = mapOf(object, place);
        if (std::optional<ObjectData> ready = readyObject(object, role, map)) {
            add(object, place, ReadyObject{std::move(*ready)});
            return;
        }
        if (object.form == TiledForm::Point) {
            m_report.refuse("import-points", object.line, object.name);
            return;
        }
        Figure figure = figureOf(object, map);
        figure.tags = place.tags;
        if (!object.className.empty()) {
            figure.tags.push_back(object.className);
        }
        for (const TiledProperty& property : object.properties) {
            if (!takeTag(property, figure) && !takeMaterial(property, figure)) {
                m_report.refuse("import-property", object.line, property.name);
            }
        }
        add(object, place, std::move(figure));
    }

    static std::optional<ExchangeCode> refusalOf(const TiledObject& object) {
        switch (object.form) {
        case TiledForm::Text:
            return ExchangeCode("import-text");
        case TiledForm::Tile:
            return ExchangeCode("import-tile-objects");
        case TiledForm::Template:
            return ExchangeCode("import-templates");
        case TiledForm::Other:
            return ExchangeCode("import-tiled-form");
        default:
            return {};
        }
    }

    void add(const TiledObject& object, const TiledPlace& place, std::variant<Figure, Folder, ReadyObject> what) {
        m_drawing.items.push_back({object.name, place.folder, object.visible, false, object.line, std::move(what)});
    }

    /// Objects are turned about their corner on the screen, after they were projected.
    Affine mapOf(const TiledObject& object, const TiledPlace& place) const {
        const Vec2 at = m_projection(object.at) + m_shift + place.offset;
        const double radians = std::fmod(object.degrees, 360) * std::numbers::pi / 180;
        return m_page * Affine::translation(at) * Affine::rotation({0, 0}, radians) * m_projection;
    }

    /// A point that is called a ship or a payload is one, a line that is called a finish as well.
    static std::optional<ObjectData> readyObject(const TiledObject& object, const std::string& role,
                                                 const Affine& map) {
        if (object.form == TiledForm::Point && role == "ship") {
            return ShipObject{map.origin, -std::fmod(object.degrees, 360) * std::numbers::pi / 180};
        }
        if (object.form == TiledForm::Point && role == "payload") {
            PayloadObject payload;
            payload.position = map.origin;
            return payload;
        }
        if (object.form == TiledForm::Polyline && role == "finish" && object.points.size() >= 2) {
            return FinishObject{map(object.points.front()), map(object.points.back())};
        }
        return {};
    }

    static Figure figureOf(const TiledObject& object, const Affine& map) {
        Figure figure;
        figure.filled = object.form != TiledForm::Polyline;
        figure.stroked = !figure.filled;
        const Vec2 size = object.size;
        if (object.form == TiledForm::Ellipse) {
            const std::optional<double> stretch = similarityOf(map);
            if (size.x() == size.y() && stretch && size.x() > 0) {
                figure.circles.push_back({map(size / 2), size.x() / 2 * *stretch});
            } else if (size.x() > 0 && size.y() > 0) {
                figure.paths.push_back(mapped(ellipsePath(size / 2, {size.x() / 2, 0}, {0, size.y() / 2}), map));
            }
            return figure;
        }
        std::vector<Vec2> points = object.points;
        if (object.form == TiledForm::Rectangle) {
            points = {{0, 0}, {size.x(), 0}, size, {0, size.y()}};
        }
        std::ranges::transform(points, points.begin(), map);
        figure.paths.push_back(polygonPath(std::move(points), figure.filled));
        return figure;
    }

    /// A property that is on is a tag of its name; "tags" lists some, separated by commas.
    static bool takeTag(const TiledProperty& property, Figure& figure) {
        constexpr std::size_t most = 2 * TagTable::size; // what is more can have no place
        if (figure.tags.size() >= most) {
            return property.type == "bool";
        }
        if (property.type == "bool") {
            if (property.value == "true") {
                figure.tags.push_back(property.name);
            }
            return true;
        }
        const std::string name = lowered(property.name);
        if (name != "tags" && name != "tag") {
            return false;
        }
        std::string_view rest = property.value;
        while (!rest.empty() && figure.tags.size() < most) {
            const std::size_t end = std::min(rest.find(','), rest.size());
            if (const std::string_view tag = trimmed(rest.substr(0, end)); !tag.empty()) {
                figure.tags.emplace_back(tag);
            }
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return true;
    }

    static bool takeMaterial(const TiledProperty& property, Figure& figure) {
        const std::string name = lowered(property.name);
        const double value = tiledNumber(property.value, -1);
        constexpr double mostFriction = 100;
        constexpr double mostDensity = 1e9; // kg/m²
        if (name == "friction" && value >= 0 && value <= mostFriction) {
            figure.friction = value;
        } else if (name == "restitution" && value >= 0 && value <= 1) {
            figure.restitution = value;
        } else if (name == "density" && value > 0 && value <= mostDensity) {
            figure.density = value;
        } else {
            return false;
        }
        return true;
    }

    const TiledMap& m_map;
    Report& m_report;
    Affine m_projection;
    Affine m_page; // y down to y up
    Vec2 m_shift{0, 0};
    Drawing m_drawing;
};

} // namespace

Drawing tiledDrawing(const TiledMap& map, Report& report) {
    return TiledReader(map, report).read();
}

} // namespace spacetow
