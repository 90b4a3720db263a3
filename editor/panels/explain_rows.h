#pragma once
// What the explanation panel says of an object in a session, as rows of words.

#include "core/game/session.h"
#include "editor/editing/collision_cure.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace spacetow {

struct ExplainRow {
    QString what;
    QString value;
    Key target = 0; // whom a click leads to
};

/// Rows with a head. The heads are the same for as long as the same kind of thing is explained.
struct ExplainSection {
    QString title;
    std::vector<ExplainRow> rows;
};

/// Of a body or a connector; of the whole world for key 0. Empty for what is not in the world.
std::vector<ExplainSection> explainSections(const Session& session, Key object);

/// Why two objects do not collide; nothing when one of them is not a body in the world.
std::optional<ApartObjects> apartObjects(const Session& session, Key a, Key b);
/// Code and arguments of the sentence.
Error apartCode(const Level& level, const ApartObjects& apart);
Error cureCode(const Level& level, const CollisionCure& cure);

/// "9.81 N ↓"; "0 N" without a direction.
QString vectorText(const Vec2& v, const QString& unit);

} // namespace spacetow
