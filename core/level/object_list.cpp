#include "core/level/object_list.h"

#include "core/level/level.h"
#include "core/level/level_index.h"

#include <atomic>
#include <mutex>

namespace spacetow {

namespace {

/// So many objects are looked through one by one, and so many may have come or gone before a table is made anew.
constexpr int few = 64;

} // namespace

/// Where the object of each key is. Made when it is first asked, and never changed after that. Several lists share one:
/// those whose keys are the same, and those that have grown or shrunk a little since it was made.
class KeyTable {
  public:
    bool isMade() const { return m_made.load(std::memory_order_acquire); }
    /// The list must be one that had the same keys from the moment it came by this table.
    int place(const ObjectList& list, Key key) {
        std::call_once(m_once, [&] { make(list); });
        for (std::size_t slot = slotOf(key);; slot = (slot + 1) & m_mask) {
            if (m_places[slot] < 0 || m_keys[slot] == key) {
                return m_places[slot];
            }
        }
    }

  private:
    std::size_t slotOf(Key key) const { return (key * 0x9e3779b1u >> 7) & m_mask; }
    void make(const ObjectList& list) {
        std::size_t slots = 1;
        while (slots < static_cast<std::size_t>(list.size()) * 2) {
            slots *= 2;
        }
        m_mask = slots - 1;
        m_keys.resize(slots);
        m_places.resize(slots, -1);
        int place = 0;
        for (const Object& object : list) {
            std::size_t slot = slotOf(object.key);
            while (m_places[slot] >= 0 && m_keys[slot] != object.key) {
                slot = (slot + 1) & m_mask;
            }
            if (m_places[slot] < 0) {
                m_keys[slot] = object.key;
                m_places[slot] = place;
            }
            ++place;
        }
        m_made.store(true, std::memory_order_release);
    }

