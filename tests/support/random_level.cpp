#include "tests/support/random_level.h"

#include "core/level/nodes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace spacetow::test {

namespace {

void tame(double& number) {
    number = std::fmod(number, 100);
}

void tame(Vec2& point) {
    tame(point.x());
    tame(point.y());
}

class Maker {
  public:
    explicit Maker(std::uint64_t seed) : m_random(seed), m_figures(seed ^ 0x5eed) {}

    Level level(int objects) {
        Level level;
        level.name = text();
        level.author = text();
        level.description = text();
        level.gravity = point();
        level.updateSeconds = chance() ? 0.02 : m_random.uniform(0.001, 0.1);
        level.iterations = 1 + below(1000);
        level.substeps = 1 + below(100);
        level.rules = {1 + below(9), m_random.uniform(0.1, 5), chance(), chance() ? "stars" : text()};
        level.sleeping = m_figures.below(2) == 0;
        tune(level.rules);
        fillTags(level.tags);
        for (int i = below(3); i > 0; --i) {
            level.guides.push_back({point(), number(), text()});
        }
        for (int i = 0; i < objects; ++i) {
            level.objects.append(object(level));
        }
        for (int i = below(3); i > 0; --i) {
            level.hiddenProblems.push_back({text(), chance() ? 0 : static_cast<Key>(1 + below(1000))});
        }
        return level;
    }

  private:
    int below(int count) { return static_cast<int>(m_random.below(static_cast<std::uint32_t>(count))); }
    bool chance() { return m_random.below(2) == 0; }
    /// Short decimals, long ones, whole ones, tiny ones and huge ones.
    double number() {
        switch (below(6)) {
        case 0:
            return below(200) - 100;
        case 1:
            return (below(2000) - 1000) / 100.0;
        case 2:
            return m_random.uniform(-10, 10);
        case 3:
            return std::ldexp(m_random.uniform(-1, 1), below(40) - 20);
        case 4:
            return std::ldexp(m_random.uniform(-1, 1), below(600) - 300);
        default:
            return 0;
        }
    }
    double positive() { return std::abs(number()) + 0.01; }
    Vec2 point() { return {number(), number()}; }
    std::vector<Vec2> points(int least) {
        std::vector<Vec2> result(static_cast<std::size_t>(least + below(chance() ? 4 : 40)));
        for (Vec2& p : result) {
            p = point();
        }
        return result;
    }
    std::string text() {
        static const std::vector<std::string> words{
            "",        "cave", "Höhle", "洞窟", "a \"quoted\" one", "\\n", "two\nlines", std::string("\x01\x1f\0", 3),
            "🚀 tab\t", "/~1"};
        return words[static_cast<std::size_t>(below(static_cast<int>(words.size())))];
    }
    TagMask mask() { return chance() ? TagMask{m_random.next()} : TagMask::bit(below(32)); }

