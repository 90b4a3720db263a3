#include "editor/panels/inspector.h"

#include "core/level/edits.h"
#include "editor/panels/number_field.h"
#include "tests/support/test_main.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

using namespace spacetow;

namespace {

Object circle(Key key, double x, double radius) {
    BodyObject body;
    body.shapes = {Circle{Vec2(0, 0), radius}};
    body.position = Vec2(x, 0);
    return {key, {}, body, {}};
}

Object wall(Key key, double depth) {
    BodyObject body;
    body.shapes = {EdgeChain{{Vec2(0, 0), Vec2(1, 0)}, false, depth}};
    return {key, {}, body, {}};
}

Level levelWith(std::vector<Object> objects) {
    Level level;
    for (Object& object : objects) {
        level.objects.append(std::move(object));
    }
    return level;
}

/// An inspector in sight, with these objects selected.
struct InspectorFixture {
    InspectorFixture(std::vector<Object> objects, std::vector<Key> selected)
        : document(levelWith(std::move(objects))), inspector(document) {
        document.select(Selection(std::move(selected)));
        inspector.resize(340, 900);
        inspector.show();
    }
    NumberField& number(const char* id) { return *qobject_cast<NumberField*>(inspector.form().editor(id)); }
    void type(const char* id, const QString& text) {
        NumberField& field = number(id);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text.isEmpty() ? QString() : text);
        if (text.isEmpty()) {
            QTest::keyClick(&field, Qt::Key_Delete);
        }
        QTest::keyClick(&field, Qt::Key_Return);
    }
    const BodyObject& body(int index) { return std::get<BodyObject>(document.level().objects[index].data); }

    Document document;
    Inspector inspector;
};

} // namespace

class InspectorTest : public QObject {
    Q_OBJECT

