#include "core/level/level_title.h"

#include <nlohmann/json.hpp>

namespace spacetow {

namespace {

struct TitleFound {
    std::string title;
};

} // namespace

std::optional<std::string> titleIn(std::string_view beginning) {
    using Event = nlohmann::json::parse_event_t;
    bool isName = false;
    const auto look = [&isName](int depth, Event event, nlohmann::json& parsed) {
        if (depth == 1 && event == Event::key) {
            isName = parsed == "name";
        } else if (depth == 1 && event == Event::value && isName && parsed.is_string()) {
            throw TitleFound{parsed.get<std::string>()}; // the rest is not looked at
        }
        return true;
    };
    try {
        [[maybe_unused]] const nlohmann::json whole = nlohmann::json::parse(beginning.begin(), beginning.end(), look);
    } catch (const TitleFound& found) {
        return found.title.empty() ? std::nullopt : std::optional(found.title);
    } catch (const nlohmann::json::exception&) { // it has been cut off, or is something else
    }
    return {};
}

} // namespace spacetow
