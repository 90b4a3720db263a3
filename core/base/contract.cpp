#include "core/base/contract.h"

#include <cstdio>
#include <cstdlib>

namespace spacetow {

void contractBroken(const char* text, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, text);
    std::abort();
}

} // namespace spacetow