  private slots:
    void aNumberIsReadFromWhatIsTyped_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("fine");
        QTest::addColumn<double>("number");
        QTest::newRow("point") << "1.5" << true << 1.5;
        QTest::newRow("comma") << "1,5" << true << 1.5;
        QTest::newRow("minus sign") << QString(QChar(0x2212)) + "2" << true << -2.0;
        QTest::newRow("blanks") << "  3 " << true << 3.0;
        QTest::newRow("exponent") << "1e-3" << true << 0.001;
        QTest::newRow("word") << "abc" << false << 0.0;
        QTest::newRow("nothing") << "" << false << 0.0;
        QTest::newRow("infinite") << "inf" << false << 0.0;
        QTest::newRow("not a number") << "nan" << false << 0.0;
        QTest::newRow("too large") << "1e999" << false << 0.0;
    }
    void aNumberIsReadFromWhatIsTyped() {
        QFETCH(QString, text);
        QFETCH(bool, fine);
        QFETCH(double, number);
        const std::optional<double> read = NumberField::parsed(text);
        QCOMPARE(read.has_value(), fine);
        if (fine) {
            QCOMPARE(*read, number);
        }
    }

    void whatIsEnteredGoesToAllSelectedObjects() {
        InspectorFixture test({circle(1, 0, 0.5), circle(2, 3, 0.7), circle(3, 5, 0.9)}, {1, 2});
        QCOMPARE(test.number("radius").placeholderText(), QString("mixed"));
        QVERIFY(test.number("radius").text().isEmpty());
        test.type("radius", "0,25");
        QCOMPARE(std::get<Circle>(test.body(0).shapes[0]).radius, 0.25);
        QCOMPARE(std::get<Circle>(test.body(1).shapes[0]).radius, 0.25);
        QCOMPARE(std::get<Circle>(test.body(2).shapes[0]).radius, 0.9);
        QCOMPARE(test.document.position(), 1);
        test.document.undo();
        QCOMPARE(std::get<Circle>(test.body(1).shapes[0]).radius, 0.7);
        QVERIFY(test.number("radius").text().isEmpty());
    }

    void aNumberOutsideItsRangeChangesNothing_data() {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("text");
        QTest::newRow("no density") << QByteArray("density") << "0";
        QTest::newRow("negative density") << QByteArray("density") << "-1";
        QTest::newRow("restitution above one") << QByteArray("restitution") << "1.01";
        QTest::newRow("negative damping") << QByteArray("linearDamping") << "-0.1";
        QTest::newRow("words") << QByteArray("friction") << "rough";
        QTest::newRow("required") << QByteArray("friction") << "";
        QTest::newRow("far away") << QByteArray("position.x") << "1e7";
    }
    void aNumberOutsideItsRangeChangesNothing() {
        QFETCH(QByteArray, id);
        QFETCH(QString, text);
        InspectorFixture test({circle(1, 0, 0.5)}, {1});
        const Level before = test.document.level();
        test.type(id.constData(), text);
        QVERIFY(test.document.level() == before);
        QVERIFY(!test.document.canUndo());
    }

    void lookingAtANumberDoesNotRoundIt() {
        const double third = 1.0 / 3;
        InspectorFixture test({circle(1, third, 0.5)}, {1});
        NumberField& field = test.number("position.x");
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_End);
        QTest::keyClick(&field, Qt::Key_Return);
        field.clearFocus();
        QCOMPARE(test.body(0).position.x(), third);
        QVERIFY(!test.document.canUndo());
    }

    void arrowKeysStepAndMakeOneEntry() {
        InspectorFixture test({circle(1, 0, 0.5)}, {1});
        NumberField& field = test.number("density");
        field.setFocus();
        for (int i = 0; i < 5; ++i) {
            QTest::keyClick(&field, Qt::Key_Up);
        }
        QCOMPARE(test.body(0).density, 1.5);
        QCOMPARE(test.document.position(), 1);
        QTest::keyClick(&field, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(test.body(0).density, 0.5);
    }

    void anglesAreShownInDegrees() {
        InspectorFixture test({circle(1, 0, 0.5)}, {1});
        test.type("angle", "90");
        QVERIFY(std::abs(test.body(0).angle - 1.5707963267948966) < 1e-12);
        QCOMPARE(NumberField::parsed(test.number("angle").text()).value_or(0), 90.0);
    }

    void anEmptyDepthMeansNoBack() {
        InspectorFixture test({wall(1, 0.5)}, {1});
        QCOMPARE(test.number("depth").value().value_or(0), 0.5);
        test.type("depth", "");
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[0]).depth, noBack);
        QVERIFY(test.number("depth").text().isEmpty());
        test.type("depth", "0.2");
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[0]).depth, 0.2);
    }

    void anEmptyMassComesFromTheShapes() {
        InspectorFixture test({circle(1, 0, 0.5)}, {1});
        QVERIFY(!test.body(0).mass);
        test.type("mass", "2");
        QCOMPARE(test.body(0).mass.value_or(0), 2.0);
        test.type("mass", "");
        QVERIFY(!test.body(0).mass);
    }

    void onlySharedFieldsAreShown() {
        InspectorFixture test({circle(1, 0, 0.5), wall(2, noBack), {3, {}, ShipObject{}, {}}}, {1});
        const auto visible = [&test](const char* id) { return test.inspector.form().editor(id)->isVisible(); };
        QVERIFY(visible("radius") && !visible("depth") && visible("kind"));
        test.document.select(Selection({2}));
        QVERIFY(!visible("radius") && visible("depth") && visible("closed"));
        test.document.select(Selection({1, 2}));
        QVERIFY(!visible("radius") && !visible("depth") && visible("density"));
        test.document.select(Selection({1, 3}));
        QVERIFY(visible("position.x") && visible("angle") && !visible("kind"));
    }

    void switchesAndChoicesAreSetForAll() {
        InspectorFixture test({circle(1, 0, 0.5), circle(2, 1, 0.5)}, {1, 2});
        QTest::mouseClick(test.inspector.form().editor("frozen"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(test.body(0).frozen && test.body(1).frozen);
        auto* kind = qobject_cast<QComboBox*>(test.inspector.form().editor("kind"));
        kind->setFocus();
        QTest::keyClick(kind, Qt::Key_End);
        QVERIFY(test.body(0).kind == BodyKind::Dynamic || kind->currentIndex() == 2);
        kind->setCurrentIndex(2);
        Q_EMIT kind->activated(2);
        QVERIFY(test.body(0).kind == BodyKind::Dynamic && test.body(1).kind == BodyKind::Dynamic);
    }

    void gesturesShowTheirNumbersLive() {
        InspectorFixture test({circle(1, 0, 0.5)}, {1});
        const std::vector<Key> keys{1};
        test.document.preview(
            {std::make_shared<Level>(moved(test.document.level(), keys, Vec2(2.5, 0))), test.document.selection()});
        QCOMPARE(test.number("position.x").value().value_or(0), 2.5);
        test.document.dropPreview();
        QCOMPARE(test.number("position.x").value().value_or(1), 0.0);
    }

    void theLevelIsEditedWhenNothingIsSelected() {
        InspectorFixture test({circle(1, 0, 0.5)}, {});
        test.type("gravity.y", "-3.5");
        QCOMPARE(test.document.level().gravity.y(), -3.5);
        test.type("lives", "5");
        QCOMPARE(test.document.level().rules.lives, 5);
        test.type("lives", "2.5");
        QCOMPARE(test.document.level().rules.lives, 5);
        auto* name = qobject_cast<QLineEdit*>(test.inspector.form().editor("name"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, "Depths");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(test.document.level().name, std::string("Depths"));
    }

    void everyFieldOfEveryKindCanBeSetToWhatItIs() {
        std::vector<Object> objects{circle(1, 1, 0.5),
                                    wall(2, 0.5),
                                    {3, "s", ShipObject{}, {}},
                                    {4, "p", PayloadObject{}, {}},
                                    {5, "f", FinishObject{}, {}}};
        objects.push_back({6, "c", ConnectorObject{1, 2}, {}});
        for (Object object : objects) {
            const Object before = object;
            for (const FieldEntry& entry : fieldsOf(before)) {
                setField(object, entry.id, entry.value);
                QVERIFY2(object == before, entry.id.c_str());
            }
        }
        Level level;
        for (const FieldEntry& entry : fieldsOf(level)) {
            setField(level, entry.id, entry.value);
            QVERIFY2(level == Level(), entry.id.c_str());
        }
    }
};

SPACETOW_TEST(InspectorTest)
#include "inspector_test.moc"
