#include "tests/support/capsule_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
    spacetow::test::tryCapsule({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
