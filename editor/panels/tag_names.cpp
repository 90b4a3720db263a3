#include "editor/panels/tag_names.h"

#include "core/level/key_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace spacetow {

namespace {

constexpr std::array<QRgb, 8> freshColors{0xffe69f00, 0xff56b4e9, 0xff009e73, 0xfff0e442,
                                          0xff3f7fd0, 0xffd55e00, 0xffcc79a7, 0xff9aa4b2};

/// How far apart two colours look, roughly: the eye is keener on green, and on red the more of it there is.
double distanceOf(const QColor& a, const QColor& b) {
    const double red = 0.5 * (a.red() + b.red()) / 255;
    const double r = a.red() - b.red();
    const double g = a.green() - b.green();
    const double blue = a.blue() - b.blue();
    return std::sqrt((2 + red) * r * r + 4 * g * g + (3 - red) * blue * blue);
}

std::vector<QColor> colorsToChooseFrom() {
    std::vector<QColor> colors;
    for (const QRgb color : freshColors) {
        colors.push_back(QColor::fromRgb(color));
    }
    constexpr int hues = 12;
    for (const auto& [saturation, value] : {std::pair(200, 240), std::pair(160, 150), std::pair(90, 230)}) {
        for (int hue = 0; hue < hues; ++hue) {
            colors.push_back(QColor::fromHsv(hue * 360 / hues, saturation, value));
        }
    }
    return colors;
}

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

QColor freshTagColor(const TagTable& table) {
    const auto room = [&table](const QColor& color) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int tag = 0; tag < TagTable::size; ++tag) {
            if (!table[tag].name.empty()) {
                nearest = std::min(nearest, distanceOf(color, QColor::fromRgb(table[tag].color)));
            }
        }
        return nearest;
    };
    return std::ranges::max(colorsToChooseFrom(), {}, room);
}

} // namespace spacetow
