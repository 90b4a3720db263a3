#include "editor/exchange/svg_read.h"

#include "editor/exchange/codes.h"
#include "editor/exchange/report.h"
#include "editor/exchange/svg_shapes.h"
#include "editor/exchange/svg_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spacetow {

namespace {

constexpr double svgMetresPerPixel = 0.01; // an A4 page is then 8 m wide
constexpr double wideStroke = 3;           // px; what is narrower looks like a wall without thickness
constexpr int maxSvgElements = 250'000;    // those that "use" draws again counted each time
constexpr int maxPieces = 2'000'000;       // of all paths, likewise
constexpr int maxSvgDepth = 250;           // likewise

/// What an element inherits from those around it.
struct SvgPlace {
    Affine map; // to units of the drawing
    SvgStyle style;
    Vec2 window{100, 100}; // what percentages are of
    int folder = -1;
    int depth = 0;
};

struct Refusal {
    std::string_view element;
    ExchangeCode code;
};
/// What is seen in the picture but is no shape.
constexpr std::array refusals{
    Refusal{"text", "import-text"},
    Refusal{"flowRoot", "import-text"},
    Refusal{"image", "import-image"},
    Refusal{"foreignObject", "import-foreign"},
    Refusal{"animate", "import-animation"},
    Refusal{"animateTransform", "import-animation"},
    Refusal{"animateMotion", "import-animation"},
    Refusal{"set", "import-animation"},
    Refusal{"script", "import-script"},
    Refusal{"video", "import-image"},
};

std::string svgName(const XmlElement& element) {
    if (element.has("inkscape:label")) {
        return element.attribute("inkscape:label");
    }
    const auto title = std::ranges::find(element.children, "title", &XmlElement::name);
    if (title != element.children.end() && !trimmed(title->text).empty()) {
        return std::string(trimmed(title->text));
    }
    return element.attribute("id");
}

class SvgReader {
  public:
    explicit SvgReader(const Watch& watch) : m_watch(watch) {}

    Result<Drawing> read(const XmlElement& root) {
        survey(root);
        m_drawing.metresPerUnit = svgMetresPerPixel;
        SvgPlace place;
        place.style = styleOf(root, m_sheet, {});
        const std::optional<ViewBox> box = viewBoxFromText(root.attribute("viewBox"));
        const Vec2 natural = box ? box->size : Vec2(0, 0);
        const Vec2 page(svgLength(root, "width", LengthAxis::X, natural).value_or(natural.x()),
                        svgLength(root, "height", LengthAxis::Y, natural).value_or(natural.y()));
        const bool hasPage = page.x() > 0 && page.y() > 0;
        place.map = Affine{{1, 0}, {0, -1}, {0, hasPage ? page.y() : 0}};
        place.window = hasPage ? page : place.window;
        if (box && hasPage) {
            place.map = place.map * viewBoxMap(*box, page, root.attribute("preserveAspectRatio"));
            place.window = box->size;
        }
        readChildren(root, place);
        if (m_error) {
            return *m_error;
        }
        m_drawing.notes = m_report.notes();
        return std::move(m_drawing);
    }

  private:
    /// Identities and style sheets, which may come after those that need them.
    void survey(const XmlElement& element) {
        const std::string& id = element.attribute("id");
        if (!id.empty()) {
            m_byId.emplace(id, &element);
        }
        m_hasLayers = m_hasLayers || element.attribute("inkscape:groupmode") == "layer";
        if (element.name == "style" && !m_sheet.add(element.text)) {
            m_report.refuse("import-style", element.line);
        }
        for (const XmlElement& child : element.children) {
            m_sheet.place(child, element);
            survey(child);
        }
    }

    void readChildren(const XmlElement& element, const SvgPlace& place) {
        for (const XmlElement& child : element.children) {
            if (m_error) {
                return;
            }
            readElement(child, place);
        }
    }

    void readElement(const XmlElement& element, const SvgPlace& around) {
        constexpr int pace = 64;
        if (++m_count > maxSvgElements) {
            m_error = Error{ExchangeCode("import-too-many"), {std::to_string(maxSvgElements)}};
        } else if (m_count % pace == 0 && m_watch.isStopped()) {
            m_error = Error{ExchangeCode("import-stopped"), {}};
        }
        if (isRefused(element) || !isDrawn(element)) {
            return;
        }
        SvgPlace place = around;
        if (++place.depth > maxSvgDepth) {
            m_report.refuse("import-use", element.line, svgName(element));
            return;
        }
        place.style = styleOf(element, m_sheet, around.style);
        if (!place.style.displayed) {
            m_report.refuse("import-hidden", element.line, svgName(element));
            return;
        }
        tellOfEffects(element, place.style);
        if (const std::string& text = element.attribute("transform"); !text.empty()) {
            const std::optional<Affine> own = transformFromText(text);
            place.map = place.map * own.value_or(Affine{});
            if (!own) {
                m_report.refuse("import-transform", element.line, svgName(element));
            }
        }
        readDrawn(element, place);
    }

