#pragma once
// What stands in a file, told by a hash of its bytes: whether somebody else has changed it, and not only touched it.

#include "core/base/whole_file.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace spacetow {

struct FileState {
    FileStamp stamp;
    std::uint64_t hash = 0; // of the bytes; 0 where they cannot be read

    bool exists() const { return stamp.exists; }
    bool sameContent(const FileState& other) const {
        return exists() == other.exists() && stamp.size == other.stamp.size && hash == other.hash;
    }
};

/// Reads the file, unless its stamp, when it is some seconds old, says what is known of it already. Links are followed.
FileState fileState(const std::filesystem::path& path, const FileState& known = {});
/// The `hash` of a file with these bytes.
std::uint64_t contentHash(std::string_view bytes);

} // namespace spacetow
