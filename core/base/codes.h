#pragma once
// What may go wrong with files and with numbers that are typed.

#include "core/base/code.h"

namespace spacetow {

inline constexpr std::string_view fileCodes[] = {
    "cannot-read",
    "cannot-write",
    "disk-full",
    "quota-full",
    "disk-read-only",
    "folder-missing",
    "folder-protected",
    "file-protected",
    "changed-on-disk",
    "file-damaged",
    "file-damaged-but-beside",
    "file-too-large",
};

inline constexpr std::string_view expressionCodes[] = {
    "expression-empty",      "expression-unfinished",   "expression-unexpected", "expression-unknown",
    "expression-unclosed",   "expression-arguments",    "expression-too-deep",   "expression-divided-by-zero",
    "expression-not-finite", "expression-units-differ", "expression-wrong-unit", "expression-needs-no-unit",
};

using BaseCode = CodeOf<fileCodes, expressionCodes>;

} // namespace spacetow