    std::once_flag m_once;
    std::atomic<bool> m_made = false;
    std::size_t m_mask = 0;
    std::vector<Key> m_keys;
    std::vector<int> m_places; // -1 where there is none
};

/// An index for lists that hold the same pieces.
struct ObjectList::Places {
    std::mutex mutex;
    std::shared_ptr<const LevelIndex> made;
    std::shared_ptr<const LevelIndex> base; // of a list that this one was made from; until there is one of this list
};

ObjectList::ObjectList() : m_keys(std::make_shared<KeyTable>()), m_places(std::make_shared<Places>()) {}

// What is left behind is an empty list.
ObjectList::ObjectList(ObjectList&& other) noexcept : ObjectList() {
    *this = std::move(other);
}

ObjectList& ObjectList::operator=(ObjectList&& other) noexcept {
    m_blocks = std::exchange(other.m_blocks, {});
    m_size = std::exchange(other.m_size, 0);
    m_keys = std::exchange(other.m_keys, std::make_shared<KeyTable>());
    m_appended = other.m_appended;
    m_erased = other.m_erased;
    m_places = std::exchange(other.m_places, std::make_shared<Places>());
    return *this;
}

const LevelIndex& ObjectList::places() const {
    const std::lock_guard lock(m_places->mutex);
    if (!m_places->made) {
        m_places->made = std::make_shared<const LevelIndex>(withoutPlaces(), m_places->base.get());
        m_places->base.reset();
    }
    return *m_places->made;
}

ObjectList ObjectList::withoutPlaces() const {
    ObjectList list = *this;
    list.m_places = std::make_shared<Places>();
    return list;
}

void ObjectList::forgetPlaces() {
    if (m_places.use_count() == 1 && !m_places->made) {
        return;
    }
    auto fresh = std::make_shared<Places>();
    {
        const std::lock_guard lock(m_places->mutex);
        fresh->base = m_places->made ? m_places->made : m_places->base;
    }
    m_places = std::move(fresh);
}

int ObjectList::indexOf(Key key) const {
    // At `last` or up to `count` before it.
    const auto among = [&](int last, int count) {
        last = std::min(last, m_size - 1);
        for (int index = std::max(0, last - count); index <= last; ++index) {
            if ((*this)[index].key == key) {
                return index;
            }
        }
        return -1;
    };
    if (m_size <= few) {
        return among(m_size - 1, m_size);
    }
    const int place = m_keys->place(*this, key);
    const int found = place < 0 ? -1 : among(place, m_erased);
    return found >= 0 || m_appended == 0 ? found : among(m_size - 1, m_appended);
}

const Object* ObjectList::find(Key key) const {
    const int index = indexOf(key);
    return index < 0 ? nullptr : &(*this)[index];
}

std::vector<int> ObjectList::indicesOf(std::span<const Key> keys) const {
    constexpr std::size_t share = 8; // of all objects, from which on it is quicker to look at each
    std::vector<int> indices;
    if (keys.size() > static_cast<std::size_t>(m_size) / share) {
        std::vector<Key> wanted(keys.begin(), keys.end());
        std::ranges::sort(wanted);
        int index = 0;
        for (const Object& object : *this) {
            if (std::ranges::binary_search(wanted, object.key)) {
                indices.push_back(index);
            }
            ++index;
        }
        return indices;
    }
    for (const Key key : keys) {
        const int index = indexOf(key);
        if (index >= 0) {
            indices.push_back(index);
        }
    }
    std::ranges::sort(indices);
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

ObjectList::Block& ObjectList::ownBlock(int block) {
    std::shared_ptr<Block>& held = m_blocks[static_cast<std::size_t>(block)];
    if (held.use_count() > 1) {
        held = std::make_shared<Block>(*held);
    }
    // Whoever let go of the block last has finished reading it.
    std::atomic_thread_fence(std::memory_order_acquire);
    return *held;
}

void ObjectList::appendPiece(Piece piece) {
    if (m_size % blockSize == 0) {
        m_blocks.push_back(std::make_shared<Block>());
    }
    ownBlock(blocks() - 1).push_back(std::move(piece));
    ++m_size;
}

ObjectList::Block ObjectList::takenFrom(int index) {
    Block taken;
    taken.reserve(static_cast<std::size_t>(m_size - index));
    for (int i = index; i < m_size; ++i) {
        taken.push_back(piece(i));
    }
    m_blocks.resize(static_cast<std::size_t>((index + blockSize - 1) / blockSize));
    if (index % blockSize != 0) {
        ownBlock(blocks() - 1).resize(static_cast<std::size_t>(index % blockSize));
    }
    m_size = index;
    return taken;
}

void ObjectList::noteAppended() {
    forgetPlaces();
    if (m_keys->isMade() && m_appended < few) {
        ++m_appended;
    } else {
        forgetKeys();
    }
}

void ObjectList::noteErased(int count) {
    forgetPlaces();
    if (m_keys->isMade() && m_erased + count <= few) {
        m_erased += count;
    } else if (count > 0) {
        forgetKeys();
    }
}

void ObjectList::forgetKeys() {
    forgetPlaces();
    m_appended = 0;
    m_erased = 0;
    if (m_keys->isMade() || m_keys.use_count() > 1) {
        m_keys = std::make_shared<KeyTable>();
    }
}

void ObjectList::append(Object object) {
    noteAppended();
    appendPiece(std::make_shared<const Object>(std::move(object)));
}

void ObjectList::insertPiece(int index, Piece piece) {
    for (int block = index / blockSize; piece; ++block, index = block * blockSize) {
        if (block == blocks()) {
            m_blocks.push_back(std::make_shared<Block>());
        }
        Block& own = ownBlock(block);
        Piece last;
        if (own.size() == blockSize) {
            last = std::move(own.back());
            own.pop_back();
        }
        own.insert(own.begin() + index % blockSize, std::exchange(piece, std::move(last)));
    }
    ++m_size;
}

void ObjectList::insert(int index, Object object) {
    EXPECTS(index >= 0 && index <= size());
    forgetKeys();
    insertPiece(index, std::make_shared<const Object>(std::move(object)));
}

void ObjectList::replace(int index, Object object) {
    EXPECTS(index >= 0 && index < size());
    if (object.key != (*this)[index].key) {
        forgetKeys();
    }
    forgetPlaces();
    ownPiece(index) = std::make_shared<const Object>(std::move(object));
}

void ObjectList::erase(int index) {
    EXPECTS(index >= 0 && index < size());
    noteErased(1);
    int block = index / blockSize;
    Block& first = ownBlock(block);
    first.erase(first.begin() + index % blockSize);
    for (; block + 1 < blocks(); ++block) {
        Block& next = ownBlock(block + 1);
        ownBlock(block).push_back(std::move(next.front()));
        next.erase(next.begin());
    }
    if (m_blocks.back()->empty()) {
        m_blocks.pop_back();
    }
    --m_size;
}

void ObjectList::rearrange(const std::vector<int>& order) {
    EXPECTS(std::ssize(order) == m_size);
    int first = 0; // that changes its place
    while (first < m_size && order[static_cast<std::size_t>(first)] == first) {
        ++first;
    }
    if (first == m_size) {
        return;
    }
    forgetKeys();
    const Block tail = takenFrom(first);
    for (int i = first; i < static_cast<int>(order.size()); ++i) {
        appendPiece(tail.at(static_cast<std::size_t>(order[static_cast<std::size_t>(i)] - first)));
    }
}

bool ObjectList::operator==(const ObjectList& other) const {
    if (m_size != other.m_size) {
        return false;
    }
    bool equal = true;
    visitDifferences(other, [&](int index) { equal = equal && (*this)[index] == other[index]; });
    return equal;
}

} // namespace spacetow
