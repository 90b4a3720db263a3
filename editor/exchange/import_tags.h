#pragma once
// Names of tags that a file gives to its figures, and their places in a table of tags.

#include "core/level/tag_table.h"
#include "editor/exchange/drawing.h"
#include "editor/exchange/report.h"

#include <string>
#include <vector>

namespace spacetow {

/// The name, or one like it where a level could not spell it.
std::string spellableTag(const std::string& name);

class ImportTags {
  public:
    /// Both must outlive this.
    ImportTags(const TagTable& table, Report& report) : m_table(table), m_report(report) {}

    /// The tag of walls, which is what the ship may not touch, and those of these names, in either case. A name for
    /// which there is no place any more is reported as "import-tags-full".
    TagMask maskOf(const DrawnItem& item, const std::vector<std::string>& names);
    const TagTable& table() const { return m_table; }

  private:
    int placeOf(const std::string& given);

    TagTable m_table;
    Report& m_report;
};

} // namespace spacetow
