// Recorded flights are spelled.

#include "core/base/contract.h"
#include "core/game/replay_words.h"
#include "core/level/file.h"
#include "core/level/key_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace spacetow {
namespace {

using ReplayValue = nlohmann::json;

std::string hex(std::uint64_t number) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

/// What is not UTF-8 is spelled with replacement characters rather than refused.
std::string spelledText(const std::string& text) {
    return ReplayValue(text).dump(-1, ' ', false, ReplayValue::error_handler_t::replace);
}

std::string listText(const std::vector<Key>& keys) {
    std::string text = "[";
    for (const Key key : keys) {
        text += (text.size() > 1 ? ",\"" : "\"") + keyText(key) + '"';
    }
    return text + ']';
}

std::string holdText(const Replay::Hold& hold) {
    std::string text = '[' + std::to_string(hold.update);
    if (hold.grab) {
        text += ",\"" + keyText(hold.grab->object) + '"';
        for (const double number :
             {hold.grab->anchor.x(), hold.grab->anchor.y(), hold.grab->target.x(), hold.grab->target.y()}) {
            text += ',' + ReplayValue(number).dump();
        }
    }
    return text + ']';
}

std::string editText(const Replay::Edit& edit) {
    return '[' + std::to_string(edit.update) + ',' + spelledText(levelText(edit.delta.changed)) + ',' +
           listText(edit.delta.removed) + ',' + listText(edit.delta.order) + ']';
}

std::string endText(const FlightResult& ended) {
    const auto* const outcome =
        std::ranges::find(replay_words::outcomes, ended.end, &std::pair<FlightEnd, std::string_view>::first);
    EXPECTS(outcome != replay_words::outcomes.end());
    std::string text =
        "{\"outcome\": \"" + std::string(outcome->second) + "\", \"time\": " + ReplayValue(ended.time).dump() +
        ", \"fuel\": " + ReplayValue(ended.fuel).dump() + ", \"update\": " + std::to_string(ended.update) +
        ", \"seconds\": " + ReplayValue(ended.seconds).dump();
    if (ended.place && isFinite(*ended.place)) {
        text +=
            ", \"place\": [" + ReplayValue(ended.place->x()).dump() + ", " + ReplayValue(ended.place->y()).dump() + ']';
    }
    return text + '}';
}

/// The oldest that will do.
int versionFor(const Replay& replay) {
    return replay.kind != RunKind::Game ? 4 : replay.ended ? 3 : replay.holds.empty() && replay.edits.empty() ? 1 : 2;
}

/// One entry a line; nothing for none.
template <class Entry>
std::string entriesText(const char* name, const std::vector<Entry>& entries, std::string (*spell)(const Entry&)) {
    std::string text;
    for (const Entry& entry : entries) {
        text += (text.empty() ? "\n" : ",\n") + spell(entry);
    }
    return entries.empty() ? text : std::string(",\n\"") + name + "\": [" + text + "\n]";
}

} // namespace

std::string replayText(const Replay& replay) {
    const std::string name = spelledText(replay.level);
    std::string text = "{\n\"replay\": " + std::to_string(versionFor(replay)) + ",\n";
    text += replay.kind == RunKind::Simulation ? "\"kind\": \"simulation\",\n" : "";
    text += "\"level\": " + name + ",\n";
    if (replay.levelHash) {
        text += "\"levelHash\": \"" + hex(*replay.levelHash) + "\",\n";
    }
    text += "\"seed\": " + std::to_string(replay.seed) + ",\n\"updates\": [";
    std::size_t lineStart = text.size();
    for (std::size_t i = 0; i < replay.runs.size(); ++i) {
        const Replay::Run& run = replay.runs[i];
        if (i > 0) {
            text += ',';
        }
        if (i == 0 || text.size() - lineStart > 110) {
            lineStart = text.size();
            text += '\n';
        }
        text += '[' + std::to_string(toBits(run.controls)) + ',' + std::to_string(run.count) + ']';
    }
    text += replay.runs.empty() ? "]" : "\n]";
    text += entriesText("holds", replay.holds, holdText) + entriesText("edits", replay.edits, editText);
    return text + (replay.ended ? ",\n\"end\": " + endText(*replay.ended) : std::string()) + "\n}\n";
}

} // namespace spacetow
