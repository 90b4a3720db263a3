#include "editor/panels/nodes_panel.h"

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
