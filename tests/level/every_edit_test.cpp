// Every edit there is, on levels made at random: its input stays as it was, and what comes out can be written, read
// and is whole.
#include "core/level/file.h"
#include "tests/support/every_edit.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/structural_breaches.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QRegularExpression>

#include <algorithm>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<EditRow> allEdits() {
    std::vector<EditRow> rows;
    rows.insert(rows.end(), everyEdit().begin(), everyEdit().end());
    rows.insert(rows.end(), everyCure().begin(), everyCure().end());
    return rows;
}

/// What is not as it should be after the edit of this level; empty when all is well.
QString faultOf(const EditRow& edit, std::uint64_t seed, const Level& input) {
    EditTask task(seed, input);
    const Level output = edit.run(task);
    if (!(task.level == soundLevel(seed))) {
        return QStringLiteral("changes its input");
    }
    if (const QStringList codes = structuralBreaches(output); !codes.isEmpty()) {
        return codes.join(QLatin1Char(' '));
    }
    if (const std::optional<Error> error = saveError(output)) {
        return QString::fromUtf8(error->code.text());
    }
    const LevelFile read = parseLevel(levelText(output), Checks::FileOnly);
    return read.level == output && read.problems.empty() ? QString() : QStringLiteral("is read differently");
}

/// The functions in the headers of the folder that make one level of another: by their names.
std::set<QString> editsDeclared() {
    const QDir folder(sourceFolder() + QStringLiteral("/core/level"));
    QString text;
    for (const QString& name : folder.entryList({QStringLiteral("*.h")})) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            text += QString::fromUtf8(file.readAll());
        }
    }
    QStringList results{QStringLiteral("Level")};
    const QRegularExpression holders(QStringLiteral("\\nstruct (\\w+) \\{\\n    Level level;"));
    for (QRegularExpressionMatchIterator i = holders.globalMatch(text); i.hasNext();) {
        results << i.next().captured(1);
    }
    const QRegularExpression functions(
        QStringLiteral("\\n(?:Result<)?(?:%1)>? (\\w+)\\(").arg(results.join(QLatin1Char('|'))));
    std::set<QString> names;
    for (QRegularExpressionMatchIterator i = functions.globalMatch(text); i.hasNext();) {
        names.insert(i.next().captured(1));
    }
    return names;
}

} // namespace

class EveryEditTest : public QObject {
    Q_OBJECT

  private slots:
    void theTableNamesEveryEdit() {
        std::set<QString> named;
        for (const EditRow& edit : allEdits()) {
            named.insert(QString::fromLatin1(edit.name));
        }
        const std::set<QString> declared = editsDeclared();
        QVERIFY(declared.contains(QStringLiteral("cutAlong"))); // a result that holds a level
        QStringList missing;
        std::ranges::set_symmetric_difference(declared, named, std::back_inserter(missing));
        QCOMPARE(missing, QStringList());
    }

    void theLevelsTheyAreTriedOnAreSound() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            QCOMPARE(structuralBreaches(soundLevel(seed)), QStringList());
        }
    }

    void anEditLeavesItsInputUntouchedAndItsOutputValid_data() {
        QTest::addColumn<int>("row");
        int row = 0;
        for (const EditRow& edit : allEdits()) {
            QTest::newRow(edit.name) << row++;
        }
    }
    void anEditLeavesItsInputUntouchedAndItsOutputValid() {
        QFETCH(int, row);
        const EditRow edit = allEdits()[static_cast<std::size_t>(row)];
        const int seeds = fullOrQuick(400, usualOrThin(25, 4));
        int changes = 0;
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
            const Level input = soundLevel(seed);
            const QString fault = faultOf(edit, seed, input);
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(fault)));
            EditTask again(seed, input);
            changes += edit.run(again) == input ? 0 : 1;
        }
        QVERIFY(changes > 0 || isThinRun()); // or it would prove nothing; a thin run is for faults of memory
    }
};

SPACETOW_TEST(EveryEditTest)
#include "every_edit_test.moc"
