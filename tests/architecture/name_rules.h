#pragma once
// Names in the unnamed namespaces of one folder: its files may be compiled as one, so they must not meet. Read line by
// line, which is enough for sources that clang-format has laid out.

#include "tests/architecture/source_rules.h"

#include <cctype>
#include <map>
#include <string>
#include <vector>

namespace spacetow::test {

/// What a line at the left margin of an unnamed namespace defines.
struct LocalName {
    std::string name;
    std::string parameters; // of a function, with the bracket in front; of anything else, nothing
};

inline bool isWordPart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

inline std::string lastWordOf(const std::string& text) {
    std::size_t end = text.size();
    while (end > 0 && text[end - 1] == ' ') {
        --end;
    }
    std::size_t start = end;
    while (start > 0 && isWordPart(text[start - 1])) {
        --start;
    }
    return text.substr(start, end - start);
}

/// Nothing for lines that define nothing, and for those that only declare a class.
inline std::optional<LocalName> definedBy(const std::string& line) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) {
        return {};
    }
    for (const char* start : {"namespace ", "using namespace ", "template", "static_assert", "Q_", "QT_"}) {
        if (line.starts_with(start)) {
            return {};
        }
    }
    for (const char* start : {"struct ", "class ", "enum ", "enum class "}) {
        if (line.starts_with(start) && !line.ends_with(");") && line.find('{') != std::string::npos) {
            const std::string rest = line.substr(std::string(start).size());
            const auto end = rest.find_first_of(" :{");
            if (rest.starts_with("class ") || end == 0) {
                continue;
            }
            return LocalName{rest.substr(0, end), {}};
        }
    }
    const auto end = line.find_first_of("(=[{;");
    if (end == std::string::npos || line.find(' ') > end) {
        return {};
    }
    const std::string name = lastWordOf(line.substr(0, end));
    if (name.empty() || line.starts_with("struct ") || line.starts_with("class ")) {
        return {};
    }
    return LocalName{name, line[end] == '(' ? line.substr(end, line.find('{') - end) : std::string()};
}

inline std::vector<LocalName> localNamesIn(const std::string& text) {
    std::vector<LocalName> names;
    bool inside = false;
    for (const std::string& line : linesOf(text)) {
        if (line == "namespace {" || line == "} // namespace") {
            inside = line == "namespace {";
        } else if (inside) {
            if (const std::optional<LocalName> defined = definedBy(line)) {
                names.push_back(*defined);
            }
        }
    }
    return names;
}

/// Sentences about names that two files of a folder have in their unnamed namespaces, except for overloads.
inline std::vector<std::string> nameProblems(const std::vector<Source>& sources) {
    struct Place {
        std::string path;
        std::string parameters;
    };
    std::map<std::string, std::vector<Place>> placesOf; // by folder and name
    std::vector<std::string> problems;
    for (const Source& source : sources) {
        if (isHeader(source.path)) {
            continue;
        }
        for (const LocalName& local : localNamesIn(source.text)) {
            std::vector<Place>& places = placesOf[folderOf(source.path) + ' ' + local.name];
            for (const Place& place : places) {
                const bool overloads =
                    !place.parameters.empty() && !local.parameters.empty() && place.parameters != local.parameters;
                if (place.path != source.path && !overloads) {
                    problems.push_back(source.path + ": the name " + local.name +
                                       " in its unnamed namespace is also in " + place.path +
                                       ", with which it may be compiled as one");
                }
            }
            places.push_back({source.path, local.parameters});
        }
    }
    return problems;
}

} // namespace spacetow::test
