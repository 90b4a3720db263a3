#pragma once
// The objects of a level as a list of shared immutable pieces. A copy shares them in blocks, so that it costs next to
// nothing; a change copies the blocks it touches. What is looked up by key is remembered and shared as well.

#include "core/base/contract.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace spacetow {

struct Object;
class KeyTable;
class LevelIndex;

/// Identity of an object in its file: random, never zero, never used again. Spelled as eight hexadecimal digits.
using Key = std::uint32_t;

/// Objects in creation order, which is also the drawing order. No two have the same key.
class ObjectList {
  public:
    ObjectList();
    ~ObjectList() = default;
    ObjectList(const ObjectList&) = default;
    ObjectList(ObjectList&& other) noexcept;
    ObjectList& operator=(const ObjectList&) = default;
    ObjectList& operator=(ObjectList&& other) noexcept;

    int size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    const Object& operator[](int index) const { return *piece(index); }

    /// Position of the object with this key, or −1. The first call after many objects have come or gone takes time
    /// with their number, the others hardly any.
    int indexOf(Key key) const;
    /// The object with this key, or null.
    const Object* find(Key key) const;
    /// Positions of the objects with these keys, ascending, each once.
    std::vector<int> indicesOf(std::span<const Key> keys) const;

    void append(Object object);
    void insert(int index, Object object);
    void replace(int index, Object object);
    void erase(int index);
    /// Removes every object for which `predicate(object)` holds, in one pass.
    template <class Predicate>
    void eraseIf(Predicate predicate);
    /// All objects in another order: the one that is at `order[i]` comes to stand at `i`.
    void rearrange(const std::vector<int>& order);

    /// Whether both lists hold the very same piece at this place: a cheap "has it changed?".
    bool sharesPiece(int index, const ObjectList& other) const {
        return index < size() && index < other.size() && piece(index) == other.piece(index);
    }
    /// Calls `visit(index)`, in ascending order, for each place at which the lists do not hold the same piece, up to
    /// the end of the longer one. What they share in blocks takes no time.
    template <class Visit>
    void visitDifferences(const ObjectList& other, Visit visit) const;

    /// Whether a whole block is the same: objects `block` × blockSize up to the next multiple.
    bool sharesBlock(int block, const ObjectList& other) const {
        return block < blocks() && block < other.blocks() &&
               m_blocks[static_cast<std::size_t>(block)] == other.m_blocks[static_cast<std::size_t>(block)];
    }
    static constexpr int blockSize = 256; // of all blocks but the last, which may be smaller
    int blocks() const { return static_cast<int>(m_blocks.size()); }

    /// Where the objects are. Made at the first call, out of that of the list this one was made from, in time that
    /// grows with what they differ in. Lives as long as the list, unchanged.
    const LevelIndex& places() const;
    /// The same list, without what `places` would keep.
    ObjectList withoutPlaces() const;

    class Iterator;
    Iterator begin() const;
    Iterator end() const;

    /// Equal values; pieces that are shared are not looked into.
    bool operator==(const ObjectList& other) const;

  private:
    using Piece = std::shared_ptr<const Object>;
    using Block = std::vector<Piece>;

    const Piece& piece(int index) const {
        return (*m_blocks[static_cast<std::size_t>(index) / blockSize])[static_cast<std::size_t>(index) % blockSize];
    }
    Block& ownBlock(int block);
    Piece& ownPiece(int index) { return ownBlock(index / blockSize)[static_cast<std::size_t>(index) % blockSize]; }
    void appendPiece(Piece piece);
    void insertPiece(int index, Piece piece);
    /// The pieces from `index` on; they are no longer in the list.
    Block takenFrom(int index);

    /// Every change calls one of these.
    void noteAppended();
    void noteErased(int count);
    void forgetKeys();
    void forgetPlaces();

    std::vector<std::shared_ptr<Block>> m_blocks;
    int m_size = 0;
    std::shared_ptr<KeyTable> m_keys; // of the list as it was before these:
    int m_appended = 0;
    int m_erased = 0;
    struct Places;
    std::shared_ptr<Places> m_places;
};

class ObjectList::Iterator {
  public:
    Iterator(const ObjectList& list, int index) : m_list(&list), m_index(index) { enter(); }
    const Object& operator*() const { return **m_at; }
    const Object* operator->() const { return m_at->get(); }
    Iterator& operator++() {
        ++m_index;
        ++m_at;
        if (m_index % blockSize == 0) {
            enter();
        }
        return *this;
    }
    bool operator==(const Iterator& other) const { return m_index == other.m_index; }

  private:
    void enter() { m_at = m_index < m_list->size() ? &m_list->piece(m_index) : nullptr; }

    const ObjectList* m_list;
    int m_index;
    const Piece* m_at = nullptr;
};

inline ObjectList::Iterator ObjectList::begin() const {
    return {*this, 0};
}

inline ObjectList::Iterator ObjectList::end() const {
    return {*this, m_size};
}

template <class Predicate>
void ObjectList::eraseIf(Predicate predicate) {
    int first = 0;
    for (const Object& object : *this) {
        if (predicate(object)) {
            break;
        }
        ++first;
    }
    const int before = m_size;
    if (first == m_size) {
        return;
    }
    for (Piece& piece : takenFrom(first)) {
        if (!predicate(*piece)) {
            appendPiece(std::move(piece));
        }
    }
    noteErased(before - m_size);
}

template <class Visit>
void ObjectList::visitDifferences(const ObjectList& other, Visit visit) const {
    const int shorter = std::min(m_size, other.m_size);
    const int longer = std::max(m_size, other.m_size);
    for (int index = 0; index < longer; ++index) {
        const auto block = static_cast<std::size_t>(index) / blockSize;
        if (index % blockSize == 0 && index < shorter && m_blocks[block] == other.m_blocks[block]) {
            index += blockSize - 1;
        } else if (index >= shorter || piece(index) != other.piece(index)) {
            visit(index);
        }
    }
}

} // namespace spacetow
