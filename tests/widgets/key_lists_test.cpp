// The keys that the README names are those of the program.
#include "editor/window/key_bindings.h"

#include "editor/window/actions.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QRegularExpression>

using namespace spacetow;

namespace {

QStringList readmeLines() {
    QFile file(test::sourceFolder() + QStringLiteral("/README.md"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).split(u'\n') : QStringList();
}

/// The cells of the table that begins with this line.
QList<QStringList> tableOf(const QString& head) {
    const QStringList lines = readmeLines();
    QList<QStringList> rows;
    for (qsizetype i = lines.indexOf(head) + 2; i >= 2 && i < lines.size() && lines[i].startsWith(u'|'); ++i) {
        QStringList cells;
        for (const QString& cell : lines[i].split(QStringLiteral(" | "))) {
            cells << QString(cell).remove(QRegularExpression("^\\| | \\|$")).trimmed();
        }
        rows << cells;
    }
    return rows;
}

/// "Ctrl+X, C · Del" are Ctrl+X, Ctrl+C and Del: in a list the modifiers of the one before hold on.
QStringList keysNamed(const QString& cell) {
    QStringList keys;
    for (const QString& part : cell.split(QStringLiteral(" · "))) {
        QString modifiers;
        for (QString key : part.split(QRegularExpression(", | … |(?<=`) (?=`)"))) {
            key.remove(u'`');
            const qsizetype plus = key.lastIndexOf(u'+', -2);
            if (plus >= 0) {
                modifiers = key.left(plus + 1);
            } else {
                key.prepend(modifiers);
            }
            keys << key.replace(QStringLiteral("PgDn"), QStringLiteral("PgDown"));
        }
    }
    return keys;
}

} // namespace

class KeyListsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyKeyOfTheReadmeBelongsToAnAction() {
        const QList<QStringList> rows = tableOf("| keys | |");
        QVERIFY(rows.size() > 15);
        for (const QStringList& row : rows) {
            for (const QString& name : keysNamed(row.front())) {
                if (name == "arrows" || name == "Space" || name.startsWith("drag")) {
                    continue; // the drawing board's
                }
                const QKeySequence key = QKeySequence::fromString(name, QKeySequence::PortableText);
                QVERIFY2(key.count() == 1 && KeyBindings().ownerOf(key) != nullptr, qPrintable(name));
            }
        }
    }

    void theReadmeListsEveryToolWithItsKey() {
        const QList<QStringList> rows = tableOf("| key | tool | how |");
        for (const ActionRow& row : toolActions()) {
            const bool isTool = std::holds_alternative<ToolId>(row.id);
            const QString key = QString(row.keys).section(u' ', 0, 0);
            if (!isTool || key.isEmpty()) {
                continue;
            }
            const auto line =
                std::find_if(rows.begin(), rows.end(), [&](const auto& cells) { return cells[0] == key; });
            QVERIFY2(line != rows.end(), row.text);
            // One word of the tool's name is enough.
            const QStringList words = plainText(row).toLower().split(QRegularExpression("[ -]"));
            QVERIFY2(
                std::any_of(words.begin(), words.end(), [&](const QString& word) { return (*line)[1].contains(word); }),
                row.text);
        }
    }
};

SPACETOW_TEST(KeyListsTest)
#include "key_lists_test.moc"
