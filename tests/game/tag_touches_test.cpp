#include "core/game/tag_touches.h"

#include "core/base/random.h"
#include "core/game/session.h"
#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "core/physics/query/masked_meetings.h"
#include "core/physics/query/why_apart.h"
#include "tests/support/bodies.h"
#include "tests/support/full_run.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

World taggedWorld(Random& random) {
    World world({.gravity = {0, -5}, .iterations = 4});
    for (int i = 0; i < 12; ++i) {
        const Vec2 at(random.uniform(-2, 2), random.uniform(-2, 2));
        BodyDef def = random.below(2) == 0 ? ball(at, random.uniform(0.1, 0.6)) : box(at, 0.4, 0.3);
        def.kind = random.below(4) == 0 ? BodyKind::Static : BodyKind::Dynamic;
        def.tangible = random.below(6) != 0;
        def.filter = {{1U << random.below(6) | 1U << random.below(6)}, {random.below(64)}};
        add(world, def);
    }
    add(world, edgeBody({-5, -2.5}, {5, -2.5}));
    return world;
}

using TagPairs = std::set<std::pair<int, int>>;

void addAll(TagPairs& pairs, TagMask a, TagMask b) {
    for (int i = 0; i < 32; ++i) {
        for (int k = 0; k < 32; ++k) {
            if (a.contains(i) && b.contains(k)) {
                pairs.insert({i, k});
                pairs.insert({k, i});
            }
        }
    }
}

} // namespace

class TagTouchesTest : public QObject {
    Q_OBJECT

  private slots:
    // An account of its own: by what each pair of bodies answers after each update.
    void tagsAgreeWithALogOfEachContact() {
        int touches = 0;
        int passes = 0;
        for (std::uint64_t seed = 1; seed <= usualOrThin<std::uint64_t>(60, 10); ++seed) {
            Random random(seed);
            World world = taggedWorld(random);
            TagTouches noted;
            TagPairs touched, passed;
            for (int update = 0; update < 20; ++update) {
                world.update();
                noted.note(world, true);
                for (const TouchEvent& began : world.events().began) {
                    addAll(touched, world.body(began.a).filter.tags, world.body(began.b).filter.tags);
                }
                // As if no mask were in the way, but nothing moved.
                World open = world;
                const std::vector<BodyId> bodies = world.bodies();
                for (const BodyId id : bodies) {
                    open.setFilter(id, Filter{});
                }
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
                        const BodyState a = world.body(bodies[i]);
                        const BodyState b = world.body(bodies[k]);
                        const bool masked = whyNotColliding(world, bodies[i], bodies[k]).why == WhyApart::Mask;
                        const WhyApart without = whyNotColliding(open, bodies[i], bodies[k]).why;
                        if (masked && a.tangible && b.tangible && without == WhyApart::NextUpdate) {
                            addAll(passed, a.filter.tags, b.filter.tags);
                        }
                    }
                }
            }
            for (int i = 0; i < 32; ++i) {
                for (int k = 0; k < 32; ++k) {
                    QVERIFY2(noted.haveTouched(i, k) == (touched.count({i, k}) != 0), seedText(seed));
                    QVERIFY2(noted.havePassed(i, k) || passed.count({i, k}) == 0, seedText(seed));
                    touches += noted.haveTouched(i, k) ? 1 : 0;
                    passes += noted.havePassed(i, k) ? 1 : 0;
                }
            }
        }
        QVERIFY(touches > 100 && passes > 100);
    }

    void meetingsAreThoseOfOverlappingBodiesThatMasksKeepApart() {
        for (std::uint64_t seed = 1; seed <= usualOrThin<std::uint64_t>(100, 20); ++seed) {
            Random random(seed);
            World world = taggedWorld(random);
            world.update();
            for (const auto& [a, b] : maskedMeetings(world)) {
                QVERIFY2(!mayTouch(world.body(a).filter, world.body(b).filter), seedText(seed));
                QVERIFY2(whyNotColliding(world, a, b).why == WhyApart::Mask, seedText(seed));
                QVERIFY2(world.bounds(a).grown(0.001).overlaps(world.bounds(b)), seedText(seed));
            }
            std::set<std::pair<BodyId, BodyId>> once;
            for (const auto& pair : maskedMeetings(world)) {
                QVERIFY2(once.insert(pair).second, seedText(seed));
            }
        }
    }

    void aSessionKnowsWhatTouchedSinceItBegan() {
        Level level;
        level.iterations = 4;
        level.gravity = {0, -10};
        BodyObject floor;
        floor.shapes = {EdgeChain{{{-5, 0}, {5, 0}}}};
        floor.filter = {TagMask::bit(7), TagMask::all()};
        level.objects.append({1, {}, floor, {}});
        BodyObject falling;
        falling.kind = BodyKind::Dynamic;
        falling.shapes = {Circle{{0, 0}, 0.2}};
        falling.position = {0, 1};
        falling.filter = {TagMask::bit(8), TagMask::all()};
        level.objects.append({2, {}, falling, {}});
        falling.position = {2, 1};
        falling.filter = {TagMask::bit(9), TagMask::bit(20)};
        level.objects.append({3, {}, falling, {}});
        Session session(level);
        session.setExplains(true);
        for (int i = 0; i < 60; ++i) {
            session.step(Controls{});
        }
        QVERIFY(session.tagTouches().haveTouched(7, 8) && session.tagTouches().haveTouched(8, 7));
        QVERIFY(!session.tagTouches().haveTouched(7, 9) && session.tagTouches().havePassed(7, 9));
        QVERIFY(!session.tagTouches().havePassed(8, 9));
        Session other(level);
        for (int i = 0; i < 60; ++i) {
            other.step(Controls{});
        }
        QCOMPARE(other.hash(), session.hash()); // decides nothing
        QVERIFY(other.tagTouches().haveTouched(7, 8) && !other.tagTouches().havePassed(7, 9));
    }
};

SPACETOW_TEST(TagTouchesTest)
#include "tag_touches_test.moc"
