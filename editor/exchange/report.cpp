#include "editor/exchange/report.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr std::size_t fewPlaces = 5;

template <class Values>
void appendFew(std::string& text, const Values& values, bool areMore) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += i == 0 ? "" : ", ";
        if constexpr (std::is_same_v<Values, std::vector<int>>) {
            text += std::to_string(values[i]);
        } else {
            text += values[i];
        }
    }
    text += areMore ? " …" : "";
}

} // namespace

void Report::refuse(ExchangeCode code, int line, const std::string& name) {
    auto kind = std::ranges::find(m_kinds, code, &Kind::code);
    if (kind == m_kinds.end()) {
        kind = m_kinds.insert(kind, Kind{code});
    }
    ++kind->count;
    if (line > 0 && kind->lines.size() <= fewPlaces && (kind->lines.empty() || kind->lines.back() != line)) {
        kind->lines.push_back(line);
    }
    if (!name.empty() && kind->names.size() <= fewPlaces && std::ranges::find(kind->names, name) == kind->names.end()) {
        constexpr std::size_t longest = 60;
        kind->names.push_back(name.size() <= longest ? name : std::string());
    }
}

std::vector<Error> Report::notes() const {
    std::vector<Error> notes;
    for (const Kind& kind : m_kinds) {
        std::vector<int> lines(kind.lines.begin(), kind.lines.begin() + static_cast<std::ptrdiff_t>(
                                                                            std::min(kind.lines.size(), fewPlaces)));
        std::vector<std::string> names(kind.names.begin(), kind.names.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                                    kind.names.size(), fewPlaces)));
        std::erase(names, std::string());
        std::string lineText;
        std::string nameText;
        appendFew(lineText, lines, kind.lines.size() > fewPlaces || static_cast<int>(kind.lines.size()) < kind.count);
        appendFew(nameText, names, kind.names.size() > fewPlaces);
        notes.push_back(Error{kind.code, {std::to_string(kind.count), lineText, nameText}});
    }
    return notes;
}

} // namespace spacetow
