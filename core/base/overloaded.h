#pragma once
// Several lambdas as one visitor for std::visit. A visitor without a generic lambda does not compile when it misses an
// alternative, which is how a new kind of object is noticed wherever it matters.

namespace spacetow {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

} // namespace spacetow
