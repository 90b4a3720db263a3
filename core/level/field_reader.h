#pragma once
// Reads the fields of one JSON object into a struct: the visitor of core/level/fields.h that json_read uses.

#include "core/base/result.h"
#include "core/level/fields.h"
#include "core/level/json_tree.h"
#include "core/level/key_text.h"
#include "core/level/problem.h"
#include "core/level/unknown_fields.h"

#include <span>
#include <string>
#include <vector>

namespace spacetow {

/// Where in the document the reading is: a chain on the stack, spelled only when there is something to report.
struct Place {
    const Place* parent = nullptr;
    std::string_view name; // of a member, or
    int index = -1;        // position in a list

    std::string pointer() const;
};

/// What all readers of a document share.
struct ReadState {
    TagTable tags;
    TagMask seenTags;                // by their index in the table of the file
    std::vector<Problem> problems;   // of errors, and of all else, no more than maxProblems
    std::size_t errors = 0;          // that there are, listed or not
    std::size_t others = 0;          // likewise
    bool adoptsTags = false;         // a tag that is not in the table is put there; else it is an error
    bool hasErrors = false;          // also counts the errors that are no longer listed
    Key object = 0;                  // whose fields are being read
    const Place* owner = nullptr;    // of the unknown fields: the place of the object, the level or the tag
    std::string ownerPointer;        // what stands for that place in `unknownFields`
    UnknownCollection unknownFields; // so far
};

class FieldReader {
  public:
    FieldReader(ReadState& state, JsonView object, const Place& place);

    void number(const Field& field, double& value, double byDefault);
    void integer(const Field& field, int& value, int byDefault);
    void optionalNumber(const Field& field, std::optional<double>& value);
    void depth(const Field& field, double& value, double byDefault);
    void flag(const Field& field, bool& value, bool byDefault);
    void text(const Field& field, std::string& value, const std::string& byDefault);
    void point(const Field& field, Vec2& value, const Vec2& byDefault);
    void points(const Field& field, std::vector<Vec2>& value);
    void tags(const Field& field, TagMask& value, TagMask byDefault);
    void touches(const Field& field, TagMask& value);
    void key(const Field& field, Key& value);
    void optionalKey(const Field& field, Key& value);
    void optionalColor(const Field& field, std::optional<std::uint32_t>& value);
    void shapes(const Field& field, std::vector<LevelShape>& value);
    template <class Enum, std::size_t n>
    void choice(const Field& field, Enum& value, Enum byDefault, const Spellings<n>& names) {
        int index = static_cast<int>(byDefault);
        chooseFrom(field, index, names);
        value = static_cast<Enum>(index);
    }

    /// The member of this name, remembered as a known one; none when it is missing, which is a problem if required.
    std::optional<JsonView> member(const char* name, bool required);
    /// A member that is a list; none when it is missing or, which is reported, something else.
    std::optional<JsonView> list(const char* name, bool required, const Place& place);
    /// Calls `visit(item, where)` for the objects of a list; what else is in it is reported.
    template <class Visit>
    void eachObjectIn(JsonView list, const Place& place, Visit visit) {
        int index = 0;
        for (const JsonView item : list) {
            const Place here{&place, {}, index++};
            if (item.isObject()) {
                visit(item, here);
            } else {
                reject("not-an-object", here, item);
            }
        }
    }
    /// Index of the text among the names, or −1 after reporting it.
    int spelling(JsonView value, std::string_view name, std::span<const std::string_view> names);
    /// To be called after all fields: what is left is unknown, kept and reported.
    void finish();

    void report(Severity severity, Error error, JsonView at, const Place& place);
    /// Reports that `value` of the field is not what `code` says.
    void reject(LevelCode code, const Place& place, JsonView value);

  private:
    void chooseFrom(const Field& field, int& index, std::span<const std::string_view> names);
    TagMask maskOf(JsonView list, const Place& place);
    /// Index of the tag, −1 for one that is not known.
    int tagOf(const std::string& text);
    bool readPoint(JsonView value, Vec2& point) const;
    void readKey(const Field& field, JsonView json, Key& value);

    ReadState& m_state;
    JsonView m_object;
    const Place& m_place;
    std::vector<std::string_view> m_known;
    JsonView::Iterator m_next; // members mostly come in the order in which they are asked for
};

} // namespace spacetow
