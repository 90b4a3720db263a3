// The form of the inspector: rows for everything, sections, defaults, faults, and how long it takes.
#include "core/level/edits.h"
#include "tests/support/cpu_time.h"
#include "tests/support/inspector_fixture.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QAbstractButton>
#include <QAction>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

class EventCount : public QObject {
  public:
    EventCount(QWidget& widget, QEvent::Type type) : m_type(type) { widget.installEventFilter(this); }
    int count = 0;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        count += event->type() == m_type ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }

  private:
    QEvent::Type m_type;
};

} // namespace

class InspectorFormTest : public QObject {
    Q_OBJECT

  private slots:
    void aNumberThatChangesLaysNothingElseOutAnew() {
        InspectorFixture test({circleObject(1, 1, 0.5)}, {1});
        const auto drag = [&test](double by) {
            const Level& level = *test.document.current().level;
            test.document.preview({std::make_shared<const Level>(moved(level, std::array{Key{1}}, Vec2(by, 0))),
                                   test.document.selection()});
            QApplication::processEvents();
        };
        EventCount layouts(*test.number("angle").parentWidget(), QEvent::LayoutRequest);
        EventCount paints(test.number("angle"), QEvent::Paint);
        for (int i = 1; i < 10; ++i) {
            drag(0.25 * i);
        }
        QCOMPARE(test.number("position.x").value(), std::optional(3.25));
        // Once, whenever that is, what is no longer as it was picked up may be laid out.
        QVERIFY2(layouts.count <= 1, QByteArray::number(layouts.count));
        QVERIFY2(paints.count <= 1, QByteArray::number(paints.count));
    }
    void everyFieldKeepsItsOwnTextInEveryLocale_data() {
        QTest::addColumn<QString>("locale");
        for (const char* name : {"fa_IR", "ar_EG", "sv_SE", "de_DE", "fr_FR", "ne_NP", "my_MM", "he_IL", "en_US"}) {
            QTest::newRow(name) << name;
        }
    }
    void everyFieldKeepsItsOwnTextInEveryLocale() {
        QFETCH(QString, locale);
        const auto back = qScopeGuard([] { QLocale::setDefault(QLocale::c()); });
        QLocale::setDefault(QLocale(locale));
        const Level level = populatedLevel();
        std::vector<Object> objects;
        std::vector<Selection> selections{Selection()};
        for (const Object& object : level.objects) {
            objects.push_back(object);
            selections.push_back(Selection({object.key}));
        }
        InspectorFixture test(objects, {});
        int fields = 0;
        for (const Selection& selection : selections) {
            test.document.select(selection);
            for (NumberField* field : test.inspector.form().findChildren<NumberField*>()) {
                field->setFocus();
                const QString shown = field->text();
                if (!field->isVisible() || shown.isEmpty()) {
                    continue;
                }
                ++fields;
                field->selectAll();
                field->insert(shown);
                field->setModified(true);
                QTest::keyClick(field, Qt::Key_Return);
                QVERIFY2(field->fault().isEmpty(), qPrintable(shown + ": " + field->fault()));
                QVERIFY2(!test.document.canUndo(), qPrintable(field->objectName() + ": " + shown));
            }
        }
        QVERIFY(fields > 50);
    }

    void everyFieldOfTheLevelAndOfEveryKindHasARow() {
        std::set<std::string> rows;
        for (const FormRow& row : objectRows()) {
            rows.insert(row.id);
        }
        FieldSurvey objects;
        const Level level = populatedLevel();
        for (const Object& object : level.objects) {
            objects.add(object);
        }
        for (const FieldSummary& field : objects.summaries()) {
            QVERIFY2(rows.erase(field.id) == 1, field.id.c_str());
        }
        QVERIFY(rows.erase("width") == 1 && rows.erase("height") == 1); // which are worked out, see rectangles.h
        QVERIFY2(rows.empty(), rows.empty() ? "" : rows.begin()->c_str());
        for (const FormRow& row : levelRows()) {
            rows.insert(row.id);
        }
        FieldSurvey ofLevel;
        ofLevel.add(level);
        for (const FieldSummary& field : ofLevel.summaries()) {
            QVERIFY2(rows.erase(field.id) == 1, field.id.c_str());
        }
        QVERIFY2(rows.empty(), rows.empty() ? "" : rows.begin()->c_str());
    }

    void everyRowShowsWhatEveryObjectHas() {
        const Level level = populatedLevel();
        Document document(level);
        Inspector inspector(document, [](const Error& error) { return sentence(error); });
        inspector.show();
        for (const Object& object : level.objects) {
            document.select(Selection({object.key}));
            FieldSurvey survey;
            survey.add(object);
            for (const FieldSummary& field : survey.summaries()) {
                QWidget* editor = inspector.form().editor(QString::fromStdString(field.id));
                QVERIFY2(editor != nullptr && editor->isVisibleTo(&inspector), field.id.c_str());
                const double* number = std::get_if<double>(&field.value);
                if (const auto* line = qobject_cast<NumberField*>(editor); number != nullptr && !field.isMixed) {
                    QCOMPARE(storedNumber(line->value().value(), field.field.unit), *number);
                }
            }
        }
    }

