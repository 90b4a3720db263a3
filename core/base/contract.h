#pragma once
// Contracts: what a caller must guarantee. Checked in every build; a broken one is a bug of ours, so the
// program stops at once and says where. Bad input from users or files is never a contract, see result.h.

namespace spacetow {

/// Prints "FILE:LINE: contract broken: TEXT" to standard error and aborts.
[[noreturn]] void contractBroken(const char* text, const char* file, int line);

} // namespace spacetow

#define EXPECTS(condition)                                                                                             \
    do {                                                                                                               \
        if (!(condition)) [[unlikely]]                                                                                 \
            ::spacetow::contractBroken(#condition, __FILE__, __LINE__);                                                \
    } while (false)
