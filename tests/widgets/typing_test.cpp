// What is typed and pasted in the window, as far as more than one part of it is concerned.
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QLineEdit>

using namespace spacetow;
using namespace spacetow::test;

class TypingTest : public QObject {
    Q_OBJECT

  private slots:
    void undoAfterEnterTakesBackTheEditAndNotTheText() {
        TestWindow test;
        test.document().reset(Level());
        for (const char* id : {"gravity.y", "author"}) {
            auto* field = qobject_cast<QLineEdit*>(test.window->inspector().form().editor(id));
            const Level before = test.level();
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, "-3");
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY(!(test.level() == before));
            QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(test.level() == before);
            test.canvas().setFocus();
            QVERIFY(test.level() == before);
            QVERIFY(!test.document().canUndo());
        }
    }

    void undoWhileTypingIsOfTheText() {
        TestWindow test;
        test.document().reset(Level());
        auto* field = qobject_cast<QLineEdit*>(test.window->inspector().form().editor("gravity.y"));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "-3");
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(field->text() != "-3");
        QVERIFY(!test.document().canUndo() && !test.document().canRedo());
    }

    void tagsThatComeAlongWithAPasteAreTold() {
        TestWindow from;
        Level level;
        level.tags.set(9, {"lava", 0xff0000});
        BodyObject body;
        body.shapes = {Circle{}};
        body.filter.tags = TagMask::bit(9);
        level.objects.append({1, "", body, {}});
        from.document().reset(level);
        from.trigger(Act::SelectAll);
        from.trigger(Act::Copy);
        TestWindow to;
        to.document().reset(Level());
        to.trigger(Act::PasteInPlace);
        QCOMPARE(to.level().objects.size(), 1);
        const std::optional<int> lava = to.level().tags.indexOf("lava");
        QVERIFY(lava.has_value());
        QVERIFY(std::get<BodyObject>(to.level().objects[0].data).filter.tags == TagMask::bit(*lava));
        QVERIFY(to.window->messageBar().isVisible());
        QVERIFY(to.window->messageBar().text().contains("lava"));
    }
};

SPACETOW_TEST(TypingTest)
#include "typing_test.moc"
