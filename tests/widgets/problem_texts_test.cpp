// What the panel of problems says names what it speaks of.
#include "editor/window/messages.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QListView>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

QStringList textsOf(TestWindow& test, const Level& level) {
    test.document().reset(level);
    test.window->problems().check();
    const auto* list = test.window->problems().findChild<QListView*>();
    QStringList texts;
    for (int row = 0; row < list->model()->rowCount(); ++row) {
        texts << list->model()->index(row, 0).data().toString();
    }
    return texts;
}

} // namespace

class ProblemTextsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsHiddenIsNamed() {
        Level level;
        Object ship{1, "", ShipObject{}, {}};
        ship.visible = false;
        level.objects.append(ship);
        Object payload{2, "", PayloadObject{{0, 1}}, {}};
        payload.visible = false;
        level.objects.append(payload);
        TestWindow test;
        const QStringList texts = textsOf(test, level);
        for (const char* name : {"Ship", "Payload"}) {
            const QString wanted = QString("%1: It is hidden in the editor, but takes part in the game.").arg(name);
            QVERIFY2(texts.contains(wanted), qPrintable(texts.join('\n')));
        }
    }

    void aConnectorBetweenAMovingAndAFixedBodySaysThatItCannotMoveThem() {
        Level level;
        level.objects.append({1, "", BodyObject{.shapes = {Circle{{0, 0}, 0.5}}}, {}});
        level.objects.append(
            {2, "", BodyObject{.kind = BodyKind::Kinematic, .shapes = {Circle{{3, 0}, 0.5}}, .velocity = {1, 0}}, {}});
        ConnectorObject connector;
        connector.a = 1;
        connector.b = 2;
        level.objects.append({3, "", connector, {}});
        TestWindow test;
        const QString texts = textsOf(test, level).join('\n');
        QVERIFY2(texts.contains("Neither of the two bodies can be moved by the connector"), qPrintable(texts));
    }
};

SPACETOW_TEST(ProblemTextsTest)
#include "problem_texts_test.moc"
