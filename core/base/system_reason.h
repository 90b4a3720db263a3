#pragma once
// Why the system could not do what it was asked for.

#include <string>

namespace spacetow {

/// What the system says of an `errno`, in English whatever the locale: "No such file or directory". Sentences for
/// people are made of it in editor/window/messages.
std::string systemReason(int code);

} // namespace spacetow
