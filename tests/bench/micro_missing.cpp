// Stands in for the micro-benchmarks where their library is missing.

#include <cstdio>

int main() {
    std::fputs("Google Benchmark is not installed (Debian: libbenchmark-dev), so there are no micro-benchmarks; "
               "install it, configure again and rebuild.\n",
               stderr);
    return 1;
}
