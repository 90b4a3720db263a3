#pragma once
// How whole_file replaces what a file holds.

#include "core/base/disk_calls.h"
#include "core/base/whole_file.h"

namespace spacetow::disk {

struct WriteFailure {
    enum class Step : unsigned char {
        None,
        Folder,  // opening the folder
        Create,  // making a file in it
        File,    // opening the file itself
        Write,   // writing; the old file is whole
        Changed, // it is not the file that was to be replaced
        Damaged, // written in place in part, and the old content could not be put back
    };

    Step step = Step::None;
    int code = 0;
    std::string words; // instead of those of the code
    std::string copy;  // name of a file beside that holds all of the text, where the file is damaged
};

FileStamp stampOf(const struct stat& info);

/// Replaces the content of the file, which is no link. Files that a writer who was killed has left beside it are
/// removed. Gives what the file is then, by the hand of this writer.
FileStamp replaced(const std::filesystem::path& path, std::string_view text, const std::optional<FileStamp>& known,
                   WriteFailure& failure);

/// What the names of the files start with that are made beside this one.
std::string namesBeside(const std::filesystem::path& path);

} // namespace spacetow::disk
