#include "core/level/lint.h"

#include "core/level/build.h"
#include "core/level/file.h"
#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <functional>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Build = std::function<void(Level&)>;

void add(Level& level, ObjectData data, Key key = 0) {
    level.objects.append({key != 0 ? key : static_cast<Key>(level.objects.size() + 1), "", std::move(data), {}});
}

BodyObject body(LevelShape shape, BodyKind kind = BodyKind::Static) {
    BodyObject result;
    result.kind = kind;
    result.shapes = {std::move(shape)};
    return result;
}

/// Ship at the origin, payload and finish to its right, nothing around them.
Level game() {
    Level level;
    add(level, ShipObject{{0, 0}, 0});
    add(level, PayloadObject{{3, 0}, 0.2, 0.25});
    add(level, FinishObject{{6, -1}, {6, 1}});
    return level;
}

Level with(Level level, ObjectData data) {
    add(level, std::move(data));
    return level;
}

Level sandbox(ObjectData data) {
    return with(Level(), std::move(data));
}

Level springBetween(double stiffness, double damping, TruncationRule rule = TruncationRule::None) {
    Level level;
    add(level, body(Circle{{0, 0}, 0.5}, BodyKind::Dynamic), 1);
    add(level, body(Circle{{5, 0}, 0.5}, BodyKind::Dynamic), 2);
    ConnectorObject spring;
    spring.a = 1;
    spring.b = 2;
    spring.stiffness = stiffness;
    spring.damping = damping;
    spring.truncation = rule;
    add(level, spring, 3);
    return level;
}

Level changed(Level level, const Build& change) {
    change(level);
    return level;
}

std::string summary(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        text += text.empty() ? "" : " ";
        text += std::string(problem.severity == Severity::Error     ? "E:"
                            : problem.severity == Severity::Warning ? "W:"
                                                                    : "N:") +
                std::string(problem.code.text());
    }
    return text;
}

Polygon star() {
    Polygon polygon;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        polygon.vertices.emplace_back(std::cos(angle), std::sin(angle));
    }
    return polygon;
}

Polygon square(double half, const Vec2& center = {0, 0}) {
    return {{center + Vec2(-half, -half), center + Vec2(half, -half), center + Vec2(half, half),
             center + Vec2(-half, half)}};
}

EdgeChain groundAt(double y, double depth = noBack) {
    return {{{-10, y}, {10, y}}, false, depth}; // free side above
}

BodyObject tagged(TagMask tags, TagMask touches) {
    BodyObject result = body(Circle{{0, 50}, 1});
    result.filter = {tags, touches};
    return result;
}

} // namespace

class LintTest : public QObject {
    Q_OBJECT