    static bool isDrawn(const XmlElement& element) {
        constexpr std::array<std::string_view, 5> containers{"g", "a", "svg", "use", "switch"};
        return isSvgShape(element.name) || std::ranges::find(containers, element.name) != containers.end();
    }

    void tellOfEffects(const XmlElement& element, const SvgStyle& style) {
        if (style.clipped) {
            m_report.refuse("import-clip", element.line, svgName(element));
        }
        if (style.filtered) {
            m_report.refuse("import-filter", element.line, svgName(element));
        }
    }

    void readDrawn(const XmlElement& element, const SvgPlace& place) {
        if (element.name == "use") {
            readUse(element, place);
        } else if (element.name == "svg") {
            readWindow(element, place, element);
        } else if (element.name == "switch") {
            readSwitch(element, place);
        } else if (isSvgShape(element.name)) {
            readShape(element, place);
        } else {
            readChildren(element, inFolder(element, svgName(element), place));
        }
    }

    SvgPlace inFolder(const XmlElement& element, const std::string& name, SvgPlace place) {
        const bool isTop = place.folder < 0 && element.name == "g";
        const bool isLayer =
            isTop && (m_hasLayers ? element.attribute("inkscape:groupmode") == "layer" : !name.empty());
        const bool isLocked = element.attribute("sodipodi:insensitive") == "true";
        m_drawing.items.push_back({name, place.folder, true, isLocked, element.line, Folder{isLayer, {}}});
        place.folder = static_cast<int>(m_drawing.items.size()) - 1;
        return place;
    }

    /// The first child that does not ask for something special.
    void readSwitch(const XmlElement& element, const SvgPlace& place) {
        for (const XmlElement& child : element.children) {
            if (isDrawn(child) && child.attribute("requiredExtensions").empty()) {
                readElement(child, place);
                return;
            }
        }
    }

    /// An <svg> or a <symbol>; `sized` may say its size instead.
    void readWindow(const XmlElement& element, SvgPlace place, const XmlElement& sized) {
        const auto length = [&](const char* name, LengthAxis axis) {
            const std::optional<double> first = svgLength(sized, name, axis, place.window);
            return first ? first : svgLength(element, name, axis, place.window);
        };
        const Vec2 size(length("width", LengthAxis::X).value_or(place.window.x()),
                        length("height", LengthAxis::Y).value_or(place.window.y()));
        if (!(size.x() > 0 && size.y() > 0)) {
            return;
        }
        const Vec2 corner(svgLength(element, "x", LengthAxis::X, place.window).value_or(0),
                          svgLength(element, "y", LengthAxis::Y, place.window).value_or(0));
        place.map = place.map * Affine::translation(corner);
        const Affine window = place.map;
        place.window = size;
        if (const std::optional<ViewBox> box = viewBoxFromText(element.attribute("viewBox"))) {
            place.map = place.map * viewBoxMap(*box, size, element.attribute("preserveAspectRatio"));
            place.window = box->size;
        }
        const std::string name = svgName(sized);
        const std::size_t first = m_drawing.items.size();
        readChildren(element, inFolder(element, name.empty() ? svgName(element) : name, place));
        if (!styleOf(element, m_sheet, {}).overflows && reachesBeyond(first, window, size)) {
            m_report.refuse("import-window", element.line, name.empty() ? svgName(element) : name);
        }
    }

    /// Whether anything drawn since that item lies outside of the window, which reaches from its corner to `size`.
    bool reachesBeyond(std::size_t first, const Affine& window, const Vec2& size) const {
        const double area = window.determinant();
        const double slack = 1e-6 * size.maxCoeff();
        const auto outside = [&](const Vec2& point) {
            const Vec2 away = point - window.origin;
            const Vec2 inside(cross(away, window.y) / area, cross(window.x, away) / area);
            return (inside.array() < -slack).any() || (inside.array() > size.array() + slack).any();
        };
        return area != 0 && std::any_of(m_drawing.items.begin() + static_cast<std::ptrdiff_t>(first),
                                        m_drawing.items.end(), [&](const DrawnItem& item) {
                                            const auto* figure = std::get_if<Figure>(&item.what);
                                            return figure != nullptr && anyCorner(*figure, outside);
                                        });
    }

