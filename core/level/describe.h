#pragma once
// The documents of the level format, made from core/level/fields.h: the JSON schema for programs, and for people a
// table of fields for each part of a level. resources/level.schema.json and levels/README.md hold what is made here.

#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

/// What has a table: "level", "rules", "rope", "tag", "guide", "object" (the fields of every object), each type of
/// object and each type of shape.
std::vector<std::string_view> describedParts();
/// Markdown: | field | meaning | range | default |, a line each, newline at the end. Empty for an unknown part.
std::string fieldTable(std::string_view name);
/// JSON Schema, draft 2020-12, newline at the end.
std::string levelSchemaText();

} // namespace spacetow