  private slots:
    void lintFindsWhatIsWrongAndNothingElse_data() {
        QTest::addColumn<QString>("found");
        QTest::addColumn<Level>("level");
        const auto row = [](const char* name, const char* found, const Level& level) {
            QTest::newRow(name) << QString(found) << level;
        };
        const double nan = std::nan("");
        row("nothing in an empty level", "", Level());
        row("nothing in a game", "", game());
        row("nothing in a sandbox", "", sandbox(body(Circle())));
        row("ship alone", "E:payload-missing E:finish-missing", sandbox(ShipObject()));
        row("payload alone", "E:ship-missing E:finish-missing", sandbox(PayloadObject()));
        row("finish alone", "E:ship-missing E:payload-missing", sandbox(FinishObject()));
        row("two ships", "E:several-ships", with(game(), ShipObject{{9, 9}, 0}));
        row("two payloads", "E:several-payloads", with(game(), PayloadObject{{9, 9}, 0.2, 1}));
        row("two finishes", "E:several-finishes", with(game(), FinishObject{{9, 9}, {9, 8}}));

        row("ship inside a box", "E:ship-in-wall", with(game(), body(square(1))));
        row("ship across a line", "E:ship-in-wall", with(game(), body(LineChain{{{-1, 0}, {1, 0}}, false})));
        row("ship above the ground", "", with(game(), body(groundAt(-0.21))));
        row("ship through the ground", "E:ship-in-wall", with(game(), body(LineChain{{{-1, -0.1}, {1, -0.1}}, false})));
        row("nose through a ceiling", "E:ship-in-wall", with(game(), body(LineChain{{{-1, 0.23}, {1, 0.23}}, false})));
        row("nose below a ceiling", "", with(game(), body(LineChain{{{-1, 0.24}, {1, 0.24}}, false})));
        row("in the notch of the ship", "", with(game(), body(Circle{{0, -0.15}, 0.03})));
        row("behind a thick wall", "E:ship-in-wall", with(game(), body(EdgeChain{{{-1, 1}, {1, 1}}, false, 2})));
        row("behind a thin wall", "", with(game(), body(EdgeChain{{{-1, 1}, {1, 1}}, false, 0.5})));
        row("payload in the ground", "E:payload-in-wall", with(game(), body(LineChain{{{2, -0.1}, {4, -0.1}}, false})));
        row("payload above the ground", "", with(game(), body(LineChain{{{2, -0.21}, {4, -0.21}}, false})));
        row("ship in an intangible box", "", changed(game(), [](Level& level) {
                BodyObject ghost = body(square(1));
                ghost.tangible = false;
                add(level, ghost);
            }));
        row("ship in a box that it does not touch", "", changed(game(), [](Level& level) {
                BodyObject other = body(square(1));
                other.filter = {TagMask::bit(debrisTag), TagMask::bit(debrisTag)};
                add(level, other);
            }));

        row("repeated vertex of a chain", "W:zero-length-wall",
            sandbox(body(EdgeChain{{{0, 0}, {1, 0}, {1, 0}, {2, 0}}, false, 1})));
        row("closed chain that ends where it starts", "W:zero-length-wall",
            sandbox(body(LineChain{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, true})));
        row("open chain that ends where it starts", "",
            sandbox(body(LineChain{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, false})));
        row("one vertex", "E:chain-too-short", sandbox(body(EdgeChain{{{0, 0}}, false, 1})));
        row("no vertex", "E:chain-too-short", sandbox(body(LineChain{{}, true})));
        row("all at one point", "E:chain-without-length", sandbox(body(LineChain{{{1, 1}, {1, 1}}, false})));
        row("no shape", "E:no-shape", sandbox(BodyObject()));

        row("concave polygon", "", sandbox(body(Polygon{{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}})));
        row("clockwise polygon", "W:polygon-clockwise", sandbox(body(Polygon{{{0, 0}, {0, 1}, {1, 0}}})));
        row("star", "E:polygon-crosses-itself", sandbox(body(star())));
        row("bow tie", "E:polygon-crosses-itself", sandbox(body(Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}})));
        row("a spike", "E:polygon-crosses-itself",
            sandbox(body(Polygon{{{0, 0}, {2, 0}, {3, 0}, {2, 0.0}, {2, 2}, {0, 2}}})));
        row("flat polygon", "E:polygon-crosses-itself", sandbox(body(Polygon{{{0, 0}, {1, 1}, {2, 2}}})));
        row("sliver", "E:polygon-flat", sandbox(body(Polygon{{{0, 0}, {1, 0}, {2, 1e-14}}})));
        row("two corners", "E:polygon-too-few-vertices", sandbox(body(Polygon{{{0, 0}, {1, 1}}})));
        row("two different corners", "W:repeated-vertex E:polygon-too-few-vertices",
            sandbox(body(Polygon{{{0, 0}, {1, 1}, {1, 1}}})));
        row("repeated corner", "W:repeated-vertex", sandbox(body(Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}})));
        row("too many corners", "E:polygon-too-large", sandbox(body(Polygon{std::vector<Vec2>(2000, Vec2(0, 0))})));

        row("no radius", "E:not-positive", sandbox(body(Circle{{0, 0}, 0})));
        row("negative radius", "E:not-positive", sandbox(body(Circle{{0, 0}, -1})));
        row("radius not finite", "E:not-finite", sandbox(body(Circle{{0, 0}, nan})));
        row("centre not finite", "E:not-finite", sandbox(body(Circle{{nan, 0}, 1})));
        row("vertex not finite", "E:not-finite E:not-finite",
            sandbox(body(EdgeChain{{{0, 0}, {1, nan}, {-INFINITY, 1}}, false, 1})));
        row("depth not a number", "E:not-finite", sandbox(body(EdgeChain{{{0, 0}, {1, 0}}, false, nan})));
        row("depth below zero", "E:out-of-range", sandbox(body(EdgeChain{{{0, 0}, {1, 0}}, false, -1})));
        row("vertex far away", "E:out-of-range", sandbox(body(LineChain{{{0, 0}, {2e6, 0}}, false})));
        row("restitution above one", "E:out-of-range", changed(Level(), [](Level& level) {
                BodyObject bouncy = body(Circle());
                bouncy.restitution = 1.5;
                add(level, bouncy);
            }));
        row("mass of zero", "E:not-positive", changed(Level(), [](Level& level) {
                BodyObject light = body(Circle());
                light.mass = 0;
                add(level, light);
            }));
        row("gravity not finite", "E:not-finite", changed(Level(), [](Level& l) { l.gravity.y() = INFINITY; }));
        row("no lives", "E:out-of-range", changed(Level(), [](Level& l) { l.rules.lives = 0; }));
        row("ship without mass", "E:not-positive", changed(Level(), [](Level& l) { l.rules.shipMass = 0; }));
        row("rope exact beyond its limit", "E:out-of-range",
            changed(Level(), [](Level& l) { l.rules.rope.proportion = 2; }));
        row("no time", "E:not-positive", changed(Level(), [](Level& l) { l.updateSeconds = 0; }));
        row("no iterations", "E:out-of-range", changed(Level(), [](Level& l) { l.iterations = 0; }));

        row("key twice", "E:key-taken", changed(Level(), [](Level& level) {
                add(level, body(Circle()), 7);
                add(level, body(Circle()), 7);
            }));
        row("two tags of one name", "E:duplicate-tag", changed(Level(), [](Level& level) {
                level.tags.set(9, {"wall", 0});
            }));
        row("a tag named as if it had no name", "E:bad-tag-name", changed(Level(), [](Level& level) {
                level.tags.set(9, {"#12", 0});
            }));

        row("no tags at all", "W:touches-nothing", sandbox(tagged({}, TagMask::all())));
        row("touches nothing at all", "W:touches-nothing", sandbox(tagged(TagMask::bit(0), {})));
        row("two that pass through each other", "W:touches-nothing W:touches-nothing",
            changed(Level(), [](Level& level) {
                add(level, tagged(TagMask::bit(8), TagMask::bit(9)));
                add(level, tagged(TagMask::bit(9), TagMask::bit(10)));
            }));
        row("two that meet", "", changed(Level(), [](Level& level) {
                add(level, tagged(TagMask::bit(8), TagMask::bit(9)));
                add(level, tagged(TagMask::bit(9), TagMask::bit(8)));
            }));
        row("intangible scenery", "", changed(Level(), [](Level& level) {
                BodyObject scenery = tagged({}, {});
                scenery.tangible = false;
                add(level, scenery);
            }));

        row("connector to nothing", "E:connector-end-missing",
            changed(springBetween(1, 0), [](Level& level) { level.objects.erase(1); }));
        row("connector to a ship", "E:connector-end-no-body",
            changed(with(game(), body(Circle{{0, 9}, 1})), [](Level& level) {
                ConnectorObject rope;
                rope.a = 1;
                rope.b = 4;
                add(level, rope);
            }));
        row("connector to itself", "E:connector-same-ends", changed(springBetween(1, 0), [](Level& level) {
                Object object = level.objects[2];
                std::get<ConnectorObject>(object.data).b = 1;
                level.objects.replace(2, object);
            }));
        row("connector of walls", "W:connector-moves-nothing", changed(Level(), [](Level& level) {
                add(level, body(Circle()), 1);
                add(level, body(Circle{{5, 0}, 1}), 2);
                ConnectorObject rope;
                rope.a = 1;
                rope.b = 2;
                add(level, rope, 3);
            }));
        // A sub-step lasts 0.1 ms; each ball weighs π/4 kg.
        row("soft spring", "", springBetween(1000, 1));
        row("stiff spring", "W:spring-too-stiff", springBetween(1e8, 1));
        row("stiff spring that is cut off", "", springBetween(1e8, 1, TruncationRule::Zero));
        row("strong damping", "W:damping-too-strong", springBetween(1000, 1e5));
    }
    void lintFindsWhatIsWrongAndNothingElse() {
        QFETCH(QString, found);
        QFETCH(Level, level);
        QCOMPARE(QString::fromStdString(summary(lint(level))), found);
    }

    void problemsNameTheirObjectAndPlace() {
        Level level = game();
        add(level, body(EdgeChain{{{0, 10}, {1, 10}, {1, 10}}, false, 1}), 99);
        const std::vector<Problem> problems = lint(level);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].object, Key{99});
        QCOMPARE(problems[0].pointer, std::string("/objects/3/shapes/0/vertices/2"));
        QCOMPARE(problems[0].line, 0);
        QCOMPARE(problems[0].arguments, (std::vector<std::string>{"1", "2"}));
    }

    void problemsComeInTheOrderOfTheObjectsTheLevelFirst() {
        Level level;
        add(level, body(LineChain{{{0, 0}}, false}), 5);
        add(level, body(Circle{{0, 0}, -1}), 6);
        level.rules.lives = 0;
        std::string order;
        for (const Problem& problem : lint(level)) {
            order += std::to_string(problem.object);
        }
        QCOMPARE(order, std::string("056"));
    }

    void whatLintRejectsIsLeftOutOfTheWorld() {
        Level level;
        add(level, body(star(), BodyKind::Dynamic), 1);
        add(level, body(Circle{{0, 0}, 1}, BodyKind::Dynamic), 2);
        add(level, body(Circle{{9, 0}, std::nan("")}, BodyKind::Dynamic), 3);
        ConnectorObject rope;
        rope.a = 1;
        rope.b = 2;
        add(level, rope, 4);
        const BuiltWorld built = builtWorld(level);
        QCOMPARE(built.bodies.size(), std::size_t{1});
        QCOMPARE(built.bodies[0].first, Key{2});
        QVERIFY(built.world.connectors().empty());
    }

    void randomLevelsCanBeLintedBuiltAndUpdated() {
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            Level level = randomLevel(seed, 20);
            level.iterations = 2;
            level.substeps = 1;
            BuiltWorld built = builtWorld(level);
            built.world.update();
            QVERIFY2(built.world.parameters().iterations == 2, ("seed " + std::to_string(seed)).c_str());
        }
    }

    void tenThousandWallsAreLintedWhileTyping() {
        Level level = game();
        EdgeChain cave;
        cave.closed = true;
        for (int i = 0; i < 10000; ++i) {
            const double angle = 2 * std::numbers::pi * i / 10000;
            cave.vertices.emplace_back(20 * std::cos(angle), 20 * std::sin(angle));
        }
        cave.depth = 1;
        add(level, body(cave));
        QVERIFY(lint(level).empty());
        const CpuTimer timer;
        int runs = 0;
        while (runs < 5) {
            runs += lint(level).empty() ? 1 : 0;
        }
        // Fifty milliseconds each in an optimised build, which this one may not be.
        QVERIFY2(timer.seconds() < runs * (isSanitized ? 2.5 : 0.25), qPrintable(QString::number(timer.seconds())));
    }

    void manyBadPolygonsAreLintedInTime() {
        Level level;
        for (Key key = 1; key <= 150; ++key) {
            Polygon zigzag;
            for (int i = 0; i < 1000; ++i) {
                zigzag.vertices.emplace_back(i % 2 == 0 ? 0 : 10, i * 0.01);
            }
            zigzag.vertices.emplace_back(5, -1);
            zigzag.vertices.emplace_back(5, 20);
            add(level, body(zigzag), key);
        }
        const CpuTimer timer;
        QVERIFY(hasErrors(lint(level)));
        QVERIFY2(timer.seconds() < 5, qPrintable(QString::number(timer.seconds())));
    }
};

SPACETOW_TEST(LintTest)
#include "lint_test.moc"