    /// Of what is drawn: ends of pieces, and what is furthest out of circles.
    template <class Test>
    static bool anyCorner(const Figure& figure, const Test& test) {
        for (const DrawnPath& path : figure.paths) {
            const bool found = test(path.start) || std::ranges::any_of(path.pieces, [&](const PathPiece& piece) {
                                   return std::visit([&](const auto& one) { return test(one.to); }, piece);
                               });
            if (found) {
                return true;
            }
        }
        return std::ranges::any_of(figure.circles, [&](const Circle& circle) {
            const Vec2 right(circle.radius, 0);
            const Vec2 up(0, circle.radius);
            return test(circle.center + right) || test(circle.center - right) || test(circle.center + up) ||
                   test(circle.center - up);
        });
    }

    void readUse(const XmlElement& element, SvgPlace place) {
        const std::string& target = element.attribute("href");
        const auto found = target.starts_with('#') ? m_byId.find(std::string_view(target).substr(1)) : m_byId.end();
        if (found == m_byId.end()) {
            m_report.refuse("import-use", element.line, target.substr(0, 40));
            return;
        }
        place.map = place.map * Affine::translation({svgLength(element, "x", LengthAxis::X, place.window).value_or(0),
                                                     svgLength(element, "y", LengthAxis::Y, place.window).value_or(0)});
        const XmlElement& drawn = *found->second;
        if (drawn.name == "symbol" || drawn.name == "svg") {
            readWindow(drawn, place, element);
        } else {
            readElement(drawn, place);
        }
    }

    bool isRefused(const XmlElement& element) {
        const auto refusal = std::ranges::find(refusals, element.name, &Refusal::element);
        if (refusal != refusals.end()) {
            m_report.refuse(refusal->code, element.line, svgName(element));
        }
        return refusal != refusals.end();
    }

    void readShape(const XmlElement& element, const SvgPlace& place) {
        const std::string name = svgName(element);
        for (const XmlElement& child : element.children) {
            isRefused(child); // an animation
        }
        SvgShape shape = svgShape(element, place.window, place.style.fontSize);
        if (!shape.whole) {
            m_report.refuse("import-bad-data", element.line, name);
        }
        Figure figure;
        figure.filled = place.style.isFilled() && shape.fillable;
        figure.stroked = place.style.isStroked();
        figure.evenOdd = place.style.evenOdd;
        if (!place.style.visible || (!figure.filled && !figure.stroked)) {
            m_report.refuse("import-unpainted", element.line, name);
            return;
        }
        if (figure.stroked && place.style.strokeWidth * std::sqrt(std::abs(place.map.determinant())) > wideStroke) {
            m_report.refuse("import-stroke-width", element.line, name);
        }
        if (shape.circle) {
            const Circle& circle = *shape.circle;
            if (const std::optional<double> stretch = similarityOf(place.map)) {
                figure.circles.push_back({place.map(circle.center), circle.radius * *stretch});
            } else {
                shape.paths.push_back(ellipsePath(circle.center, {circle.radius, 0}, {0, circle.radius}));
            }
        }
        for (const DrawnPath& path : shape.paths) {
            m_pieces += path.pieces.size() + 1;
            figure.paths.push_back(mapped(path, place.map));
        }
        if (!figure.paths.empty() || !figure.circles.empty()) {
            const bool isLocked = element.attribute("sodipodi:insensitive") == "true";
            m_drawing.items.push_back({name, place.folder, true, isLocked, element.line, std::move(figure)});
        }
        if (m_pieces > maxPieces) {
            m_error = Error{ExchangeCode("import-too-many"), {std::to_string(maxPieces)}};
        }
    }

    const Watch& m_watch;
    std::map<std::string, const XmlElement*, std::less<>> m_byId;
    StyleSheet m_sheet;
    Drawing m_drawing;
    Report m_report;
    bool m_hasLayers = false;
    int m_count = 0;
    std::size_t m_pieces = 0;
    std::optional<Error> m_error;
};

} // namespace

Result<Drawing> readSvg(const XmlElement& root, const Watch& watch) {
    return SvgReader(watch).read(root);
}

} // namespace spacetow