    void anUnnamedObjectIsCalledByKindAndPlace() {
        InspectorFixture test({circleObject(1, 1.5, 0.5), wallObject(2, noBack)}, {1});
        QCOMPARE(test.inspector.title(), QString("Circle"));
        QVERIFY(test.inspector.findChildren<QLabel*>().size() > 2);
        const auto says = [&test](const QString& text) {
            for (const QLabel* label : test.inspector.findChildren<QLabel*>()) {
                if (label->isVisible() && label->text() == text) {
                    return true;
                }
            }
            return false;
        };
        QVERIFY(says("Circle at 1.5; 0"));
        test.document.select(Selection({1, 2}));
        QVERIFY(says("2 objects") && says("1 × One-way wall, 1 × Circle"));
    }

    void whatDiffersFromItsDefaultIsPutBackInOneStep() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 1, 0.5)}, {1, 2});
        QAbstractButton* reset = test.inspector.form().resetButton("density");
        QVERIFY(!reset->isVisible());
        QVERIFY(!test.inspector.form().resetButton("radius")->isVisible());
        test.type("density", "2");
        QVERIFY(reset->isVisible());
        test.type("velocity.x", "1");
        test.type("velocity.y", "2");
        reset->click();
        QCOMPARE(test.body(0).density, 1.0);
        QCOMPARE(test.body(1).density, 1.0);
        QVERIFY(!reset->isVisible());
        const int before = test.document.position();
        QVERIFY(test.inspector.form().resetButton("velocity.y")->isVisible());
        test.inspector.form().resetButton("velocity.y")->click();
        QCOMPARE(test.body(1).velocity, Vec2(0, 0));
        QCOMPARE(test.document.position(), before + 1);
        test.document.undo();
        QCOMPARE(test.body(0).velocity, Vec2(1, 2));
    }

    void aRelativeEntryThatLeavesTheRangeOfOneChangesNone() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 1, 0.5)}, {1});
        test.type("restitution", "0.75");
        test.document.select(Selection({1, 2}));
        const Level before = test.document.level();
        test.type("restitution", "+=0.5");
        QVERIFY(test.document.level() == before);
        QLabel* fault = test.inspector.form().faultLabel("restitution");
        QVERIFY(fault->isVisible());
        QCOMPARE(fault->text(), test.number("restitution").fault());
        QCOMPARE(test.number("restitution").text(), QString("+=0.5"));
        test.document.select(Selection({1}));
        QVERIFY(!fault->isVisible());
        QCOMPARE(test.number("restitution").value(), std::optional(0.75));
    }

    void draggingALabelIsOneStepAndIsSeenAtOnce() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 1, 0.5)}, {1, 2});
        NumberField& field = test.number("angle");
        field.setFocus();
        field.beginScrub();
        field.scrub(5, {});
        field.scrub(10, {});
        QVERIFY(test.document.hasPreview());
        QVERIFY(std::abs(test.body(0).angle - 10 * std::numbers::pi / 180) < 1e-12);
        QCOMPARE(field.value(), std::optional(10.0));
        QVERIFY(!test.document.canUndo());
        field.endScrub(true);
        QCOMPARE(test.document.position(), 1);
        QVERIFY(!test.document.hasPreview());
        field.beginScrub();
        field.scrub(100, {});
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.value(), std::optional(10.0));
        QCOMPARE(test.document.position(), 1);
        test.document.undo();
        QCOMPARE(test.body(1).angle, 0.0);
    }

    void anglesTypedInDegreesAreShownAsTyped() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        for (const char* text : {"15", "33.3", "-120", "0.1", "57.29577951308232"}) {
            test.type("angle", text);
            test.number("angle").clearFocus();
            test.number("angle").setFocus();
            QCOMPARE(test.number("angle").text(), QString(text));
        }
        test.type("angle", "1 rad");
        QCOMPARE(test.body(0).angle, 1.0);
        QTest::keyClick(&test.number("angle"), Qt::Key_Up);
        QTest::keyClick(&test.number("angle"), Qt::Key_Down);
        QVERIFY(test.body(0).angle == 1.0);
    }

    void sectionsStayFoldedAndScrolledFromOneObjectToTheNext() {
        InspectorFixture test({circleObject(1, 0, 0.5), wallObject(2, 0.5), {3, {}, ShipObject{}, {}}}, {1});
        test.inspector.resize(340, 300);
        QAbstractButton* motion = test.inspector.form().sectionHeader("Motion");
        motion->click();
        QVERIFY(!test.isSeen("linearDamping") && motion->isVisible());
        QScrollBar* bar = test.inspector.page().verticalScrollBar();
        QCoreApplication::processEvents();
        QVERIFY(bar->maximum() > 150);
        bar->setValue(150);
        test.document.select(Selection({3})); // which has little to show
        QCoreApplication::processEvents();
        test.document.select(Selection({2}));
        QCoreApplication::processEvents();
        QVERIFY(!test.isSeen("linearDamping"));
        QCOMPARE(bar->value(), 150);
        Document other(test.document.level());
        other.select(Selection({1}));
        Inspector next(other, {});
        next.foldSections(test.inspector.foldedSections());
        next.show();
        QVERIFY(!next.form().editor("linearDamping")->isVisible());
        QVERIFY(next.form().editor("density")->isVisible());
    }

    void aBodyOfAConnectorIsNamedByNameOrKey() {
        Object named = circleObject(0x10, 0, 0.5);
        named.name = "crate";
        ConnectorObject connector;
        connector.a = 0x10;
        connector.b = 0x11;
        InspectorFixture test(
            {named, circleObject(0x11, 1, 0.5), circleObject(0x12, 2, 0.5), {0x13, {}, connector, {}}}, {0x13});
        auto* a = qobject_cast<QLineEdit*>(test.inspector.form().editor("a"));
        auto* b = qobject_cast<QLineEdit*>(test.inspector.form().editor("b"));
        QCOMPARE(a->text(), QString("crate"));
        QCOMPARE(b->text(), QString("Circle at 1; 0"));
        QVERIFY(b->toolTip().contains("00000011"));
        b->setFocus();
        b->selectAll();
        QTest::keyClicks(b, "00000012");
        QTest::keyClick(b, Qt::Key_Return);
        QCOMPARE(std::get<ConnectorObject>(test.document.level().objects[3].data).b, Key(0x12));
        QCOMPARE(b->text(), QString("Circle at 2; 0"));
        b->selectAll();
        QTest::keyClicks(b, "Circle at 1; 0");
        QTest::keyClick(b, Qt::Key_Return);
        QCOMPARE(std::get<ConnectorObject>(test.document.level().objects[3].data).b, Key(0x11));
        b->clearFocus();
        b->setFocus();
        QCompleter& choice = *b->completer();
        QCOMPARE(choice.completionCount(), 3); // with nothing typed, all that suit
        Q_EMIT choice.activated(QString("Circle at 2; 0"));
        QCOMPARE(std::get<ConnectorObject>(test.document.level().objects[3].data).b, Key(0x12));
        const QSignalSpy wanted(&test.inspector, &Inspector::objectWanted);
        b->actions().back()->trigger();
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().value<Key>(), Key(0x12));
        b->selectAll();
        QTest::keyClicks(b, "nobody");
        QTest::keyClick(b, Qt::Key_Return);
        QVERIFY(test.inspector.form().faultLabel("b")->isVisible());
        QCOMPARE(b->text(), QString("nobody"));
        QCOMPARE(std::get<ConnectorObject>(test.document.level().objects[3].data).b, Key(0x12));
    }

    void inANarrowPanelLabelsStandAboveTheirFields() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        const int wide = test.inspector.sizeHint().width();
        const int narrow = test.inspector.minimumSizeHint().width();
        QVERIFY2(narrow < 0.8 * wide, qPrintable(QString("%1 of %2").arg(narrow).arg(wide)));
        for (const int width : {narrow, wide, narrow}) {
            test.inspector.resize(width, 900);
            QApplication::processEvents();
            const QWidget* field = test.inspector.form().editor("position.x");
            const auto labels = test.inspector.form().findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
            const auto label = std::ranges::find(labels, field, &QLabel::buddy);
            QVERIFY(label != labels.end());
            QCOMPARE((*label)->geometry().bottom() < field->geometry().top(), width == narrow);
            for (const char* id : {"name", "kind", "position.x", "position.y", "locked", "density"}) {
                const QWidget* editor = test.inspector.form().editor(id);
                QVERIFY2(editor->geometry().right() < test.inspector.form().width(), id);
                QVERIFY2(editor->width() >= editor->minimumSizeHint().width(), id);
            }
            QCOMPARE(cutOffTexts(test.inspector), QStringList());
        }
    }

    void aHundredThousandSelectedObjectsAreShownWithoutAPause() {
        constexpr int count = 100'000;
        std::vector<Object> objects;
        std::vector<Key> keys;
        for (int i = 1; i <= count; ++i) {
            objects.push_back(circleObject(static_cast<Key>(i), i, 0.5));
            keys.push_back(static_cast<Key>(i));
        }
        InspectorFixture test(std::move(objects), {1});
        const CpuTimer selecting;
        test.document.select(Selection(keys));
        const double selected = selecting.seconds();
        QCOMPARE(test.number("radius").value(), std::optional(0.5));
        QVERIFY(test.number("position.x").isMixed());
        QVERIFY2(selected < 0.25, qPrintable(QString("selecting took %1 s").arg(selected)));
        const auto moved = std::make_shared<Level>(spacetow::moved(test.document.level(), keys, Vec2(2.5, 0)));
        const CpuTimer dragging;
        test.document.preview({moved, test.document.selection()});
        const double dragged = dragging.seconds();
        QVERIFY(test.number("position.x").isMixed());
        QVERIFY2(dragged < 0.05, qPrintable(QString("a frame of a drag took %1 s").arg(dragged)));
    }
};

SPACETOW_TEST(InspectorFormTest)
#include "inspector_form_test.moc"
