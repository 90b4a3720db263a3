// Contacts solved in fours against the same contacts solved one after the other: equal to the last bit.

#include "core/physics/world/world.h"

#include "core/base/random.h"
#include "core/math/vec.h"
#include "core/physics/lanes/contact_formulas.h"
#include "core/physics/lanes/solver_kernels.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

using namespace spacetow;

namespace {

constexpr Slot bodies = 40; // the first four of which nothing can move

struct Body {
    double x, y, turn, mass, inertia; // inverse
};

struct Contact {
    Slot a, b;
    double normalX, normalY, leverA, leverB, normalMass, tangentMass, friction, target, normal, tangent;
};

std::vector<Body> randomBodies(Random& random) {
    std::vector<Body> result;
    for (Slot i = 0; i < bodies; ++i) {
        const bool moves = i >= 4;
        result.push_back({random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-5, 5),
                          moves ? random.uniform(0.2, 9) : 0, moves ? random.uniform(0.2, 9) : 0});
    }
    return result;
}

std::vector<Contact> randomContacts(Random& random) {
    std::vector<Contact> result;
    for (int i = 0; i < 300; ++i) {
        const auto a = static_cast<Slot>(random.uniform(4, bodies - 0.001));
        const auto b = static_cast<Slot>(random.uniform(0, bodies - 0.001));
        if (a == b) {
            continue;
        }
        const double angle = random.uniform(-3, 3);
        const Rot normal = Rot::fromAngle(angle);
        result.push_back({a, b, normal.c, normal.s, random.uniform(-1, 1), random.uniform(-1, 1),
                          random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0, 1),
                          random.uniform(-0.5, 0.5), std::max(random.uniform(-0.2, 0.3), 0.0),
                          random.uniform(-0.1, 0.1)});
    }
    return result;
}

void apply(Body& a, Body& b, const Contact& c, double x, double y, double twist) {
    a.x -= a.mass * x;
    a.y -= a.mass * y;
    b.x += b.mass * x;
    b.y += b.mass * y;
    a.turn -= a.inertia * (twist * c.leverA);
    b.turn += b.inertia * (twist * c.leverB);
}

void rub(Body& a, Body& b, Contact& c) {
    const double sliding = (b.x - a.x) * -c.normalY + (b.y - a.y) * c.normalX + (b.turn * c.leverB - a.turn * c.leverA);
    const double limit = c.friction * c.normal;
    const double tangent = std::min(std::max(c.tangent - c.tangentMass * sliding, -limit), limit);
    const double rub = tangent - c.tangent;
    c.tangent = tangent;
    apply(a, b, c, -rub * c.normalY, rub * c.normalX, rub);
}

void solveOne(std::vector<Body>& all, Contact& c, double relaxation = 1) {
    Body& a = all[c.a];
    Body& b = all[c.b];
    const bool cold = c.normal == 0;
    rub(a, b, c);
    const double excess = (b.x - a.x) * c.normalX + (b.y - a.y) * c.normalY - c.target;
    const double normal = std::max(c.normal - relaxation * c.normalMass * excess, 0.0);
    const double push = normal - c.normal;
    c.normal = normal;
    apply(a, b, c, push * c.normalX, push * c.normalY, 0);
    if (cold && normal > 0) {
        rub(a, b, c);
    }
}

/// Contacts, and what they work on.
struct Packed {
    ContactBatches batches;
    std::vector<BodyVelocity> velocities;
};

Packed packed(const std::vector<Body>& all, const std::vector<Contact>& contacts, std::vector<Lane>& lanes) {
    Packed result;
    ContactBatches& batches = result.batches;
    for (const Body& body : all) {
        result.velocities.push_back({body.x, body.y, body.turn, 0});
    }
    result.velocities.emplace_back();
    batches.circles.reset(all.size());
    for (const Contact& c : contacts) {
        const Lane lane = batches.circles.open(c.a, all[c.a].mass > 0, c.b, all[c.b].mass > 0);
        CircleBatch& batch = batches.circles[lane.batch];
        const std::uint32_t i = lane.lane;
        batch.normalX[i] = c.normalX;
        batch.normalY[i] = c.normalY;
        batch.massA[i] = all[c.a].mass;
        batch.massB[i] = all[c.b].mass;
        batch.inertiaA[i] = all[c.a].inertia;
        batch.inertiaB[i] = all[c.b].inertia;
        batch.leverA[i] = c.leverA;
        batch.leverB[i] = c.leverB;
        batch.normalMass[i] = c.normalMass;
        batch.tangentMass[i] = c.tangentMass;
        batch.friction[i] = c.friction;
        batch.target[i] = c.target;
        batch.normalImpulse[i] = c.normal;
        batch.tangentImpulse[i] = c.tangent;
        lanes.push_back(lane);
    }
    return result;
}

