#include "editor/panels/explain_panel.h"

#include "editor/window/messages.h"
#include "editor/window/messages_table.h"
#include "tests/support/test_main.h"

#include <QSignalSpy>

using namespace spacetow;

namespace {

Object explainedBall(Key key, const std::string& name, const Vec2& at, const Filter& filter = {}) {
    BodyObject made;
    made.kind = BodyKind::Dynamic;
    made.shapes = {Circle{{0, 0}, 0.5}};
    made.position = at;
    made.mass = 2;
    made.filter = filter;
    return {key, name, made, {}};
}

/// Two balls, the first on a floor; a spring from one to the other.
Level explainedLevel() {
    Level level;
    level.gravity = {0, -10};
    level.iterations = 4;
    BodyObject floor;
    floor.shapes = {EdgeChain{{{-10, 0}, {10, 0}}}};
    level.objects.append({1, "floor", floor, {}});
    level.objects.append(explainedBall(2, "low", {0, 0.5}));
    level.objects.append(explainedBall(3, "high", {5, 8}, {TagMask::bit(7), TagMask::bit(6)}));
    level.objects.append({4, "spring", ConnectorObject{.a = 2, .b = 3, .stiffness = 0.001, .bodiesCollide = true}, {}});
    return level;
}

struct ExplainFixture {
    explicit ExplainFixture(const Level& level)
        : document(level), panel(document, [](const Error& e) { return sentence(e); }) {
        panel.resize(300, 400);
        panel.show();
    }
    void run(int updates) {
        auto session = std::make_shared<Session>(document.level());
        for (int i = 0; i < updates; ++i) {
            session->step(Controls{});
        }
        panel.showSession(session);
        panel.refresh();
    }
    void select(const std::vector<Key>& keys) {
        document.select(Selection(keys));
        panel.refresh();
    }
    QTreeWidgetItem* row(const QString& title, const QString& what) {
        for (int i = 0; i < panel.rows().topLevelItemCount(); ++i) {
            QTreeWidgetItem* const head = panel.rows().topLevelItem(i);
            for (int k = 0; k < (head->text(0) == title ? head->childCount() : 0); ++k) {
                if (head->child(k)->text(0) == what) {
                    return head->child(k);
                }
            }
        }
        return nullptr;
    }
    QString value(const QString& title, const QString& what) {
        const QTreeWidgetItem* const found = row(title, what);
        return found == nullptr ? QStringLiteral("no such row") : QString(found->text(1)).replace(QChar(0x00a0), ' ');
    }

    Document document;
    ExplainPanel panel;
};

} // namespace

class ExplainPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void whatLiesIsHeldByTheFloor() {
        ExplainFixture test(explainedLevel());
        test.select({2});
        test.run(100);
        QCOMPARE(test.value("Forces", "Gravity"), QString("20 N ↓"));
        QVERIFY(test.value("Contacts", "floor").startsWith("20 N ↑") ||
                test.value("Contacts", "floor").startsWith("19.9"));
        QVERIFY(test.value("Motion", "Kinetic energy").endsWith(" J"));
        QCOMPARE(test.panel.explained(), Key(2));
    }

    void aClickOnAContactLeadsToTheOther() {
        ExplainFixture test(explainedLevel());
        test.select({2});
        test.run(10);
        QSignalSpy wanted(&test.panel, &ExplainPanel::objectWanted);
        QTreeWidgetItem* const row = test.row("Contacts", "floor");
        QVERIFY(row != nullptr);
        QTest::mouseClick(test.panel.rows().viewport(), Qt::LeftButton, {},
                          test.panel.rows().visualItemRect(row).center());
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted[0][0].value<Key>(), Key(1));
    }

    void atTheStartThereIsGravityAndNoContact() {
        ExplainFixture test(explainedLevel());
        test.select({3});
        test.run(0);
        QCOMPARE(test.value("Forces", "Gravity"), QString("20 N ↓"));
        QVERIFY(test.row("Contacts", "None") != nullptr);
    }

    void aConnectorTellsItsPull() {
        ExplainFixture test(explainedLevel());
        test.select({4});
        test.run(5);
        QVERIFY(test.row("Pull", "Natural length") != nullptr);
        QVERIFY(test.row("Between", "high") != nullptr);
    }

    void withNothingSelectedItTellsTheTotals() {
        ExplainFixture test(explainedLevel());
        test.run(5);
        QVERIFY(test.row("All bodies", "Total energy") != nullptr);
        QCOMPARE(test.panel.explained(), Key(0));
        test.panel.showSession(nullptr);
        test.panel.refresh();
        QCOMPARE(test.panel.rows().topLevelItemCount(), 0);
    }

    void whyTwoDoNotCollideIsASentenceWithACure() {
        ExplainFixture test(explainedLevel());
        test.run(5);
        test.select({2, 3});
        QVERIFY2(test.panel.answer().text().contains("does not touch what"), qPrintable(test.panel.answer().text()));
        QVERIFY(test.panel.cure().isVisible());
        QVERIFY(!test.panel.rows().isVisible()); // there is nothing in them
        QVERIFY(test.panel.answer().geometry().bottom() < test.panel.height() / 2);
        test.panel.cure().click();
        QVERIFY(test.document.canUndo());
        test.run(5);
        test.panel.cure().click(); // the other way round
        test.run(5);
        QVERIFY2(test.panel.answer().text().contains("apart"), qPrintable(test.panel.answer().text()));
        QVERIFY(!test.panel.cure().isVisible());
        test.document.undo();
        test.document.undo();
        QVERIFY(test.document.level() == explainedLevel());
    }

    void everyAnswerAndEveryCureIsASentence() {
        const Level level = explainedLevel();
        std::set<Code> codes;
        for (int why = 0; why <= static_cast<int>(WhyApart::NextUpdate); ++why) {
            for (int variant = 0; variant < 8; ++variant) {
                ApartObjects apart{2, 3, (variant & 1) != 0, Key((variant & 2) != 0 ? 4 : 0), {}};
                apart.answer.why = static_cast<WhyApart>(why);
                apart.answer.missing = {(variant & 4) != 0 ? 0U : 2U};
                apart.answer.bothMasks = apart.answer.sensed = (variant & 2) != 0;
                codes.insert(apartCode(level, apart).code);
                const QString text = sentence(apartCode(level, apart));
                QVERIFY2(text.endsWith('.') && !text.contains('%'), qPrintable(text));
            }
        }
        for (const CollisionCure::Kind kind : {CollisionCure::Kind::TickTag, CollisionCure::Kind::GiveTag,
                                               CollisionCure::Kind::MakeSolid, CollisionCure::Kind::LetCollide}) {
            codes.insert(cureCode(level, {kind, 4, 3}).code);
        }
        for (const MessageText& text : explainTexts()) {
            QVERIFY2(codes.erase(text.code) == 1, text.code.text().data()); // none without use
        }
        QVERIFY(codes.empty()); // nor one without a text
    }

    void directionsAreArrows() {
        QCOMPARE(vectorText({3, 4}, "N").replace(QChar(0x00a0), ' '), QString("5 N ↗"));
        QCOMPARE(vectorText({-1, 0}, "N").replace(QChar(0x00a0), ' '), QString("1 N ←"));
        QCOMPARE(vectorText({0, -1}, "N").replace(QChar(0x00a0), ' '), QString("1 N ↓"));
        QCOMPARE(vectorText({0, 0}, "N").replace(QChar(0x00a0), ' '), QString("0 N"));
    }
};

SPACETOW_TEST(ExplainPanelTest)
#include "explain_panel_test.moc"
