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

bool StyleSheet::addCompound(std::string_view text, bool isRightBelow, Rule& rule) {
    constexpr std::string_view odd = "~:[]()@*+";
    Compound compound;
    compound.isRightBelow = isRightBelow;
    const std::size_t mark = std::min(text.find_first_of(".#"), text.size());
    compound.element = text.substr(0, mark) == "*" ? std::string_view() : text.substr(0, mark);
    text.remove_prefix(mark);
    bool understood = compound.element.find_first_of(odd) == std::string::npos;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(".#", 1), text.size());
        const std::string_view name = text.substr(1, end - 1);
        understood = understood && !name.empty() && name.find_first_of(odd) == std::string_view::npos;
        if (text[0] == '.') {
            compound.classes.emplace_back(name);
        } else {
            compound.id = name;
        }
        text.remove_prefix(end);
    }
    rule.weight += (compound.id.empty() ? 0 : 10'000) + 100 * static_cast<int>(compound.classes.size()) +
                   (compound.element.empty() ? 0 : 1);
    rule.compounds.push_back(std::move(compound));
    return understood;
}

bool StyleSheet::addSelector(std::string_view selector, std::string_view declarations) {
    constexpr std::size_t mostRules = 2000; // each element is compared with all of them
    constexpr std::size_t mostCompounds = 8;
    constexpr std::string_view between = " \t\n\r\f>";
    Rule rule;
    bool isRightBelow = false;
    while (!selector.empty()) {
        const std::size_t begin = std::min(selector.find_first_not_of(between), selector.size());
        isRightBelow = selector.substr(0, begin).find('>') != std::string_view::npos;
        const std::size_t end = std::min(selector.find_first_of(between, begin), selector.size());
        const std::string_view compound = selector.substr(begin, end - begin);
        const bool isFirst = rule.compounds.empty();
        if (compound.empty() || (isFirst && isRightBelow) || rule.compounds.size() == mostCompounds ||
            !addCompound(compound, isRightBelow, rule)) {
            return false;
        }
        selector.remove_prefix(end);
    }
    if (rule.compounds.empty() || m_rules.size() >= mostRules) {
        return false;
    }
    rule.declarations = declarations;
    m_rules.push_back(std::move(rule));
    return true;
}

StyleSheet::Match StyleSheet::match(const Rule& rule, std::size_t at, const XmlElement& element) const {
    const Compound& compound = rule.compounds[at];
    const bool isThis = (compound.element.empty() || compound.element == element.name) &&
                        (compound.id.empty() || compound.id == element.attribute("id")) &&
                        std::ranges::all_of(compound.classes, [&](const std::string& name) {
                            return hasClass(element.attribute("class"), name);
                        });
    if (!isThis || at == 0) {
        return isThis ? Match::Yes : Match::No;
    }
    for (auto parent = m_parents.find(&element); parent != m_parents.end(); parent = m_parents.find(parent->second)) {
        const Match around = match(rule, at - 1, *parent->second);
        if (around != Match::No) {
            return around; // the nearest leaves the most for the rest
        }
        if (compound.isRightBelow) {
            return Match::No;
        }
    }
    return Match::Exhausted;
}

std::vector<std::string_view> StyleSheet::declarationsFor(const XmlElement& element) const {
    std::vector<std::string_view> found;
    for (const Rule& rule : m_rules) {
        if (match(rule, rule.compounds.size() - 1, element) == Match::Yes) {
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