/// Bodies on top of each other that have come down on one that nothing can move, from the lowest contact to the
/// topmost.
Packed landingColumn() {
    std::vector<Body> all(bodies, {0, -1, 0, 1, 0});
    all.front() = {};
    std::vector<Contact> contacts;
    for (Slot i = 0; i + 1 < bodies; ++i) {
        contacts.push_back(
            {.a = i, .b = i + 1, .normalX = 0, .normalY = 1, .normalMass = 1 / (all[i].mass + all[i + 1].mass)});
    }
    std::vector<Lane> lanes;
    return packed(all, contacts, lanes);
}

double greatestSpeed(const Packed& column) {
    double greatest = 0;
    for (const BodyVelocity& velocity : column.velocities) {
        greatest = std::max(greatest, std::abs(velocity.y));
    }
    return greatest;
}

void fill(Wide& wide, Random& random, double least, double most) {
    for (int lane = 0; lane < 4; ++lane) {
        wide[lane] = random.uniform(least, most);
    }
}

/// Contacts of polygons with random manifolds, some of them with static bodies, some with one point.
void addManifolds(ContactBatches& batches, Random& random) {
    batches.general.reset(bodies);
    for (int i = 0; i < 200; ++i) {
        const auto a = static_cast<Slot>(random.uniform(4, bodies - 0.001));
        const auto b = static_cast<Slot>(random.uniform(0, bodies - 0.001));
        if (a != b) {
            const Lane lane = batches.general.open(a, true, b, b >= 4);
            ContactAnchors& anchors = batches.general.anchors(lane.batch);
            anchors.a[lane.lane] = a;
            anchors.b[lane.lane] = b;
            anchors.staticB[lane.lane] = b < 4 ? -1 : 0;
            anchors.normalOnA[lane.lane] = i % 3 == 0 ? -1 : 0;
            anchors.first[lane.lane] = anchors.acts1[lane.lane] = -1;
            anchors.singular[lane.lane] = i % 7 == 0 ? -1 : 0;
            anchors.second[lane.lane] = anchors.acts2[lane.lane] = i % 4 != 0 ? -1 : 0;
        }
    }
    for (std::uint32_t i = 0; i < batches.general.size(); ++i) {
        ContactAnchors& s = batches.general.anchors(i);
        for (Wide* wide :
             {&s.normalX, &s.normalY, &s.onA1X, &s.onA1Y, &s.onB1X, &s.onB1Y, &s.onA2X, &s.onA2Y, &s.onB2X, &s.onB2Y,
              &s.relativeX, &s.relativeY, &s.cosine, &s.sine, &s.tolerance, &s.radiusA, &s.leastInverseMass}) {
            fill(*wide, random, -1, 1);
        }
        ConstraintBatch& c = batches.general[i];
        for (Wide* wide : {&c.massA, &c.massB, &c.inertiaA, &c.inertiaB, &c.mass1, &c.mass2, &c.leverA1, &c.leverB1,
                           &c.leverA2, &c.leverB2, &c.velocity1, &c.velocity2}) {
            fill(*wide, random, 0.1, 1);
        }
    }
}

/// Poses or ways of all bodies.
std::vector<BodyVelocity> randomRows(Random& random) {
    std::vector<BodyVelocity> rows;
    for (Slot i = 0; i < bodies; ++i) {
        const double x = random.uniform(-1, 1);
        const double y = random.uniform(-1, 1);
        rows.push_back({x, y, random.uniform(-1, 1), random.uniform(0, 1)});
    }
    return rows;
}