    void tune(Rules& rules) {
        const auto some = [this] { return m_figures.uniform(0.01, 100); };
        if (m_figures.below(2) == 0) {
            rules.thrust = some();
            rules.steering = some();
            rules.shipMass = some();
            rules.shipRestitution = m_figures.unit();
            rules.shipLinearDamping = m_figures.unit();
            rules.shipAngularDamping = m_figures.unit();
        }
        if (m_figures.below(2) == 0) {
            rules.rope = {some(), some(), static_cast<TruncationRule>(m_figures.below(5)), some(), m_figures.unit()};
        }
    }
    void fillTags(TagTable& tags) {
        for (int i = 5; i < TagTable::size; ++i) {
            if (below(4) == 0) {
                tags.set(i, {"tag " + std::to_string(i), m_random.below(0x1000000)});
            }
        }
        if (chance()) {
            tags.set(below(5), {});
        }
        if (chance()) {
            tags.set(31, {"", 0x123456});
        }
    }
    /// Three of its corners at least lie further from each other than an edit rounds: two that lie closer may become
    /// one when they are moved, and no edit can help that.
    Polygon polygon() {
        constexpr double apart = 1e-6;
        std::vector<Vec2> corners = points(3);
        std::vector<Vec2> different;
        const auto take = [&different](Vec2 corner) {
            tame(corner); // in a sound level they are so
            if (std::ranges::none_of(different, [&](const Vec2& other) { return (corner - other).norm() < apart; })) {
                different.push_back(corner);
            }
        };
        std::ranges::for_each(corners, take);
        while (different.size() < 3) {
            corners.push_back(point());
            take(corners.back());
        }
        return {std::move(corners)};
    }
    LevelShape shape() {
        switch (below(4)) {
        case 0:
            return EdgeChain{points(2), chance(), chance() ? noBack : positive()};
        case 1:
            return LineChain{points(2), chance()};
        case 2:
            return polygon();
        default:
            return Circle{point(), positive()};
        }
    }
    BodyObject body() {
        BodyObject body;
        body.kind = static_cast<BodyKind>(below(3));
        for (int i = 1 + below(3); i > 0; --i) {
            body.shapes.push_back(shape());
        }
        body.position = point();
        if (chance()) {
            body.angle = number();
            body.velocity = point();
            body.angularVelocity = number();
            body.mass = chance() ? std::optional(positive()) : std::nullopt;
            body.density = positive();
            body.restitution = m_random.unit();
            body.friction = m_random.unit();
            body.linearDamping = m_random.unit();
            body.angularDamping = m_random.unit();
            body.filter = {mask(), chance() ? TagMask::all() : mask()};
            body.tangible = chance();
            body.frozen = chance();
        }
        return body;
    }
    ConnectorObject connector(const Level& level) {
        ConnectorObject connector;
        const auto end = [&] {
            return level.objects.empty() ? Key{1} : level.objects[below(level.objects.size())].key;
        };
        connector.a = end();
        connector.b = end();
        if (chance()) {
            connector.anchorA = point();
            connector.anchorB = point();
            connector.length = chance() ? std::optional(positive()) : std::nullopt;
            connector.stiffness = positive();
            connector.damping = m_random.unit();
            connector.slack = chance();
            connector.bodiesCollide = chance();
            connector.truncation = static_cast<TruncationRule>(below(5));
            connector.limit = positive();
            connector.proportion = m_random.unit();
        }
        return connector;
    }
    /// One of the groups that are there, or none.
    Key group(const Level& level) {
        std::vector<Key> groups;
        for (const Object& object : level.objects) {
            if (std::holds_alternative<GroupObject>(object.data)) {
                groups.push_back(object.key);
            }
        }
        const int chosen = below(static_cast<int>(groups.size()) + 1);
        return chosen < std::ssize(groups) ? groups[static_cast<std::size_t>(chosen)] : 0;
    }
    Object object(const Level& level) {
        Object object;
        object.key = freshKey(level, m_random.next());
        object.name = text();
        object.parent = group(level);
        object.visible = below(8) != 0;
        object.locked = below(8) == 0;
        switch (below(9)) {
        case 0:
            object.data = ShipObject{point(), number()};
            break;
        case 1:
            object.data = PayloadObject{point(), positive(), positive(), m_figures.unit(), m_figures.unit()};
            break;
        case 2:
            object.data = FinishObject{point(), point()};
            break;
        case 3:
            object.data = connector(level);
            break;
        case 4:
            object.data = GroupObject{object.parent == 0 && chance(),
                                      chance() ? std::optional(m_random.below(0x1000000)) : std::nullopt};
            break;
        default:
            object.data = body();
        }
        return object;
    }

    Random m_random;
    Random m_figures; // of the ship and its rope, which came later: the other draws stay what they were
};

void tame(LevelShape& shape) {
    if (std::vector<Vec2>* vertices = verticesOf(shape)) {
        for (Vec2& vertex : *vertices) {
            tame(vertex);
        }
    } else {
        auto& circle = std::get<Circle>(shape);
        tame(circle.center);
        circle.radius = std::fmod(circle.radius, 10) + 0.01;
    }
}

void tame(ObjectData& data) {
    if (auto* body = std::get_if<BodyObject>(&data)) {
        tame(body->position);
        tame(body->angle);
        for (LevelShape& shape : body->shapes) {
            tame(shape);
        }
    } else if (auto* ship = std::get_if<ShipObject>(&data)) {
        tame(ship->position);
        tame(ship->angle);
    } else if (auto* payload = std::get_if<PayloadObject>(&data)) {
        tame(payload->position);
    } else if (auto* finish = std::get_if<FinishObject>(&data)) {
        tame(finish->a);
        tame(finish->b);
    } else if (auto* connector = std::get_if<ConnectorObject>(&data)) {
        tame(connector->anchorA);
        tame(connector->anchorB);
    }
}

bool isBodyIn(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object != nullptr && std::holds_alternative<BodyObject>(object->data);
}

BodyObject populatedBody() {
    BodyObject body;
    body.kind = BodyKind::Dynamic;
    body.shapes = {EdgeChain{{{0, 0}, {1, 0}, {1, 1}}, true, 0.5}, LineChain{{{0, 2}, {1, 2}, {1, 3}}, true},
                   Polygon{{{0, 4}, {1, 4}, {0, 5}}}, Circle{{3, 3}, 0.25}};
    body.position = {1, 2};
    body.angle = 0.5;
    body.velocity = {3, 4};
    body.angularVelocity = 5;
    body.mass = 6;
    body.density = 7;
    body.restitution = 0.25;
    body.friction = 0.75;
    body.linearDamping = 0.125;
    body.angularDamping = 0.375;
    body.filter = {TagMask::bit(2) | TagMask::bit(17), TagMask::bit(0) | TagMask::bit(2)};
    body.tangible = false;
    body.frozen = true;
    return body;
}

} // namespace

