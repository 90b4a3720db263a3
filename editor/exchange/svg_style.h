#pragma once
// How an element of SVG is painted, as far as it matters for its shape: attributes, "style" and simple style sheets.

#include "editor/exchange/xml_tree.h"

#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

/// The rules of a <style> element whose selectors are a name, a class, an id, or a name with one of these.
class StyleSheet {
  public:
    /// False when it has selectors that are not understood; those are passed over.
    bool add(std::string_view css);
    /// What it declares for an element, weakest first: "name: value; …".
    std::vector<std::string_view> declarationsFor(const XmlElement& element) const;

  private:
    struct Rule {
        std::string element, className, id; // empty: any
        std::string declarations;
        int weight = 0;
    };
    bool addSelector(std::string_view selector, std::string_view declarations);
    std::vector<Rule> m_rules; // by weight, then in their order
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
