// The place that the status bar tells.
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QRegularExpression>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// "x 1.25 y -2.75 m"
QString told(const TestWindow& test) {
    QString place;
    for (const QLabel* label : test.window->statusLine().findChildren<QLabel*>()) {
        place = label->text().startsWith("x ") ? label->text().simplified() : place;
    }
    return place;
}

} // namespace

class PointedPlaceTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void itIsWhereAClickWouldPutAPoint() {
        TestWindow test;
        test.window->setSnap({});
        test.canvas().zoomTo(66);
        QTest::mouseMove(&test.canvas(), test.at(1.2, -2.76));
        const QString free = told(test);
        QVERIFY2(free != "x 1.25 y -2.75 m", qPrintable(free));
        test.trigger(ToolId::Edge);
        QCOMPARE(told(test), QString("x 1.25 y -2.75 m"));
        QTest::keyPress(&test.canvas(), Qt::Key_Control);
        QCOMPARE(told(test), free);
        QTest::keyRelease(&test.canvas(), Qt::Key_Control);
        QCOMPARE(told(test), QString("x 1.25 y -2.75 m"));
        test.click(1.2, -2.76);
        test.click(3.26, -2.74);
        QCOMPARE(told(test), QString("x 3.25 y -2.75 m"));
        test.key(Qt::Key_Return);
        const auto& wall = std::get<BodyObject>(test.level().objects[0].data);
        QVERIFY(wall.position + std::get<EdgeChain>(wall.shapes.front()).vertices.front() == Vec2(1.25, -2.75));
    }

    void itHasAsManyDecimalsAsTheZoomTellsApart() {
        TestWindow test;
        test.canvas().zoomTo(5000);
        QTest::mouseMove(&test.canvas(), QPoint(100, 100));
        QVERIFY2(QRegularExpression("^x -?\\d+\\.\\d{4} y -?\\d+\\.\\d{4} m$").match(told(test)).hasMatch(),
                 qPrintable(told(test)));
    }

    void itIsGoneWithThePointer() {
        TestWindow test;
        test.trigger(ToolId::Edge);
        for (const QPoint& place : {QPoint(100, 100), QPoint(130, 90)}) { // it may have been at one of them
            QTest::mouseMove(&test.canvas(), place);
        }
        QVERIFY(!told(test).isEmpty());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&test.canvas(), &leave);
        QCOMPARE(told(test), QString());
        test.trigger(ToolId::Line);
        QCOMPARE(told(test), QString());
    }
};

SPACETOW_TEST(PointedPlaceTest)
#include "pointed_place_test.moc"
