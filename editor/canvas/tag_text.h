#pragma once
// What a tag is called wherever it is shown.

#include "core/level/tag_table.h"

#include <QString>

namespace spacetow {

/// Its name, or "#17".
inline QString tagText(const TagTable& table, int tag) {
    const std::string& name = table[tag].name;
    return name.empty() ? QStringLiteral("#%1").arg(tag) : QString::fromStdString(name);
}

} // namespace spacetow
