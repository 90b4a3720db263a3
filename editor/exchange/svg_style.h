#pragma once
// How an element of SVG is painted, as far as it matters for its shape: attributes, "style" and simple style sheets.

#include "editor/exchange/xml_tree.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace spacetow {

/// The rules of a <style> element whose selectors are made of names, classes and ids, within others or right below.
class StyleSheet {
  public:
    /// What an element stands in; of all, before anything is asked.
    void place(const XmlElement& element, const XmlElement& parent) { m_parents[&element] = &parent; }
    /// False when it has selectors that are not understood; those are passed over.
    bool add(std::string_view css);
    /// What it declares for an element, weakest first: "name: value; …".
    std::vector<std::string_view> declarationsFor(const XmlElement& element) const;

  private:
    /// "g#walls.thick"
    struct Compound {
        std::string element, id; // empty: any
        std::vector<std::string> classes;
        bool isRightBelow = false; // the one before it; else anywhere within
    };
    struct Rule {
        std::vector<Compound> compounds; // the last one is the element's own
        std::string declarations;
        int weight = 0;
    };
    static bool addCompound(std::string_view text, bool isRightBelow, Rule& rule);
    bool addSelector(std::string_view selector, std::string_view declarations);
    /// Exhausted: nor does it for what is further out.
    enum class Match { Yes, No, Exhausted };
    Match match(const Rule& rule, std::size_t compound, const XmlElement& element) const;
    std::vector<Rule> m_rules; // by weight, then in their order
    std::unordered_map<const XmlElement*, const XmlElement*> m_parents;
};

struct SvgStyle {
    // Inherited:
    bool fillPaint = true, strokePaint = false;
    bool fillOpaque = true, strokeOpaque = true, strokeWide = true; // else what is painted cannot be seen
    bool evenOdd = false;
    bool visible = true;
    double fontSize = 16;   // px
    double strokeWidth = 1; // units of the place
    // Of the element alone:
    bool displayed = true;
    bool clipped = false; // by a clip path or a mask
    bool filtered = false;
    bool overflows = false; // what lies beyond its window is seen

    bool isFilled() const { return fillPaint && fillOpaque; }
    bool isStroked() const { return strokePaint && strokeOpaque && strokeWide; }
};

/// The style of an element inside one with the style `parent`.
SvgStyle styleOf(const XmlElement& element, const StyleSheet& sheet, const SvgStyle& parent);

} // namespace spacetow
