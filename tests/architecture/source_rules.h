#pragma once
// The rules that ARCHITECTURE.md sets for sources, as functions over text, so that they can be tried on made-up files.

#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace spacetow::test {

/// Row of each folder in the layer table; a smaller number is a higher row.
using Layers = std::map<std::string, int>;

struct Source {
    std::string path; // from the root
    std::string text;
};

inline std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// A row reads "editor/panels · editor/play      what they are for": folders, two spaces, words.
inline std::vector<std::string> foldersInRow(std::string line) {
    std::vector<std::string> folders;
    const auto start = line.find_first_not_of(' ');
    if (start == std::string::npos) {
        return folders;
    }
    line = line.substr(start);
    line = line.substr(0, line.find("  "));
    const auto isFolder = [](const std::string& word) {
        return word == "app" || word.starts_with("core/") || word.starts_with("editor/");
    };
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        if (isFolder(word)) {
            folders.push_back(word);
        }
    }
    return folders;
}

inline Layers layersIn(const std::string& document) {
    Layers layers;
    bool inChapter = false;
    bool inTable = false;
    int row = 0;
    for (const std::string& line : linesOf(document)) {
        if (line.starts_with("## ")) {
            inChapter = line == "## Layers";
        } else if (inChapter && line.starts_with("```")) {
            inTable = !inTable;
        } else if (inTable) {
            const std::vector<std::string> folders = foldersInRow(line);
            row += folders.empty() ? 0 : 1;
            for (const std::string& folder : folders) {
                layers[folder] = row;
            }
        }
    }
    return layers;
}

inline std::string folderOf(const std::string& path) {
    return std::filesystem::path(path).parent_path().generic_string();
}

/// What stands between the quotes or brackets of an include, with its opening character in front.
inline std::optional<std::string> includedBy(const std::string& line) {
    const auto hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') {
        return {};
    }
    const auto word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) {
        return {};
    }
    const auto open = line.find_first_of("\"<", word);
    const auto close = open == std::string::npos ? open : line.find_first_of("\">", open + 1);
    if (close == std::string::npos) {
        return {};
    }
    return line.substr(open, close - open);
}

inline bool isHeader(const std::string& path) {
    return path.ends_with(".h");
}

inline bool isGenerated(const std::string& name) {
    return name.ends_with(".moc") || name.starts_with("moc_");
}

inline std::optional<std::string> wrongWithOwnInclude(const std::string& from, const std::string& to,
                                                      const Layers& layers) {
    const auto mine = layers.find(folderOf(from));
    const auto theirs = layers.find(folderOf(to));
    if (mine == layers.end()) {
        return "lies in a folder that is in no row of the table";
    }
    if (theirs == layers.end()) {
        return "includes \"" + to + "\", which is no path from the root to a folder of the table";
    }
    if (mine->first == theirs->first || mine->second < theirs->second) {
        return {};
    }
    return "includes \"" + to + "\", which lies " +
           (mine->second == theirs->second ? "beside it in the same row" : "in a row above it");
}

inline std::optional<std::string> wrongWithOtherInclude(const std::string& from, const std::string& name) {
    const bool noQt = from.starts_with("core/") || from.starts_with("editor/editing/");
    if (noQt && name.size() > 1 && name[0] == 'Q' && (std::isupper(name[1]) || name.starts_with("Qt"))) {
        return "includes <" + name + ">; neither core/ nor editor/editing knows Qt";
    }
    if (name.starts_with("Eigen/") && from != "core/math/vec.h") {
        return "includes <" + name + ">; only core/math/vec.h includes Eigen";
    }
    if (isHeader(from) && (name == "nlohmann/json.hpp" || name == "QtWidgets")) {
        return "includes <" + name + "> in a header, which costs every file that includes it seconds";
    }
    return {};
}

/// Sentences about what this file includes and must not.
inline std::vector<std::string> includeProblems(const Source& source, const Layers& layers) {
    std::vector<std::string> problems;
    int number = 0;
    for (const std::string& line : linesOf(source.text)) {
        ++number;
        const std::optional<std::string> included = includedBy(line);
        if (!included) {
            continue;
        }
        const std::string name = included->substr(1);
        std::optional<std::string> wrong = wrongWithOtherInclude(source.path, name);
        const bool own = included->front() == '"' && !isGenerated(name) && !name.starts_with("nlohmann/");
        if (!wrong && own) {
            wrong = wrongWithOwnInclude(source.path, name, layers);
        }
        if (wrong) {
            problems.push_back(source.path + ":" + std::to_string(number) + ": " + *wrong);
        }
    }
    return problems;
}

/// Sentences about functions of the engine's stages that take all of a world: a stage takes what it touches, or a view
/// of that, which is made from the whole.
inline std::vector<std::string> wholeWorldProblems(const Source& source) {
    std::vector<std::string> problems;
    for (const char* room : {"sleep", "solver", "contacts", "broad_phase", "state", "lanes", "def"}) {
        if (!source.path.starts_with(std::string("core/physics/") + room + '/')) {
            continue;
        }
        int number = 0;
        for (const std::string& line : linesOf(source.text)) {
            ++number;
            if (line.find("WorldData&") != std::string::npos &&
                line.find("Stage(WorldData& data)") == std::string::npos) {
                problems.push_back(source.path + ":" + std::to_string(number) +
                                   ": a stage takes what it touches, not all of WorldData");
            }
        }
    }
    return problems;
}

constexpr std::size_t mostLines = 400;

/// Sentences about the form of this file.
inline std::vector<std::string> formProblems(const Source& source) {
    // In two pieces, so that this file does not contain them.
    const std::array<std::string, 4> unfinished{std::string("TO") + "DO", std::string("FIX") + "ME",
                                                std::string("XX") + "X", std::string("HA") + "CK"};
    std::vector<std::string> problems;
    const std::vector<std::string> lines = linesOf(source.text);
    if (lines.size() > mostLines) {
        problems.push_back(source.path + ": has " + std::to_string(lines.size()) + " lines, at most " +
                           std::to_string(mostLines) + " are allowed");
    }
    for (const std::string& word : unfinished) {
        if (source.text.find(word) != std::string::npos) {
            problems.push_back(source.path + ": contains the word " + word);
        }
    }
    if (isHeader(source.path) && !(lines.size() > 1 && lines[0] == "#pragma once" && lines[1].starts_with("// "))) {
        problems.push_back(source.path + ": does not open with what the header is for");
    }
    // What answers with a subrange does not compile with clang++ 14, which the fuzzers are built with.
    const bool isFuzzed = source.path.starts_with("core/") || source.path.starts_with("editor/editing/") ||
                          source.path.starts_with("editor/exchange/");
    for (const char* name : {"unique", "remove", "remove_if", "partition", "stable_partition", "equal_range", "rotate",
                             "search", "find_end", "subrange"}) {
        if (isFuzzed && source.text.find(std::string("std::ranges::") + name + '(') != std::string::npos) {
            problems.push_back(source.path + ": std::ranges::" + name +
                               " does not compile everywhere; use std::" + name);
        }
    }
    for (const char* word : {"util", "helper", "common", "manager"}) {
        if (std::filesystem::path(source.path).stem().string().find(word) != std::string::npos) {
            problems.push_back(source.path + ": no file is called " + word);
        }
    }
    return problems;
}

} // namespace spacetow::test
