#pragma once
// A value, or the reason why there is none. For failures that a user or a file can cause.

#include "core/base/code.h"
#include "core/base/contract.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace spacetow {

/// Why something failed, and the facts that the sentence of its code needs.
struct Error {
    Code code;
    std::vector<std::string> arguments;

    bool operator==(const Error&) const = default;
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return m_state.index() == 0; }

    const T& value() const& {
        EXPECTS(m_state.index() == 0);
        return std::get<0>(m_state);
    }
    T&& value() && {
        EXPECTS(m_state.index() == 0);
        return std::get<0>(std::move(m_state));
    }
    const Error& error() const {
        EXPECTS(m_state.index() == 1);
        return std::get<1>(m_state);
    }

  private:
    std::variant<T, Error> m_state;
};

} // namespace spacetow
