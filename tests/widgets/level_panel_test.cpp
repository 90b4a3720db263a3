#include "editor/panels/level_panel.h"

#include "core/level/fields.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QAbstractButton>
#include <QDockWidget>

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

void typeInto(QWidget* editor, const QString& text) {
    editor->setFocus();
    qobject_cast<QLineEdit*>(editor)->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
}

} // namespace

class LevelPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void theLevelIsEditedWhateverIsSelected() {
        TestWindow test;
        Level level;
        level.objects.append(bodyWith(7, Circle{{0, 0}, 1}));
        test.document().reset(level);
        test.document().select(Selection({7}));
        test.trigger(Act::LevelProperties);
        QVERIFY(test.window->levelPanel().isVisible());
        typeInto(test.window->levelPanel().form().editor("gravity.y"), "-2*4");
        QCOMPARE(test.level().gravity.y(), -8.0);
        QCOMPARE(test.document().selection().keys(), std::vector<Key>{7});
        QCOMPARE(test.document().undoLabel().code.text(), std::string("change-level"));
        test.document().undo();
        QCOMPARE(test.level(), level);
    }

    void howTheShipFliesIsEditedHere() {
        TestWindow test;
        test.document().reset({});
        test.trigger(Act::LevelProperties);
        Form& form = test.window->levelPanel().form();
        typeInto(form.editor("thrust"), "4");
        typeInto(form.editor("steering"), "180");
        typeInto(form.editor("stiffness"), "20000");
        QCOMPARE(test.level().rules.thrust, 4.0);
        QCOMPARE(test.level().rules.steering, std::numbers::pi);
        QCOMPARE(test.level().rules.rope.stiffness, 20'000.0);
        qobject_cast<QAbstractButton*>(form.editor("sleeping"))->click();
        QVERIFY(!test.level().sleeping);
    }

    void everyFieldOfTheLevelHasAnEditor() {
        Document document;
        const LevelPanel panel(document, [](const Error&) { return QString(); });
        FieldSurvey survey;
        survey.add(document.level());
        for (const FieldSummary& field : survey.summaries()) {
            QVERIFY2(panel.form().editor(QString::fromStdString(field.id)) != nullptr, field.id.c_str());
        }
    }

    void theInspectorAndThePanelShowTheSame() {
        TestWindow test;
        test.document().reset({});
        test.trigger(Act::LevelProperties);
        typeInto(test.window->levelPanel().form().editor("author"), "Ann");
        QCOMPARE(qobject_cast<const QLineEdit*>(test.window->inspector().form().editor("author"))->text(),
                 QString("Ann"));
        typeInto(test.window->inspector().form().editor("lives"), "5");
        QCOMPARE(qobject_cast<const QLineEdit*>(test.window->levelPanel().form().editor("lives"))->text(),
                 QString("5"));
        QCOMPARE(test.level().rules.lives, 5);
    }
};

SPACETOW_TEST(LevelPanelTest)
#include "level_panel_test.moc"
