#pragma once
// XML as a tree of elements with their attributes and text. Names have their prefixes, but for elements of "svg:" and
// attributes of "xlink:". Entities of the file's own are never expanded: a file that declares any is refused. What is
// nested too deep or has too many elements is refused as well.

#include "core/base/result.h"
#include "editor/exchange/watch.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spacetow {

struct XmlElement {
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string text; // directly inside
    std::vector<XmlElement> children;
    int line = 0;

    /// Empty when there is none.
    const std::string& attribute(std::string_view wanted) const;
    bool has(std::string_view wanted) const;
};

/// Codes: "import-not-xml" (line, column, reason), "import-entities" (line), "import-too-deep" (number allowed),
/// "import-too-many" (number allowed), "import-stopped".
Result<XmlElement> parseXml(std::string_view bytes, const Watch& watch);

} // namespace spacetow
