#include "editor/panels/history_panel.h"

#include "core/level/edits.h"
#include "editor/window/messages.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct HistoryShown {
    HistoryShown()
        : document({}, [this] { return now; }), toolbox(document, 1),
          panel(document, toolbox, [](const Label& label) { return sentence(label); }),
          tester(&panel.model(), QAbstractItemModelTester::FailureReportingMode::Fatal) {
        panel.setOrigin("Opened cave.json");
        panel.resize(300, 300);
        panel.show();
    }
    std::chrono::steady_clock::time_point now{};
    Document document;
    Toolbox toolbox;
    HistoryPanel panel;
    QAbstractItemModelTester tester;

    /// One entry, or with a merge key perhaps a part of the last one.
    void edit(LabelCode code, const std::string& mergeKey = {}) {
        Level level = document.level();
        level.name += code.text();
        document.commit({code, 1}, {std::make_shared<const Level>(std::move(level)), {}}, mergeKey);
    }
    QModelIndex row(int number) { return panel.model().index(number); }
    QStringList texts() {
        QStringList all;
        for (int i = 0; i < panel.model().rowCount(); ++i) {
            all << row(i).data().toString();
        }
        return all;
    }
    bool isBold(int number) { return row(number).data(Qt::FontRole).value<QFont>().bold(); }
    bool isGrey(int number) { return row(number).data(Qt::ForegroundRole).isValid(); }
    void click(int number) {
        QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, panel.list().visualRect(row(number)).center());
    }
};

} // namespace

class HistoryPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itListsWhatHasBeenDoneByName() {
        HistoryShown shown;
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json"}));
        shown.edit("move");
        shown.edit("rotate");
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json", "Move object", "Rotate object"}));
        QVERIFY(shown.isBold(2) && !shown.isBold(1) && !shown.isGrey(2));
        shown.document.undo();
        QVERIFY(shown.isBold(1) && !shown.isBold(2) && shown.isGrey(2) && !shown.isGrey(1));
    }

    void aClickJumpsOverManyStepsAtOnce() {
        HistoryShown shown;
        for (const LabelCode code : std::initializer_list<LabelCode>{"move", "rotate", "scale", "flip"}) {
            shown.edit(code);
        }
        int changes = 0;
        shown.document.changed.connect([&changes](const Change&) { ++changes; });
        shown.click(1);
        QCOMPARE(shown.document.position(), 1);
        QCOMPARE(changes, 1);
        shown.click(0);
        QCOMPARE(shown.document.level(), Level());
        QTest::keyClick(&shown.panel.list(), Qt::Key_End);
        QCOMPARE(shown.document.position(), 0); // one may look before one leaps
        QTest::keyClick(&shown.panel.list(), Qt::Key_Return);
        QCOMPARE(shown.document.position(), 4);
        QVERIFY(shown.isBold(4));
    }

    void anEntryCostsOneRowAndNoLookAtTheOthers() {
        HistoryShown shown;
        for (int i = 0; i < 500; ++i) {
            shown.edit("move");
        }
        const QSignalSpy inserted(&shown.panel.model(), &QAbstractItemModel::rowsInserted);
        const QSignalSpy removals(&shown.panel.model(), &QAbstractItemModel::rowsRemoved);
        const QSignalSpy resets(&shown.panel.model(), &QAbstractItemModel::modelReset);
        shown.edit("rotate");
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(inserted.front().at(1).toInt(), 501);
        QCOMPARE(inserted.front().at(2).toInt(), 501);
        QCOMPARE(removals.count() + resets.count(), 0);
    }

    void anEditAfterUndoTakesThePlaceOfWhatWasUndone() {
        HistoryShown shown;
        for (const LabelCode code : std::initializer_list<LabelCode>{"move", "rotate", "scale"}) {
            shown.edit(code);
        }
        shown.document.goTo(1);
        shown.edit("flip");
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json", "Move object", "Flip object"}));
    }

    void mergedEditsAreOneRow() {
        HistoryShown shown;
        shown.edit("move", "key");
        shown.edit("rotate", "key");
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json", "Rotate object"}));
        QVERIFY(shown.isBold(1));
        shown.now += std::chrono::seconds(5);
        shown.edit("rotate", "key");
        QCOMPARE(shown.panel.model().rowCount(), 3);
    }

    void theOldestAreForgottenAndSaidToBe() {
        HistoryShown shown;
        for (std::size_t i = 0; i < Document::maxEntries + 3; ++i) {
            shown.edit("move");
        }
        QCOMPARE(shown.panel.model().rowCount(), static_cast<int>(Document::maxEntries) + 1);
        QVERIFY(shown.row(0).data().toString().contains('3'));
        shown.document.reset({});
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json"}));
    }

    void outOfSightItCatchesUpLater() {
        HistoryShown shown;
        shown.edit("move");
        shown.panel.hide();
        shown.edit("rotate");
        shown.document.undo();
        shown.document.undo();
        shown.edit("scale");
        QCOMPARE(shown.texts().size(), 2);
        shown.panel.show();
        QCOMPARE(shown.texts(), (QStringList{"Opened cave.json", "Scale object"}));
        QVERIFY(shown.isBold(1));
    }

    void theStateThatWasSavedIsMarked() {
        HistoryShown shown;
        const auto marked = [&shown] {
            std::vector<int> rows;
            for (int i = 0; i < shown.panel.model().rowCount(); ++i) {
                if (!shown.row(i).data(Qt::ToolTipRole).toString().isEmpty()) {
                    rows.push_back(i);
                }
            }
            return rows;
        };
        shown.edit("move");
        QCOMPARE(marked(), std::vector<int>());
        shown.document.markSaved();
        shown.edit("rotate");
        shown.edit("scale");
        QCOMPARE(marked(), std::vector<int>{1});
        QVERIFY(shown.row(1).data(Qt::AccessibleDescriptionRole).toString().contains("saved"));
        QVERIFY(!shown.row(1).data(Qt::DecorationRole).value<QIcon>().isNull());
        QVERIFY(shown.row(2).data(Qt::DecorationRole).value<QIcon>().isNull());
        shown.document.goTo(0);
        shown.document.markSaved();
        QCOMPARE(marked(), std::vector<int>{0});
        shown.document.goTo(2);
        shown.document.markSaved();
        shown.document.undo();
        shown.edit("flip"); // what was saved cannot be come back to
        QCOMPARE(marked(), std::vector<int>());
        shown.document.reset({});
        QCOMPARE(marked(), std::vector<int>());
    }

    void theFirstStateIsMarkedWhenItCameFromAFile() {
        TestWindow test;
        test.window->openExample();
        QVERIFY(!test.document().savedPosition());
        test.toSave = test.file("cave.json");
        test.trigger(Act::SaveAs);
        QVERIFY(test.window->open(test.file("cave.json")));
        QCOMPARE(test.document().savedPosition(), std::optional(0));
    }

    void theWindowSaysWhatWasOpened() {
        TestWindow test;
        test.window->openExample();
        const QString example = test.window->history().model().index(0).data().toString();
        QVERIFY(!example.isEmpty());
        test.toSave = test.file("my cave.json");
        test.trigger(Act::SaveAs);
        QVERIFY(test.window->open(test.file("my cave.json")));
        QCOMPARE(test.window->history().model().index(0).data().toString(), QString("Opened my cave.json"));
    }
};

SPACETOW_TEST(HistoryPanelTest)
#include "history_panel_test.moc"
