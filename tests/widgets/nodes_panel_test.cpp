#include "editor/panels/nodes_panel.h"

#include "editor/panels/number_field.h"
#include "editor/window/messages.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Nodes = std::vector<NodeRef>;

Level drawing() {
    Level level;
    level.objects.append(bodyWith(1, EdgeChain{{{0, 0}, {2, 0}, {2, 2}}}, {1, 0.5}));
    level.objects.append(bodyWith(2, LineChain{{{0, 0}, {2, -2}}}));
    return level;
}

struct Shown {
    explicit Shown(std::vector<Key> keys) : document(drawing()), panel(document) {
        document.select(Selection(std::move(keys)));
        panel.show();
    }
    Document document;
    NodesPanel panel;

    QModelIndex at(int row, int column) const { return panel.model().index(row, column); }
    QString text(int row, int column) const { return at(row, column).data().toString(); }
    /// Opens the cell's editor and types into it; null when nothing is left open.
    NumberField* typeIn(int row, int column, const QString& text, Qt::Key end = Qt::Key_Return) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the editor from before
        panel.table().setCurrentIndex(at(row, column));
        panel.table().edit(at(row, column));
        auto* field = panel.table().findChild<NumberField*>();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, end);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return panel.table().findChild<NumberField*>();
    }
    QString fault() { return panel.findChild<FaultLabel*>()->text(); }
    Vec2 node(int vertex) { return *nodePosition(document.level(), {1, 0, vertex}); }
    bool type(int row, int column, const QString& text) {
        return panel.table().model()->setData(at(row, column), text);
    }
};

} // namespace

class NodesPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void itListsTheNodesOfWhatIsSelected() {
        Shown shown({1});
        QCOMPARE(shown.panel.model().rowCount(), 3);
        QCOMPARE(shown.text(2, NodesModel::X), QString("3"));
        QCOMPARE(shown.text(2, NodesModel::Y), QString("2.5"));
        shown.document.select(Selection({1, 2}));
        QCOMPARE(shown.panel.model().rowCount(), 5);
        shown.document.select({});
        QCOMPARE(shown.panel.model().rowCount(), 0);
    }
    void aTypedCoordinateMovesTheNodeToTheVeryPoint() {
        Shown shown({1});
        QVERIFY(shown.type(1, NodesModel::X, "1.23456789"));
        QCOMPARE(*nodePosition(shown.document.level(), {1, 0, 1}), Vec2(1.23456789, 0.5));
        QCOMPARE(shown.text(1, NodesModel::X), QString("1.23456789"));
        shown.document.undo();
        QCOMPARE(shown.document.level(), drawing());
        QCOMPARE(shown.text(1, NodesModel::X), QString("3"));
    }
    void whatIsNoNumberChangesNothing() {
        Shown shown({1});
        for (const char* text : {"", "x", "1e9", "nan"}) {
            QVERIFY2(!shown.type(1, NodesModel::X, text), text);
        }
        QVERIFY(shown.document.history().empty());
    }
    void expressionsAreTypedIntoTheCells() {
        Shown shown({1});
        QVERIFY(shown.typeIn(1, NodesModel::X, "+=0,5") == nullptr);
        QCOMPARE(shown.node(1), Vec2(3.5, 0.5));
        QVERIFY(shown.typeIn(1, NodesModel::Y, "2*50 cm") == nullptr);
        QCOMPARE(shown.node(1), Vec2(3.5, 1));
        QCOMPARE(shown.document.history().size(), std::size_t(2));
        shown.document.undo();
        QCOMPARE(shown.node(1), Vec2(3.5, 0.5));
    }
    void whatIsNoExpressionStaysInTheCellAndSaysWhyBeneath() {
        Shown shown({1});
        shown.panel.setWords([](const Error& error) { return sentence(error); });
        NumberField* field = shown.typeIn(1, NodesModel::X, "2*foo");
        QVERIFY(field != nullptr);
        QCOMPARE(field->text(), QString("2*foo"));
        QVERIFY(shown.fault().contains("foo"));
        QVERIFY(shown.document.history().empty());
        field->selectAll();
        QTest::keyClicks(field, "2*4");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(shown.node(1), Vec2(8, 0.5));
        QVERIFY(shown.fault().isEmpty());
        QVERIFY(shown.typeIn(1, NodesModel::X, "1e9", Qt::Key_Tab) != nullptr);
        QVERIFY(!shown.fault().isEmpty());
        QTest::keyClick(shown.panel.table().findChild<NumberField*>(), Qt::Key_Escape);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(shown.fault().isEmpty());
        QCOMPARE(shown.node(1), Vec2(8, 0.5));
    }
    void anOpenCellStepsWithTheArrowKeysAndIsUndoneAtOnce() {
        Shown shown({1});
        shown.panel.table().edit(shown.at(1, NodesModel::X));
        auto* field = shown.panel.table().findChild<NumberField*>();
        QTest::keyClick(field, Qt::Key_Up);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(shown.node(1), Vec2(3.1, 0.5));
        QCOMPARE(field->text(), QString("3.1"));
        shown.document.undo();
        QCOMPARE(shown.node(1), Vec2(3, 0.5));
    }
    void anEntryChangesAllSelectedRowsAsOneStep() {
        Shown shown({1});
        shown.document.select(Selection({1}, Nodes{{1, 0, 0}, {1, 0, 2}}));
        const auto enter = [&](int row, int column, const QString& text) {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            shown.panel.table().selectionModel()->setCurrentIndex(shown.at(row, column), QItemSelectionModel::NoUpdate);
            shown.panel.table().edit(shown.at(row, column));
            auto* field = shown.panel.table().findChild<NumberField*>();
            QCOMPARE(field->isMixed(), row == 2 && column == NodesModel::X);
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
        };
        enter(2, NodesModel::X, "+=0.5");
        QCOMPARE(shown.node(0), Vec2(1.5, 0.5));
        QCOMPARE(shown.node(1), Vec2(3, 0.5)); // not selected
        QCOMPARE(shown.node(2), Vec2(3.5, 2.5));
        QCOMPARE(shown.document.history(), (std::vector<Label>{{"move-nodes", 2}}));
        QCOMPARE(shown.document.selection().nodes().size(), std::size_t(2));
        enter(2, NodesModel::X, "1/4");
        QCOMPARE(shown.node(0), Vec2(0.25, 0.5));
        QCOMPARE(shown.node(2), Vec2(0.25, 2.5));
        enter(0, NodesModel::X, "*=3");
        QCOMPARE(shown.node(2), Vec2(0.75, 2.5));
        shown.document.undo();
        shown.document.undo();
        shown.document.undo();
        QCOMPARE(shown.document.level(), drawing());
    }
    void anEntryThatSendsOneOfThemOffTheMapChangesNone() {
        Shown shown({1});
        shown.document.select(Selection({1}, Nodes{{1, 0, 0}, {1, 0, 2}}));
        shown.panel.table().edit(shown.at(0, NodesModel::X));
        auto* field = shown.panel.table().findChild<NumberField*>();
        QTest::keyClicks(field, "+=999998"); // from 1 it would go
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!shown.fault().isEmpty());
        QVERIFY(shown.document.history().empty());
    }
    void aStepOfSeveralRowsMovesThemAlike() {
        Shown shown({1});
        shown.document.select(Selection({1}, Nodes{{1, 0, 0}, {1, 0, 2}}));
        shown.panel.table().edit(shown.at(2, NodesModel::X));
        auto* field = shown.panel.table().findChild<NumberField*>();
        QTest::keyClick(field, Qt::Key_Up);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(shown.node(0), Vec2(1.1, 0.5));
        QCOMPARE(shown.node(2), Vec2(3.1, 2.5));
        QCOMPARE(shown.document.history().size(), std::size_t(1));
    }
    void aDoubleClickOnOneOfSeveralRowsKeepsThemSelected() {
        Shown shown({1});
        shown.panel.resize(310, 300);
        shown.document.select(Selection({1}, Nodes{{1, 0, 0}, {1, 0, 2}}));
        QTableView& table = shown.panel.table();
        const QPoint cell = table.visualRect(shown.at(2, NodesModel::X)).center();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell);
        QCOMPARE(shown.document.selection().nodes(), (Nodes{{1, 0, 2}}));
        QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, cell);
        QCOMPARE(shown.document.selection().nodes(), (Nodes{{1, 0, 0}, {1, 0, 2}}));
        auto* field = table.findChild<NumberField*>();
        QVERIFY(field != nullptr);
        QVERIFY(field->isMixed());
        QTest::keyClicks(field, "4");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(shown.node(0), Vec2(4, 0.5));
    }
    void itsKeysAreNotTheWindowsAndTypingOpensACell() {
        Shown shown({1});
        QTableView& table = shown.panel.table();
        table.setCurrentIndex(shown.at(0, NodesModel::X));
        const std::initializer_list<std::pair<int, const char*>> keys{
            {Qt::Key_Home, ""}, {Qt::Key_End, ""}, {Qt::Key_PageUp, ""}, {Qt::Key_PageDown, ""},
            {Qt::Key_F2, ""},   {Qt::Key_7, "7"},  {Qt::Key_Plus, "+"}};
        for (const auto& [key, text] : keys) {
            QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::NoModifier, text);
            asked.ignore();
            QApplication::sendEvent(&table, &asked);
            QVERIFY2(asked.isAccepted(), qPrintable(QKeySequence(key).toString()));
        }
        QTest::keyClick(&table, Qt::Key_7);
        auto* field = table.findChild<NumberField*>();
        QVERIFY(field != nullptr);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(shown.node(0), Vec2(7, 0.5));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::keyClick(&table, Qt::Key_F2);
        QVERIFY(table.findChild<NumberField*>() != nullptr);
    }
    void selectedRowsAreTheSelectedNodesBothWays() {
        Shown shown({1});
        shown.panel.table().selectRow(1);
        QCOMPARE(shown.document.selection().nodes(), (Nodes{{1, 0, 1}}));
        shown.document.select(Selection({1}, Nodes{{1, 0, 0}, {1, 0, 2}}));
        const QModelIndexList rows = shown.panel.table().selectionModel()->selectedRows();
        QCOMPARE(rows.size(), 2);
        QVERIFY(shown.panel.table().selectionModel()->isRowSelected(2));
    }
    void rowsAreInsertedAndDeleted() {
        Shown shown({1});
        const auto buttons = shown.panel.findChildren<QToolButton*>();
        shown.panel.table().selectRow(0);
        buttons[0]->click();
        QCOMPARE(*nodePosition(shown.document.level(), {1, 0, 1}), Vec2(2, 0.5));
        QCOMPARE(shown.document.selection().nodes(), (Nodes{{1, 0, 1}}));
        buttons[1]->click();
        QCOMPARE(shown.document.level(), drawing());
        QVERIFY(shown.document.selection().nodes().empty());
    }
};

SPACETOW_TEST(NodesPanelTest)
#include "nodes_panel_test.moc"
