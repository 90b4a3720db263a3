#pragma once
// What tags are called in panels, and what they may be called.

#include "core/level/tag_table.h"

#include <QColor>
#include <QString>

namespace spacetow {

/// Its name, or "#17".
QString tagText(const TagTable& table, int tag);
/// Why the tag cannot have this name; empty when it can.
QString objectionToTagName(const TagTable& table, const QString& name, int tag);
/// For a tag that has just got its first name; those of neighbours differ in lightness as well as in hue.
QColor freshTagColor(int tag);

} // namespace spacetow
