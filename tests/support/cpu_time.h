#pragma once
// Processor time of this process, for limits that must not depend on what else the machine is doing.

#include <ctime>

namespace spacetow::test {

class CpuTimer {
  public:
    double seconds() const { return static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC; }

  private:
    std::clock_t m_start = std::clock();
};

} // namespace spacetow::test
