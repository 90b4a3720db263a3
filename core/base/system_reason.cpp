#include "core/base/system_reason.h"

#include <cstring>
#include <system_error>

namespace spacetow {

std::string systemReason(int code) {
#ifdef __GLIBC__ // whose strerror() translates
    if (const char* const text = strerrordesc_np(code)) {
        return text;
    }
#endif
    return std::generic_category().message(code);
}

} // namespace spacetow
