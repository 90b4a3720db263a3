#pragma once
// What tags are called in panels, and what they may be called.

#include "editor/canvas/tag_text.h"

#include <QColor>
#include <QString>

namespace spacetow {

/// Why the tag cannot have this name; empty when it can.
QString objectionToTagName(const TagTable& table, const QString& name, int tag);
/// For a tag that has just got its first name: as far from those that have one as can be.
QColor freshTagColor(const TagTable& table);

} // namespace spacetow
