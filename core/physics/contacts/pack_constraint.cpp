#include "core/physics/contacts/pack_constraint.h"

#include "core/geometry/moved.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/effective_mass.h"
#include "core/physics/lanes/solver_kernels.h"

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

/// Writes the 2 × 2 system of the points, their targets and their impulses. Two points with nearly the same effect make
/// the system singular. A point at which an impulse moves neither body does not act. Returns whether it is singular.
bool packBlock(const Constraint& c, ConstraintBatch& batch, std::uint32_t i, double perSecond) {
    const ConstraintPoint& p = c.points[0];
    const ConstraintPoint& q = c.points[1];
    const bool acts1 = p.normalMass > 0;
    const bool acts2 = c.count == 2 && q.normalMass > 0;
    const double mass1 = acts1 ? p.normalMass : 1;
    const double mass2 = acts2 ? q.normalMass : mass1;
    const double k11 = 1 / mass1;
    const double k22 = 1 / mass2;
    double coupling = acts1 && acts2 ? c.coupling : 0;
    double determinant = k11 * k22 - coupling * coupling;
    batch.target1[i] = acts1 ? p.target : noTarget;
    batch.target2[i] = acts2 ? q.target : noTarget;
    batch.impulse1[i] = p.normalImpulse;
    batch.impulse2[i] = q.normalImpulse;
    const double largest = std::max(k11, k22);
    const bool singular = acts1 && acts2 && largest * largest >= singularRatio * determinant;
    if (singular) {
        coupling = 0;
        determinant = k11 * k22;
    }
    batch.leverA1[i] = p.leverA;
    batch.leverB1[i] = p.leverB;
    batch.leverA2[i] = q.leverA;
    batch.leverB2[i] = q.leverB;
    batch.k11[i] = k11;
    batch.k22[i] = k22;
    batch.mass1[i] = mass1;
    batch.mass2[i] = mass2;
    batch.coupling[i] = coupling;
    batch.inverseDeterminant[i] = 1 / determinant;
    batch.separation1[i] = p.separation;
    batch.separation2[i] = c.count == 2 ? q.separation : std::numeric_limits<double>::infinity();
    batch.closingLimit1[i] = closingLimit(p.separation, p.target, c.restitution, perSecond);
    batch.closingLimit2[i] = c.count == 2 ? closingLimit(q.separation, q.target, c.restitution, perSecond) : noTarget;
    return singular;
}

const KeptManifold& manifoldOf(const Contacts& contacts, const ConstraintPoint& point) {
    return contacts.pool[point.contact].manifold;
}

/// The part of a kept manifold that all points share.
struct Frame {
    Vec2 normal;        // unit, in local coordinates of its owner
    Transform relative; // pose of a relative to b when the manifold was made
    double tolerance;
};

/// The frame of a merged contact, whose points come from several manifolds: all of these are valid at the present
/// poses.
Frame mergedFrame(const Bodies& bodies, const Constraint& c, bool still, bool normalOnA) {
    const Transform poseA = bodies.pose(c.a);
    const Transform poseB = still ? Transform{} : bodies.pose(c.b);
    return {(normalOnA ? poseA : poseB).rotation.inverse() * c.normal, relative(poseA, poseB), c.tolerance};
}

void packAnchors(const ContactStage& stage, const Constraint& c, ContactAnchors& anchors, std::uint32_t i) {
    const bool still = stage.contacts.table.pairs[c.points[0].pair].staticB;
    const KeptManifold& kept = manifoldOf(stage.contacts, c.points[0]);
    const Frame frame = c.merged ? mergedFrame(stage.bodies, c, still, kept.normalOnA) //
                                 : Frame{kept.normal, kept.relative, kept.tolerance};
    setLane(anchors.staticB, i, still);
    setLane(anchors.normalOnA, i, kept.normalOnA);
    setLane(anchors.acts1, i, c.points[0].normalMass > 0);
    setLane(anchors.acts2, i, c.count == 2 && c.points[1].normalMass > 0);
    setLane(anchors.first, i, true);
    setLane(anchors.second, i, c.count == 2);
    anchors.normalX[i] = frame.normal.x();
    anchors.normalY[i] = frame.normal.y();
    const KeptManifold::Point& p = kept.points[c.points[0].index];
    anchors.onA1X[i] = p.onA.x();
    anchors.onA1Y[i] = p.onA.y();
    anchors.onB1X[i] = p.onB.x();
    anchors.onB1Y[i] = p.onB.y();
    const ConstraintPoint& last = c.points[c.count == 2 ? 1 : 0];
    const KeptManifold::Point& q = manifoldOf(stage.contacts, last).points[last.index];
    anchors.onA2X[i] = q.onA.x();
    anchors.onA2Y[i] = q.onA.y();
    anchors.onB2X[i] = q.onB.x();
    anchors.onB2Y[i] = q.onB.y();
    anchors.relativeX[i] = frame.relative.position.x();
    anchors.relativeY[i] = frame.relative.position.y();
    anchors.cosine[i] = frame.relative.rotation.c;
    anchors.sine[i] = frame.relative.rotation.s;
    anchors.tolerance[i] = frame.tolerance;
    anchors.radiusA[i] = stage.bodies.steps[c.a].isCircle ? 0 : stage.bodies.steps[c.a].outerRadius;
    anchors.leastInverseMass[i] = leastInverseMass(stage.bodies, c.a, c.b);
}

} // namespace

void keepDeeperPoint(ConstraintBatch& batch, std::uint32_t i) {
    const bool first = batch.separation1[i] <= batch.separation2[i];
    const double impulse = batch.impulse1[i] + batch.impulse2[i];
    (first ? batch.target2 : batch.target1)[i] = noTarget;
    (first ? batch.impulse1 : batch.impulse2)[i] = impulse;
    (first ? batch.impulse2 : batch.impulse1)[i] = 0;
}

void pack(const ContactStage& stage, const Constraint& c, GeneralContact& contact, double perSecond) {
    const std::uint32_t i = contact.lane.lane;
    ConstraintBatch& batch = stage.constraints.batches.general[contact.lane.batch];
    batch.normalX[i] = c.normal.x();
    batch.normalY[i] = c.normal.y();
    batch.tangentLeverA[i] = c.tangentLeverA;
    batch.tangentLeverB[i] = c.tangentLeverB;
    batch.tangentMass[i] = c.tangentMass;
    batch.friction[i] = c.friction;
    batch.tangentImpulse[i] = c.tangentImpulse;
    contact.singular = packBlock(c, batch, i, perSecond);
    if (contact.singular) {
        keepDeeperPoint(batch, i);
        stage.flags.anySingular = true;
    }
    setLane(stage.constraints.batches.general.anchors(contact.lane.batch).singular, i, contact.singular);
    packAnchors(stage, c, stage.constraints.batches.general.anchors(contact.lane.batch), i);
    contact.merged = c.merged;
    contact.count = static_cast<std::uint32_t>(c.count);
    contact.bounces = false;
    for (std::size_t k = 0; k < contact.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        contact.points[k] = {p.pair, p.contact, p.index, p.bounces};
        contact.bounces |= p.bounces;
    }
    stage.flags.anyBounce |= contact.bounces;
}

} // namespace spacetow
