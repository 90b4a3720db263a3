#include "editor/panels/tag_names.h"

#include "core/level/key_text.h"

#include <QCoreApplication>

#include <array>

namespace spacetow {

namespace {

constexpr std::array<QRgb, 8> freshColors{0xffe69f00, 0xff56b4e9, 0xff009e73, 0xfff0e442,
                                          0xff3f7fd0, 0xffd55e00, 0xffcc79a7, 0xff9aa4b2};

struct TagNames {
    Q_DECLARE_TR_FUNCTIONS(TagNames)
};

} // namespace

QString objectionToTagName(const TagTable& table, const QString& name, int tag) {
    const std::optional<int> taken = table.indexOf(name.toStdString());
    if (taken && *taken != tag) {
        return TagNames::tr("There is a tag of this name already.");
    }
    return unnamedTag(name.toStdString()) < 0 ? QString()
                                              : TagNames::tr("That is how a tag without a name is written.");
}

QColor freshTagColor(int tag) {
    return QColor::fromRgb(freshColors[static_cast<std::size_t>(tag) % freshColors.size()]);
}

} // namespace spacetow
