#include "core/level/file_state.h"

#include "core/base/hash.h"
#include "core/level/file.h"

#include <chrono>

namespace spacetow {

namespace {

/// Clocks of file systems tick in milliseconds: a younger file may have changed again without another time.
bool isSettled(const FileStamp& stamp) {
    using namespace std::chrono;
    const nanoseconds now = system_clock::now().time_since_epoch();
    return now - nanoseconds(stamp.modified) > seconds(2);
}

} // namespace

std::uint64_t contentHash(std::string_view bytes) {
    StateHash hash;
    std::uint64_t word = 0;
    std::size_t filled = 0;
    for (const char byte : bytes) {
        word = word << 8 | static_cast<unsigned char>(byte);
        if (++filled == sizeof word) {
            hash.add(word);
            filled = 0;
        }
    }
    hash.add(word);
    hash.add(std::uint64_t{bytes.size()});
    return hash.value();
}

FileState fileState(const std::filesystem::path& path, const FileState& known) {
    const FileStamp stamp = stampOf(path);
    if (stamp.exists && stamp == known.stamp && isSettled(stamp)) {
        return known;
    }
    const Result<ReadText> found = readFile(path, maxLevelBytes);
    if (found) {
        return {found.value().stamp, contentHash(found.value().text)};
    }
    std::error_code unknown;
    return std::filesystem::is_regular_file(path, unknown) ? FileState{stamp, 0} : FileState();
}

} // namespace spacetow
