#pragma once
// A 64-bit state hash (FNV-1a over 64-bit words with a final mix), equal on every platform for equal bits.

#include <bit>
#include <cstdint>

namespace spacetow {

class StateHash {
  public:
    void add(std::uint64_t word) {
        m_state ^= word;
        m_state *= 0x100000001b3ull;
        m_state ^= m_state >> 29;
    }
    /// Minus zero counts as zero: they compare equal and behave alike in everything that is hashed.
    void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value)); }

    std::uint64_t value() const {
        // Finaliser of MurmurHash3 (Appleby, public domain): every input bit reaches every output bit.
        std::uint64_t h = m_state;
        h ^= h >> 33;
        h *= 0xff51afd7ed558ccdull;
        h ^= h >> 33;
        h *= 0xc4ceb9fe1a85ec53ull;
        h ^= h >> 33;
        return h;
    }

  private:
    std::uint64_t m_state = 0xcbf29ce484222325ull;
};

} // namespace spacetow
