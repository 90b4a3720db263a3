#pragma once
// Fields of a file that this version does not know, kept for the next save as they are spelled there: as the text of a
// JSON object whose names are JSON pointers within their owner ({"/glow": 1, "/shapes/0/glow": 2}), empty for none.

#include "core/level/json_text.h"
#include "core/level/json_tree.h"

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace spacetow {

struct UnknownField {
    std::string place; // JSON pointer, within the owner, to the object that it is a field of
    std::string name;  // as spelled, between the quotes
    std::string value; // as spelled
};

/// Those of one owner, while it is read.
class UnknownCollection {
  public:
    void add(const std::string& place, JsonView member);
    /// Whatever the order of the places was, so that equal ones are equal texts; leaves none. Within a place the order
    /// stays.
    std::string take();

  private:
    std::vector<std::pair<std::string, std::string>> m_members; // place, the member as spelled
};

std::vector<UnknownField> unknownFields(const std::string& text);
std::string unknownFieldsText(std::span<const UnknownField> fields);

/// Of an owner whose list ("/shapes") has lost entries, at these places, ascending: those after them have moved up.
std::string withoutEntries(const std::string& text, const std::string& list, std::span<const int> lost);

/// Of an owner in whose list two entries have changed places.
std::string withEntriesSwapped(const std::string& text, const std::string& list, int a, int b);

/// Puts the fields back where they were; `moved` tells where a place is now, empty for no more. What has a known field
/// of that name by now, or no place, is left out.
void insertUnknownFields(JsonText& out, const std::string& text,
                         const std::function<std::string(const std::string& place)>& moved = {});

} // namespace spacetow
