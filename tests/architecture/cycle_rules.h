#pragma once
// Cycles among units: a header and the source beside it, taken as one.

#include "tests/architecture/source_rules.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace spacetow::test {

/// "core/physics/step/update" of its header and of its source.
inline std::string unitOf(const std::string& path) {
    return path.substr(0, path.rfind('.'));
}

/// The other units that each unit includes; only units that are among the sources.
using UnitGraph = std::map<std::string, std::set<std::string>>;

inline UnitGraph unitGraphOf(const std::vector<Source>& sources) {
    UnitGraph graph;
    for (const Source& source : sources) {
        graph[unitOf(source.path)];
    }
    for (const Source& source : sources) {
        for (const std::string& line : linesOf(source.text)) {
            const std::optional<std::string> included = includedBy(line);
            const std::string unit = included ? unitOf(included->substr(1)) : std::string();
            if (unit != unitOf(source.path) && graph.contains(unit)) {
                graph[unitOf(source.path)].insert(unit);
            }
        }
    }
    return graph;
}

/// A sentence for each cycle that a walk along the includes closes; none when the units have an order.
class CycleSearch {
  public:
    explicit CycleSearch(const UnitGraph& graph) : m_graph(graph) {
        for (const auto& [unit, included] : graph) {
            visit(unit);
        }
    }
    const std::vector<std::string>& problems() const { return m_problems; }

  private:
    void visit(const std::string& unit) {
        const auto open = std::find(m_way.begin(), m_way.end(), unit);
        if (open != m_way.end()) {
            std::string text;
            for (auto step = open; step != m_way.end(); ++step) {
                text += *step + " includes ";
            }
            m_problems.push_back(text + unit);
            return;
        }
        if (!m_seen.insert(unit).second) {
            return;
        }
        m_way.push_back(unit);
        for (const std::string& included : m_graph.at(unit)) {
            visit(included);
        }
        m_way.pop_back();
    }

    const UnitGraph& m_graph;
    std::set<std::string> m_seen;
    std::vector<std::string> m_way; // from where the walk began to where it is
    std::vector<std::string> m_problems;
};

inline std::vector<std::string> unitCycles(const std::vector<Source>& sources) {
    const UnitGraph graph = unitGraphOf(sources);
    return CycleSearch(graph).problems();
}

} // namespace spacetow::test
