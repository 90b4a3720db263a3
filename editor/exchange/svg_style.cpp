#include "editor/exchange/svg_style.h"

#include "editor/exchange/svg_values.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

/// Whether something is painted with this; a colour, a gradient and a pattern all do.
bool isPaint(std::string_view value) {
    return value != "none" && value != "transparent";
}

bool isZero(std::string_view value) {
    return lengthFromText(value) == 0.0;
}

class StyleReader {
  public:
    explicit StyleReader(const SvgStyle& parent) : m_style(parent) {
        m_style.displayed = true;
        m_style.clipped = m_style.filtered = m_style.overflows = false;
    }

    void declare(std::string_view name, std::string_view value) {
        if (value == "inherit" || value.empty()) {
            return;
        }
        if (name == "fill") {
            m_style.fillPaint = isPaint(value);
        } else if (name == "stroke") {
            m_style.strokePaint = isPaint(value);
        } else if (name == "fill-rule") {
            m_style.evenOdd = value == "evenodd";
        } else if (name == "visibility") {
            m_style.visible = value == "visible";
        } else if (name == "font-size") {
            m_style.fontSize = lengthFromText(value, {m_style.fontSize, m_style.fontSize}).value_or(m_style.fontSize);
        } else if (name == "display") {
            m_style.displayed = value != "none";
        } else if (name == "clip-path" || name == "mask") {
            m_style.clipped = value != "none";
        } else if (name == "filter") {
            m_style.filtered = value != "none";
        } else if (name == "fill-opacity") {
            m_style.fillOpaque = !isZero(value);
        } else if (name == "stroke-opacity") {
            m_style.strokeOpaque = !isZero(value);
        } else if (name == "stroke-width") {
            m_style.strokeWide = !isZero(value);
            m_style.strokeWidth =
                lengthFromText(value, {m_style.fontSize, m_style.fontSize}).value_or(m_style.strokeWidth);
        } else if (name == "overflow") {
            m_style.overflows = value == "visible" || value == "auto";
        }
    }
    /// "fill:none; stroke:#000 !important"
    void declareAll(std::string_view declarations) {
        while (!declarations.empty()) {
            const std::size_t end = std::min(declarations.find(';'), declarations.size());
            const std::string_view one = declarations.substr(0, end);
            const std::size_t colon = one.find(':');
            if (colon != std::string_view::npos) {
                const std::string_view value = one.substr(colon + 1);
                declare(trimmed(one.substr(0, colon)), trimmed(value.substr(0, value.find('!'))));
            }
            declarations.remove_prefix(std::min(end + 1, declarations.size()));
        }
    }

    const SvgStyle& style() const { return m_style; }

  private:
    SvgStyle m_style;
};

std::string withoutComments(std::string_view css) {
    std::string out;
    for (;;) {
        const std::size_t begin = css.find("/*");
        out += css.substr(0, begin);
        const std::size_t end = begin == std::string_view::npos ? begin : css.find("*/", begin + 2);
        if (end == std::string_view::npos) {
            return out;
        }
        css.remove_prefix(end + 2);
    }
}

bool hasClass(std::string_view list, std::string_view wanted) {
    while (!list.empty()) {
        list = trimmed(list);
        const std::size_t end = std::min(list.find_first_of(" \t\n\r\f"), list.size());
        if (list.substr(0, end) == wanted) {
            return true;
        }
        list.remove_prefix(end);
    }
    return false;
}

} // namespace

bool StyleSheet::add(std::string_view css) {
    const std::string plain = withoutComments(css);
    std::string_view rest = plain;
    bool understood = true;
    for (;;) {
        const std::size_t open = rest.find('{');
        const std::size_t close = open == std::string_view::npos ? open : rest.find('}', open);
        if (close == std::string_view::npos) {
            break;
        }
        std::string_view selectors = rest.substr(0, open);
        const std::string_view declarations = rest.substr(open + 1, close - open - 1);
        while (!trimmed(selectors).empty()) {
            const std::size_t comma = std::min(selectors.find(','), selectors.size());
            understood = addSelector(trimmed(selectors.substr(0, comma)), declarations) && understood;
            selectors.remove_prefix(std::min(comma + 1, selectors.size()));
        }
        rest.remove_prefix(close + 1);
    }
    std::ranges::stable_sort(m_rules, {}, &Rule::weight);
    return understood;
}

bool StyleSheet::addSelector(std::string_view selector, std::string_view declarations) {
    constexpr std::size_t mostRules = 2000; // each element is compared with all of them
    if (m_rules.size() >= mostRules) {
        return false;
    }
    const std::size_t mark = std::min(selector.find_first_of(".#"), selector.size());
    const std::string_view name = selector.substr(0, mark);
    const std::string_view rest = selector.substr(std::min(mark + 1, selector.size()));
    constexpr std::string_view odd = " \t\n\r\f>+~:[]()@.#*";
    if ((name.find_first_of(odd) != std::string_view::npos && name != "*") ||
        rest.find_first_of(odd) != std::string_view::npos) {
        return false;
    }
    Rule rule;
    rule.element = name == "*" ? std::string_view() : name;
    if (mark < selector.size()) {
        (selector[mark] == '.' ? rule.className : rule.id) = rest;
    }
    rule.declarations = declarations;
    rule.weight = (rule.id.empty() ? 0 : 100) + (rule.className.empty() ? 0 : 10) + (rule.element.empty() ? 0 : 1);
    m_rules.push_back(std::move(rule));
    return true;
}

std::vector<std::string_view> StyleSheet::declarationsFor(const XmlElement& element) const {
    std::vector<std::string_view> found;
    for (const Rule& rule : m_rules) {
        if ((rule.element.empty() || rule.element == element.name) &&
            (rule.className.empty() || hasClass(element.attribute("class"), rule.className)) &&
            (rule.id.empty() || rule.id == element.attribute("id"))) {
            found.push_back(rule.declarations);
        }
    }
    return found;
}

SvgStyle styleOf(const XmlElement& element, const StyleSheet& sheet, const SvgStyle& parent) {
    StyleReader reader(parent);
    for (const auto& [name, value] : element.attributes) {
        reader.declare(name, trimmed(value));
    }
    for (const std::string_view declarations : sheet.declarationsFor(element)) {
        reader.declareAll(declarations);
    }
    reader.declareAll(element.attribute("style"));
    return reader.style();
}

} // namespace spacetow
