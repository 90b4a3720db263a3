#pragma once
// The contacts that the solver has: each in a lane of a batch, from the iteration in which its surfaces come near each
// other to that in which they part. While a contact is listed its impulses are in its lane; what is known of the pair
// beside that has a copy only when the lane is given up, or at the end of an update.

#include "core/physics/state/world_data.h"

namespace spacetow {

/// A round contact's surfaces.
struct Touch {
    Vec2 normal; // from a to b
    double separation;
    double radiusA, radiusB; // from the centres of mass to the surfaces along the normal; of static bodies 0
    std::uint32_t feature;
};

/// What the normal velocity is to be, see contact_rules.h.
struct RoundTarget {
    double velocity = 0; // m/s
    double closing = 0;  // m/s: faster than they may come nearer to each other
    bool bounces = false;
};

/// Lists a round contact, or renews it where it is listed.
void listRound(WorldData& data, std::uint32_t pair, const Touch& touch, const RoundTarget& target);

/// Lists a general contact.
void listGeneral(WorldData& data, const Constraint& constraint, double perSecond);

/// Writes a listed general contact anew; its pair is that of the constraint.
void renewGeneral(WorldData& data, const Constraint& constraint, double perSecond);

/// Where the point that acts for both points of singular contacts may have changed.
void renewSingular(WorldData& data);

/// Strikes the pair's contact from the list, impulses included. The pair is to be looked at until something else is
/// known of it.
void unlist(WorldData& data, std::uint32_t pair);

/// Copies impulses from the lanes to where they are kept.
void saveImpulses(WorldData& data, const RoundContact& contact);
void saveImpulses(WorldData& data, const GeneralContact& contact);
void saveImpulses(WorldData& data);

/// A contact of other features than before begins without impulses. True when it does.
bool beginAt(Contact& contact, std::uint32_t feature);

/// Notes which general contacts might come to lie in one plane: of all that are listed in the order of their pairs, or
/// of the last one.
void findNeighbours(WorldData& data);
void findNeighboursOfLast(WorldData& data);
/// Whether any of them do.
bool anyInOnePlane(const WorldData& data);

/// The listed contacts keep their lanes when `stretches` of pairs have moved in the table.
void followPairs(WorldData& data);

/// Saves all impulses; the next iteration lists all contacts anew. To be called when contacts may no longer be those of
/// the pairs.
void dropContacts(WorldData& data);

/// Begins a list without contacts.
void clearContacts(WorldData& data);

} // namespace spacetow
