#pragma once
// Manifolds of one or two points between parts of any shape. A manifold is kept while the relative pose of its parts
// stays within the manifold tolerance. The points and the normal of a kept manifold are fixed to the bodies;
// separations and levers are updated in every iteration.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Updates a general pair without a lane: makes a new manifold, unless the kept one is still valid. Appends a
/// constraint to `NarrowPhase::constraints`, unless the manifold has no points or all points will bounce. A pair
/// without points gets a separation bound; if the bounding circles of two non-static bodies are apart, the contact of
/// such a pair is freed. `index` is the index of the pair, `perSecond` iterations per second, here and below.
void updateManifold(const ContactStage& stage, std::uint32_t index, double perSecond);

/// Makes a new manifold for a contact with a lane, and rewrites the lane, or closes the lane if no point is left.
void remakeManifold(const ContactStage& stage, std::uint32_t index, double perSecond);

/// How much nearer the parts of the pair may come before the kept manifold is out of date, m. Negative when the
/// manifold is out of date already. The pair has to have a contact.
double toleranceLeftOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair);

/// How much nearer the parts of a general pair without contact points may come before the parts can touch, m; 0 when
/// unknown.
double separationBoundOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair);

} // namespace spacetow
