#pragma once
// What an import does not take over, as codes: each kind is told once, with how often, in which lines of the file and
// by which names. Sentences are made in editor/window/messages.

#include "core/base/result.h"
#include "editor/exchange/codes.h"

#include <string>
#include <vector>

namespace spacetow {

class Report {
  public:
    /// Something was left out or changed at this line (0: none), perhaps with a name.
    void refuse(ExchangeCode code, int line, const std::string& name = {});
    /// Each with the arguments: how often, lines, names; of both the first few.
    std::vector<Error> notes() const;

  private:
    struct Kind {
        ExchangeCode code;
        int count = 0;
        std::vector<int> lines;
        std::vector<std::string> names;
    };
    std::vector<Kind> m_kinds; // in the order in which they came up
};

} // namespace spacetow
