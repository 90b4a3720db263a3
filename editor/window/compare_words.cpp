#include "editor/window/compare_words.h"

#include "editor/panels/number_text.h"
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

QString differencesInWords(const Level& before, const Level& after) {
    const std::vector<DifferenceLine> all = differenceLines(before, after, differenceBetween(before, after));
    const int count = static_cast<int>(all.size());
    QStringList lines;
    for (int i = 0; i < std::min(count, listedDifferences); ++i) {
        lines << all[static_cast<std::size_t>(i)].text;
    }
    if (count > listedDifferences) {
        lines << CompareWords::tr("… and %1 more").arg(countText(count - listedDifferences));
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace spacetow
