#include "tests/support/fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
    spacetow::test::tryReplay({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