bool sameBits(const Wide& a, const Wide& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

class ContactBatchesTest : public QObject {
    Q_OBJECT

  private slots:
    void foursGiveTheBitsOfOneAfterTheOther_data() {
        QTest::addColumn<bool>("wide");
        QTest::newRow("narrow registers") << false;
        if (hasWideRegisters()) {
            QTest::newRow("wide registers") << true;
        }
    }
    void foursGiveTheBitsOfOneAfterTheOther() {
        QFETCH(bool, wide);
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Random random(seed);
            std::vector<Body> all = randomBodies(random);
            std::vector<Contact> contacts = randomContacts(random);
            std::vector<Lane> lanes;
            auto [batches, velocities] = packed(all, contacts, lanes);
            overrelaxPass(batches, velocities, wide);
            solvePass(batches, velocities, wide);
            for (const double relaxation : {overrelaxation, 1.0}) {
                for (Contact& c : contacts) {
                    solveOne(all, c, relaxation);
                }
            }
            for (Slot i = 0; i < bodies; ++i) {
                const BodyVelocity& velocity = velocities[i];
                const bool same = velocity.x == all[i].x && velocity.y == all[i].y && velocity.angular == all[i].turn;
                QVERIFY2(same, qPrintable(QString("seed %1, body %2").arg(seed).arg(i)));
            }
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                const CircleBatch& batch = batches.circles[lanes[i].batch];
                QCOMPARE(batch.normalImpulse[lanes[i].lane], contacts[i].normal);
                QCOMPARE(batch.tangentImpulse[lanes[i].lane], contacts[i].tangent);
            }
        }
    }

    void overrelaxedPassesStopAColumnInFewerPasses() {
        Packed plain = landingColumn();
        Packed relaxed = landingColumn();
        for (int pass = 1; pass <= 160; ++pass) {
            solvePass(plain.batches, plain.velocities);
            const auto relax = pass % 4 == 0 ? solvePass : overrelaxPass;
            relax(relaxed.batches, relaxed.velocities, hasWideRegisters());
        }
        QVERIFY2(greatestSpeed(plain) > 0.4, qPrintable(QString::number(greatestSpeed(plain))));
        QVERIFY2(greatestSpeed(relaxed) < 0.05, qPrintable(QString::number(greatestSpeed(relaxed))));
    }

    void contactsAreRenewedToTheSameBitsWithAnyRegisters() {
        if (!hasWideRegisters()) {
            return; // both are the same code
        }
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Random random(seed);
            ContactBatches narrow;
            addManifolds(narrow, random);
            ContactBatches wide = narrow;
            std::vector<BodyVelocity> velocities(bodies + 1);
            std::array<std::vector<BodyVelocity>, 2> corrections;
            corrections.fill(velocities);
            const std::vector<BodyVelocity> poses = randomRows(random);
            const std::vector<BodyVelocity> plannedMotions = randomRows(random);
            const BodyViews views{{poses.data(), sizeof(BodyVelocity)}, {plannedMotions.data(), sizeof(BodyVelocity)}};
            int outdated = 0;
            for (ContactBatches* batches : {&narrow, &wide}) {
                refreshContacts(*batches, views, 240, batches == &wide);
                measureVelocities(*batches, velocities, batches == &wide);
                QVERIFY(correctPositions(*batches, corrections[batches == &wide ? 1 : 0], {1.0 / 240, 0.2, 0.1},
                                         batches == &wide));
            }
            for (std::uint32_t i = 0; i < narrow.general.size(); ++i) {
                const ConstraintBatch& a = narrow.general[i];
                const ConstraintBatch& b = wide.general[i];
                QVERIFY2(sameBits(a.normalX, b.normalX) && sameBits(a.separation1, b.separation1) &&
                             sameBits(a.separation2, b.separation2) && sameBits(a.target2, b.target2) &&
                             sameBits(a.closingLimit1, b.closingLimit1) && sameBits(a.leverA1, b.leverA1) &&
                             sameBits(a.leverB2, b.leverB2) && sameBits(a.tangentLeverA, b.tangentLeverA) &&
                             sameBits(a.tangentMass, b.tangentMass) && sameBits(a.mass1, b.mass1) &&
                             sameBits(a.k22, b.k22) && sameBits(a.coupling, b.coupling) &&
                             sameBits(a.inverseDeterminant, b.inverseDeterminant),
                         qPrintable(QString("seed %1, batch %2").arg(seed).arg(i)));
                QCOMPARE(narrow.general.flags(i).outdated, wide.general.flags(i).outdated);
                outdated += narrow.general.flags(i).outdated != 0 ? 1 : 0;
            }
            QVERIFY(outdated > 0);
            for (Slot i = 0; i < bodies; ++i) {
                QCOMPARE(corrections[0][i].x, corrections[1][i].x);
                QCOMPARE(corrections[0][i].angular, corrections[1][i].angular);
            }
        }
    }

    void circlesAreUpdatedByTheFormulasOfOneContact_data() { foursGiveTheBitsOfOneAfterTheOther_data(); }
    void circlesAreUpdatedByTheFormulasOfOneContact() {
        QFETCH(bool, wide);
        constexpr double perSecond = 240;
        int reached = 0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Random random(seed);
            const std::vector<Body> all = randomBodies(random);
            std::vector<Lane> lanes;
            const std::vector<Contact> contacts = randomContacts(random);
            ContactBatches batches = packed(all, contacts, lanes).batches;
            const std::vector<BodyVelocity> poses = randomRows(random);
            const std::vector<BodyVelocity> motions = randomRows(random);
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                CircleAnchors& anchors = batches.circles.anchors(lanes[i].batch);
                anchors.a[lanes[i].lane] = contacts[i].a;
                anchors.b[lanes[i].lane] = contacts[i].b;
                anchors.wideUpdate[lanes[i].lane] = -1;
                anchors.radiusA[lanes[i].lane] = anchors.radiusB[lanes[i].lane] = 0.1;
            }
            refreshContacts(batches, {{poses.data(), sizeof(BodyVelocity)}, {motions.data(), sizeof(BodyVelocity)}},
                            perSecond, wide);
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                const Contact& c = contacts[i];
                const CircleBatch& batch = batches.circles[lanes[i].batch];
                const std::uint32_t at = lanes[i].lane;
                const Vec2 apart(poses[c.b].x - poses[c.a].x, poses[c.b].y - poses[c.a].y);
                const double separation = std::sqrt(apart.x() * apart.x() + apart.y() * apart.y()) - 0.1 - 0.1;
                const BodyVelocity& a = motions[c.a];
                const BodyVelocity& b = motions[c.b];
                const double margin = formulas::speculativeMargin(std::abs(a.x - b.x) + std::abs(a.y - b.y), //
                                                                  a.padding + b.padding);
                const bool outdated = (batches.circles.flags(lanes[i].batch).outdated >> at & 1) != 0;
                struct {
                    double massA, massB, inertiaA, inertiaB;
                } masses{all[c.a].mass, all[c.b].mass, all[c.a].inertia, all[c.b].inertia};
                struct {
                    double a, b;
                } levers{0.1 + 0.5 * separation, -0.1 - 0.5 * separation};
                QVERIFY(batch.separation[at] == separation);
                QVERIFY(batch.target[at] == formulas::targetVelocity(separation, perSecond));
                QVERIFY(batch.closingLimit[at] == formulas::closingLimit(separation, perSecond));
                QVERIFY(batch.tangentMass[at] == 1 / formulas::inverseMass(masses, levers, levers));
                QVERIFY(outdated == (separation > margin) || std::abs(separation - margin) < 1e-12);
                reached += outdated ? 0 : 1;
            }
        }
        QVERIFY(reached > 100);
    }

    void aLaneThatWasGivenUpIsUsedAgain() {
        ContactBatches batches;
        batches.circles.reset(10);
        const Lane first = batches.circles.open(0, true, 1, true);
        batches.circles.open(2, true, 3, true);
        batches.circles.close(first);
        QCOMPARE(int{batches.circles.flags(first.batch).occupied}, 2);
        const Lane again = batches.circles.open(4, true, 5, true);
        QCOMPARE(again.batch, first.batch);
        QCOMPARE(again.lane, first.lane);
        QCOMPARE(batches.circles.size(), std::size_t{1});
    }

    void noBodyThatMovesIsTwiceInABatch() {
        Random random(7);
        const std::vector<Body> all = randomBodies(random);
        std::vector<Lane> lanes;
        const ContactBatches batches = packed(all, randomContacts(random), lanes).batches;
        for (std::uint32_t i = 0; i < batches.circles.size(); ++i) {
            std::vector<Slot> moving;
            for (const auto& ends : {batches.circles[i].a, batches.circles[i].b}) {
                std::copy_if(ends.begin(), ends.end(), std::back_inserter(moving),
                             [](Slot slot) { return slot >= 4 && slot < bodies; });
            }
            std::sort(moving.begin(), moving.end());
            QVERIFY(std::adjacent_find(moving.begin(), moving.end()) == moving.end());
        }
    }
};

SPACETOW_TEST(ContactBatchesTest)
#include "contact_batches_test.moc"
