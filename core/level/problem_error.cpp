#include "core/level/problem_error.h"

namespace spacetow {

Error errorOf(Code code, const Problem& problem) {
    Error error{code, {std::to_string(problem.line), std::string(problem.code.text())}};
    error.arguments.insert(error.arguments.end(), problem.arguments.begin(), problem.arguments.end());
    return error;
}

int lineDeeperThan(JsonView value, int most) {
    if (most < 0) {
        return value.line();
    }
    if (!value.isArray() && !value.isObject()) {
        return 0;
    }
    for (const JsonView inner : value) {
        if (const int line = lineDeeperThan(inner, most - 1); line > 0) {
            return line;
        }
    }
    return 0;
}

} // namespace spacetow
