#include "core/level/migrate.h"

namespace spacetow {

namespace {

Problem problemOf(JsonView value, LevelCode code, std::vector<std::string> arguments, std::string pointer) {
    Problem problem;
    problem.code = code;
    problem.arguments = std::move(arguments);
    problem.pointer = std::move(pointer);
    problem.line = value.line();
    return problem;
}

} // namespace

std::optional<Problem> schemaProblem(const JsonTree& tree) {
    const JsonView root = tree.root();
    if (!root.isObject()) {
        return problemOf(root, "not-a-level", {root.spelled(40)}, "");
    }
    for (const JsonView member : root) {
        if (member.name() != "schema") {
            continue;
        }
        const double schema = member.isNumber() ? member.number() : 0;
        if (schema > newestSchema) {
            return problemOf(member, "newer-schema", {member.spelled(40), std::to_string(newestSchema)}, "/schema");
        }
        if (schema != oldestSchema && schema != newestSchema) {
            return problemOf(member, "bad-schema", {member.spelled(40), std::to_string(newestSchema)}, "/schema");
        }
        return {};
    }
    return problemOf(root, "missing-schema", {std::to_string(newestSchema)}, "");
}

} // namespace spacetow
