#include "editor/window/compare_words.h"

#include "editor/window/messages_compare.h"

#include <QCoreApplication>
#include <QStringList>

namespace spacetow {

namespace {

constexpr int listedDifferences = 5;

struct CompareWords {
    Q_DECLARE_TR_FUNCTIONS(Compare)
};

} // namespace

ComparedLevels comparedLevels(const Level& before, const Level& after) {
    const LevelDifference difference = differenceBetween(before, after);
    ComparedLevels compared;
    for (const ObjectDifference& object : difference.objects) {
        if (object.change != ObjectChange::Removed) {
            compared.keys.push_back(object.key);
        }
    }
    QStringList lines;
    const std::vector<DifferenceLine> all = differenceLines(before, after, difference);
    const int count = static_cast<int>(all.size());
    for (int i = 0; i < std::min(count, listedDifferences); ++i) {
        lines << all[static_cast<std::size_t>(i)].text;
    }
    if (count > listedDifferences) {
        lines << CompareWords::tr("… and %1 more").arg(count - listedDifferences);
    }
    compared.words = lines.join(QLatin1Char('\n'));
    return compared;
}

} // namespace spacetow