Level randomLevel(std::uint64_t seed, int objects) {
    return Maker(seed).level(objects);
}

Level soundLevel(std::uint64_t seed, int objects) {
    const Level wild = randomLevel(seed, objects);
    Level level = wild;
    level.objects = {};
    std::set<std::size_t> singles;
    for (const Object& wanted : wild.objects) {
        Object object = wanted;
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        const bool isMany = std::holds_alternative<BodyObject>(object.data) ||
                            std::holds_alternative<GroupObject>(object.data) || connector != nullptr;
        const bool holds = connector == nullptr || (connector->a != connector->b && isBodyIn(level, connector->a) &&
                                                    isBodyIn(level, connector->b));
        if (!holds || (!isMany && !singles.insert(object.data.index()).second)) {
            continue;
        }
        tame(object.data);
        level.objects.append(std::move(object));
    }
    for (const Vec2& place : {Vec2(50, 50), Vec2(51, 50.5)}) {
        BodyObject box{.shapes = {Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}}, .position = place};
        level.objects.append({freshKey(level, seed), "box", std::move(box), {}});
    }
    return level;
}

Level populatedLevel() {
    Level level;
    level.name = "Everything";
    level.author = "Nobody";
    level.description = "One of each.";
    level.gravity = {0.5, -2};
    level.updateSeconds = 0.01;
    level.iterations = 50;
    level.substeps = 4;
    level.sleeping = false;
    level.rules = {
        5, 2.5, true, "plain", 3, 7, 0.75, 0.25, 0.125, 1.5, {40'000, 90, TruncationRule::Clamp, 120, 0.625}};
    level.tags.set(7, {"ice", 0xabcdef});
    BodyObject plain;
    plain.shapes = {Circle{{0, 0}, 1}};
    level.objects.append({0x00000001, "body", populatedBody(), {}});
    level.objects.append({0x00000002, "plain", plain, {}});
    level.objects.append({0x00000003, "ship", ShipObject{{20, 21}, 0.5}, {}});
    level.objects.append({0x00000004, "payload", PayloadObject{{30, 31}, 0.3, 0.5, 0.375, 0.125}, {}});
    level.objects.append({0x00000005, "finish", FinishObject{{40, 41}, {42, 43}}, {}});
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 2;
    connector.anchorA = {0.1, 0.2};
    connector.anchorB = {0.3, 0.4};
    connector.length = 1.5;
    connector.stiffness = 200;
    connector.damping = 2;
    connector.slack = true;
    connector.bodiesCollide = true;
    connector.truncation = TruncationRule::PartialTanh;
    connector.limit = 10;
    connector.proportion = 0.75;
    level.objects.append({0x00000006, "connector", connector, {}});
    level.objects.append({0x00000007, "layer", GroupObject{true, 0x336699}, {}, 0, true, true});
    level.objects.append({0x00000008, "group", GroupObject{}, {}, 0x00000007});
    level.objects.append({0x00000009, "hidden", plain, {}, 0x00000008, false, true});
    level.guides = {{{1, 2}, 0.5, "ledge"}, {{3, 4}, 0, ""}};
    level.hiddenProblems = {{"hidden-in-play", 0x00000009}, {"finish-missing", 0}};
    return level;
}

} // namespace spacetow::test
