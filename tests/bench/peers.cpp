#include "tests/bench/engines.h"

namespace spacetow::bench {

std::vector<Peer> peers(const Scene& scene) {
    static_cast<void>(scene); // read by what is installed
    std::vector<Peer> all{{"box2d", std::nullopt}, {"chipmunk", std::nullopt}};
#ifdef SPACETOW_BENCH_BOX2D
    all[0].engine = box2dEngine(scene);
#endif
#ifdef SPACETOW_BENCH_CHIPMUNK
    all[1].engine = chipmunkEngine(scene);
#endif
    return all;
}

} // namespace spacetow::bench
