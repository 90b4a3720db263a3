#pragma once
// Where the program keeps what belongs to the user's work but to no level: journal and backups.

#include <filesystem>

namespace spacetow {

/// In $XDG_STATE_HOME, which is ~/.local/state unless told. Need not exist.
std::filesystem::path stateFolder();

/// For each open document, what it holds; see editor/editing/journal.h.
inline std::filesystem::path journalFolder() {
    return stateFolder() / "recovery";
}
/// Former versions of files; see editor/editing/backups.h.
inline std::filesystem::path backupFolder() {
    return stateFolder() / "backups";
}

} // namespace spacetow
