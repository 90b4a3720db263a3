#pragma once
// A session of editing and saving that follows from its seed: who knows the seed knows the level after each step. Used
// by the process that is killed in the middle of it, and by the one that looks at what is left.

#include "core/base/random.h"
#include "core/level/edits.h"
#include "editor/editing/document.h"

#include <filesystem>
#include <string>

namespace spacetow::test {

enum class Deed : std::uint8_t { Edit, Undo, Redo, Save };

class EditScript {
  public:
    explicit EditScript(std::uint64_t seed) : m_random(seed) {}

    /// What comes next. All but saving is done to the document at once.
    Deed next(Document& document) {
        const std::uint32_t choice = m_random.below(10);
        if (choice < 2) {
            return Deed::Save;
        }
        if (choice == 2 && document.canUndo()) {
            document.undo();
            return Deed::Undo;
        }
        if (choice == 3 && document.canRedo()) {
            document.redo();
            return Deed::Redo;
        }
        document.commit({"change-level", 1}, {std::make_shared<const Level>(edited(document.level())), {}});
        return Deed::Edit;
    }

  private:
    Level edited(Level level) {
        const std::uint32_t seed = m_random.next();
        const int count = level.objects.size();
        if (count > 0 && m_random.below(2) == 0) {
            const Key key = level.objects[static_cast<int>(m_random.below(static_cast<std::uint32_t>(count)))].key;
            return m_random.below(4) == 0 ? removed(std::move(level), std::vector<Key>{key})
                                          : moved(std::move(level), std::vector<Key>{key}, {m_random.unit(), 1});
        }
        Object object;
        object.key = freshKey(level, seed);
        object.data = BodyObject{.shapes = {Circle{{0, 0}, 1 + m_random.unit()}}, .position = {m_random.unit(), 0}};
        return added(std::move(level), std::move(object));
    }

    Random m_random;
};

/// The level that every second session finds on disk; the others begin with one that was never saved.
inline bool beginsWithFile(std::uint64_t seed) {
    return seed % 2 == 1;
}

inline std::filesystem::path scriptFile(const std::filesystem::path& folder) {
    return folder / "level.json";
}

} // namespace spacetow::test
