// Which kind of file it is, and who reads it.
#include "core/level/file.h"
#include "core/level/problem_error.h"
#include "editor/exchange/codes.h"
#include "editor/exchange/import.h"
#include "editor/exchange/json_values.h"
#include "editor/exchange/rube_read.h"
#include "editor/exchange/svg_read.h"
#include "editor/exchange/tiled_read.h"

namespace spacetow {

namespace {

Result<Drawing> tiledFrom(const TiledMap& map, Report& report) {
    Drawing drawing = tiledDrawing(map, report);
    drawing.notes = report.notes();
    return drawing;
}

Result<Drawing> readXmlDrawing(std::string_view bytes, const Watch& watch) {
    const Result<XmlElement> root = parseXml(bytes, watch);
    if (!root) {
        return root.error();
    }
    const std::string& name = root.value().name;
    if (name == "svg") {
        return readSvg(root.value(), watch);
    }
    if (name == "map") {
        Report report;
        return tiledFrom(tiledMapFromXml(root.value(), report), report);
    }
    return name == "tileset" || name == "template" ? Error{ExchangeCode("import-tileset"), {}}
                                                   : Error{ExchangeCode("import-unknown"), {}};
}

Error jsonError(const Problem& problem) {
    const bool isLimit = problem.code.text().starts_with("too-many") || problem.code == "nested-too-deep";
    return isLimit ? Error{problem.code, problem.arguments} : errorOf(ExchangeCode("not-sound-json"), problem);
}

Result<Drawing> readJsonDrawing(std::string_view text) {
    const auto parsed = JsonTree::parsed(text);
    if (const auto* problem = std::get_if<Problem>(&parsed)) {
        return jsonError(*problem);
    }
    const JsonView root = std::get<JsonTree>(parsed).root();
    const std::string type = jsonText(root, "type");
    if (type == "map" || jsonMember(root, "tilewidth")) {
        Report report;
        return tiledFrom(tiledMapFromJson(root, report), report);
    }
    if (type == "tileset" || type == "template") {
        return Error{ExchangeCode("import-tileset"), {}};
    }
    if (jsonMember(root, "schema") && jsonMember(root, "objects")) {
        return Error{ExchangeCode("import-level"), {}};
    }
    if (jsonMember(root, "body")) {
        Report report;
        Drawing drawing = rubeDrawing(root, report);
        drawing.notes = report.notes();
        return drawing;
    }
    return Error{ExchangeCode("import-unknown"), {}};
}

} // namespace

Result<Drawing> readDrawing(std::string_view bytes, const Watch& watch) {
    if (bytes.size() > maxLevelBytes) {
        return Error{ExchangeCode("text-too-large"), {std::to_string(maxLevelBytes)}};
    }
    if (bytes.starts_with("\x1f\x8b")) {
        return Error{ExchangeCode("import-compressed"), {}};
    }
    std::string_view text = bytes;
    if (text.starts_with("\xef\xbb\xbf")) {
        text.remove_prefix(3);
    }
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return Error{ExchangeCode("empty-file"), {}};
    }
    const bool isWide = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"); // UTF-16, for XML alone
    if (isWide || text[first] == '<') {
        return readXmlDrawing(bytes, watch);
    }
    return text[first] == '{' ? readJsonDrawing(text) : Error{ExchangeCode("import-unknown"), {}};
}

} // namespace spacetow
