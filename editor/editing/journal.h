#pragma once
// The recovery journal: what each open document holds, in a file of its own in the user's state folder, so that it
// outlives the program. A place in the folder belongs to one document of one process for as long as its lock is held,
// and the system lets go of locks when a process dies, in whatever way.

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

struct JournalEntry {
    std::string path;                      // the document's file, absolute; empty when it was never saved
    std::string name;                      // what the document was called in its window
    std::optional<std::uint64_t> fileHash; // contentHash of the file when it was opened or last saved
    std::int64_t time = 0;                 // s since 1970, when this was written
    std::string text;                      // of the level, as a file of it would say

    bool operator==(const JournalEntry&) const = default;
};

std::string journalText(const JournalEntry& entry);
/// Nothing when the text is no journal, or not all of one.
std::optional<JournalEntry> parsedJournal(std::string_view text);

/// A place in the folder, by its lock. What it does with its files may be done in any thread, one at a time.
class JournalSlot {
  public:
    /// A new one; the folder is made when it is missing. Code: "cannot-write" (path, reason).
    static Result<JournalSlot> made(const std::filesystem::path& folder);
    /// That of a process which is no more; nothing when it lives, or when somebody else was quicker.
    static std::optional<JournalSlot> takenOver(const std::filesystem::path& folder, const std::string& id);

    JournalSlot(JournalSlot&& other) noexcept;
    JournalSlot& operator=(JournalSlot&& other) noexcept;
    JournalSlot(const JournalSlot&) = delete;
    JournalSlot& operator=(const JournalSlot&) = delete;
    /// What is written stays, for whoever starts next; without it nothing is left of the place.
    ~JournalSlot();

    const std::string& id() const { return m_id; }
    /// Replaces what was written, in one piece or not at all. Code: "cannot-write" (path, reason).
    std::optional<Error> write(const JournalEntry& entry) const;
    std::optional<JournalEntry> read() const;
    void erase() const;
    /// Erases in a way that `bringBack` can take back, for a week.
    void discard() const;
    void bringBack() const;
    /// Tells other processes which file the document is of.
    void setFile(const std::string& path) const;

  private:
    JournalSlot(std::filesystem::path folder, std::string id, int lock);
    std::filesystem::path file(const char* suffix) const;
    void release();

    std::filesystem::path m_folder;
    std::string m_id;
    int m_lock = -1; // descriptor
};

/// What a process has left behind that is no more.
struct Orphan {
    std::string id;
    JournalEntry entry;
};

/// Newest first. What their files hold already is no news and removed; so are remains of former runs.
std::vector<Orphan> orphans(const std::filesystem::path& folder);
/// Whether a document of this file is open under another place, in this or in another process.
bool isOpenElsewhere(const std::filesystem::path& folder, const std::string& path, const std::string& ownId);

} // namespace spacetow
