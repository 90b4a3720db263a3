// The menu of snapping, the markers on the canvas and what they are called.
#include "core/level/level.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/snap_painter.h"
#include "editor/window/messages.h"
#include "editor/window/preferences.h"
#include "tests/support/body_with.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QClipboard>
#include <QMenu>
#include <QPainter>
#include <QToolBar>
#include <QToolButton>

#include <array>
#include <utility>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr std::array kindSwitches{
    std::pair{Act::SnapVertices, &SnapSettings::vertices},
    std::pair{Act::SnapMidpoints, &SnapSettings::midpoints},
    std::pair{Act::SnapIntersections, &SnapSettings::intersections},
    std::pair{Act::SnapPerpendiculars, &SnapSettings::perpendiculars},
    std::pair{Act::SnapEdges, &SnapSettings::edges},
    std::pair{Act::SnapGuides, &SnapSettings::guides},
    std::pair{Act::SnapAlignment, &SnapSettings::alignment},
    std::pair{Act::SnapAngles, &SnapSettings::angles},
    std::pair{Act::SmartSnap, &SnapSettings::smart},
    std::pair{Act::Snap, &SnapSettings::grid},
};

constexpr std::array allKinds{SnapKind::Vertex,        SnapKind::Center, SnapKind::Intersection, SnapKind::Midpoint,
                              SnapKind::Perpendicular, SnapKind::Edge,   SnapKind::Guide,        SnapKind::Alignment,
                              SnapKind::Angle,         SnapKind::Grid,   SnapKind::Anchor};

/// Key 1, "Ramp", a line off the grid.
Level ramp() {
    Level level;
    Object object = bodyWith(1, LineChain{{{0, 0}, {3, 1}}}, {0.1, 0.1});
    object.name = "Ramp";
    level.objects.append(object);
    return level;
}

SnapLine line(Key key) {
    return {Vec2(0, 0), Vec2(0, 0), key};
}

QImage painted(const SnapAnswer& snap, const QString& name) {
    QImage image(200, 160, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::black);
    QPainter painter(&image);
    Viewport view;
    view.size = {200, 160};
    const Stage stage{painter, view, editingTheme()};
    LabelPainter labels(stage);
    paintSnap(stage, snap, name, labels);
    return image;
}

} // namespace

class SnappingTest : public QObject {
    Q_OBJECT

  private slots:
    void everySwitchIsAnActionAndIsRemembered() {
        TestWindow test;
        test.window->setSnap({});
        for (const auto& [act, on] : kindSwitches) {
            const QAction& action = test.window->actions()[act];
            QCOMPARE(action.isChecked(), test.window->toolbox().snap.*on);
            QVERIFY(!action.icon().isNull());
        }
        test.trigger(Act::SnapAngles);
        test.trigger(Act::SnapMidpoints);
        QVERIFY(test.window->toolbox().snap.angles && !test.window->toolbox().snap.midpoints);
        QVERIFY(test.window->files().preferences.snap() == test.window->toolbox().snap);
        test.trigger(Act::SmartSnap);
        QVERIFY(!test.window->actions()[Act::SnapAngles].isEnabled());
        const SnapSettings before = test.window->toolbox().snap;
        test.reopen();
        SnapSettings after = test.window->toolbox().snap;
        after.grid = before.grid; // off in windows of tests
        QVERIFY(after == before);
    }

    void theButtonOnTheBarOpensTheMenu() {
        TestWindow test;
        const auto* bar = test.window->findChild<QToolBar*>("main");
        const auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(&test.window->actions()[Act::SmartSnap]));
        QVERIFY(button != nullptr && button->menu() != nullptr);
        for (const auto& [act, on] : kindSwitches) {
            QVERIFY(button->menu()->actions().contains(&test.window->actions()[act]));
        }
    }

    void theGridGoesFromACentimetreToTenMetres() {
        TestWindow test;
        const auto step = [&] { return test.window->toolbox().snap.step; };
        for (int i = 0; i < 20; ++i) {
            test.trigger(Act::FinerGrid);
        }
        QCOMPARE(step(), 0.01);
        QVERIFY(!test.window->actions()[Act::FinerGrid].isEnabled());
        for (int i = 0; i < 20; ++i) {
            test.trigger(Act::CoarserGrid);
        }
        QCOMPARE(step(), 10.0);
        QVERIFY(!test.window->actions()[Act::CoarserGrid].isEnabled());
        for (const double usual : usualSteps()) {
            Q_EMIT test.window->statusLine().stepChosen(usual);
            QCOMPARE(step(), usual);
            QCOMPARE(test.window->files().preferences.snap().step, usual);
        }
    }

    void theGridIsDivided() {
        TestWindow test;
        test.window->setSnap({});
        Q_EMIT test.window->statusLine().stepChosen(1);
        QAction* four = nullptr;
        for (QAction* action : test.window->statusLine().divisionMenu().actions()) {
            four = action->data().toInt() == 4 ? action : four;
        }
        QVERIFY(four != nullptr);
        four->trigger();
        QVERIFY(four->isChecked());
        test.trigger(Act::SmartSnap);
        test.trigger(ToolId::Payload);
        test.click(2.3, 0.7);
        const auto& payload = std::get<PayloadObject>(test.level().objects[0].data);
        QCOMPARE(payload.position.x(), 2.25);
        QCOMPARE(payload.position.y(), 0.75);
    }

    void whatWasMeasuredIsCopied() {
        TestWindow test;
        test.document().reset(ramp());
        test.document().select(Selection({1}));
        test.key(Qt::Key_M);
        QVERIFY(test.window->toolbox().current() == ToolId::Measure);
        test.trigger(Act::Copy);
        QVERIFY(QApplication::clipboard()->text().contains("Ramp")); // nothing measured yet
        test.drag(-3, -1, -1, -1);
        QVERIFY(test.window->statusLine().hint().startsWith("2.00 m"));
        test.trigger(Act::Copy);
        QCOMPARE(QApplication::clipboard()->text(), QString::fromUtf8("2 m  Δx 2 m  Δy 0 m  0°\n"));
        test.trigger(Act::Cut);
        QVERIFY(QApplication::clipboard()->text().contains("Ramp"));
        test.key(Qt::Key_Escape);
        QVERIFY(test.window->toolbox().numbers().empty());
    }

    void theStatusBarNamesWhatIsSnappedTo() {
        TestWindow test;
        test.document().reset(ramp());
        test.trigger(ToolId::Polygon);
        QTest::mouseMove(&test.canvas(), test.at(3.1, 1.1));
        QVERIFY2(test.window->statusLine().hint().contains("vertex of Ramp"),
                 qPrintable(test.window->statusLine().hint()));
        QTest::mouseMove(&test.canvas(), test.at(-2, -2));
        QVERIFY(!test.window->statusLine().hint().contains("Ramp"));
    }

    void theCanvasShowsTheMarker() {
        TestWindow test;
        test.document().reset(ramp());
        test.trigger(ToolId::Line);
        QTest::mouseMove(&test.canvas(), test.at(-2, -2));
        const QPoint corner = test.at(3.1, 1.1);
        const QRect around(corner - QPoint(12, 12), QSize(140, 50));
        const QImage before = test.canvas().grab(around).toImage();
        QTest::mouseMove(&test.canvas(), corner);
        QVERIFY(test.canvas().grab(around).toImage() != before);
    }

    void eachKindHasAMarkerOfItsOwn() {
        for (const SnapKind kind : allKinds) {
            QVERIFY(!snapMarker(kind).isEmpty());
            QVERIFY(snapMarker(kind).boundingRect().width() <= 26);
            for (const SnapKind other : allKinds) {
                QCOMPARE(snapMarker(kind) == snapMarker(other), kind == other);
            }
        }
        QVERIFY(snapMarker(SnapKind::None).isEmpty());
    }

    void markerNameAndLinesArePainted() {
        const QImage marker = painted({.kind = SnapKind::Vertex}, QString());
        const QImage named = painted({.kind = SnapKind::Vertex}, QStringLiteral("vertex"));
        const QImage lined = painted({.kind = SnapKind::Vertex, .lines = {{Vec2(0, 0), Vec2(-1, 0), 1}}}, QString());
        QVERIFY(marker != painted({}, QString()));
        QVERIFY(named != marker);
        QVERIFY(lined != marker);
        QVERIFY(marker.pixelColor(105, 75) != marker.pixelColor(10, 10)); // a corner of the square
    }

    void labelsStayInsideTheView() {
        for (const Vec2& corner : {Vec2(-100, -100), Vec2(100, 100), Vec2(100, -100)}) {
            QImage image(200, 160, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::black);
            QPainter painter(&image);
            Viewport view;
            view.size = {200, 160};
            const Stage stage{painter, view, editingTheme()};
            LabelPainter(stage).paint(corner, QStringLiteral("two\nlines"));
            painter.end();
            int lit = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    lit += image.pixelColor(x, y).lightness() > 150 ? 1 : 0;
                }
            }
            QVERIFY2(lit > 40, qPrintable(QString::number(lit)));
        }
    }

    void labelsOfPointsNearEachOtherDoNotCoverEachOther() {
        QImage image(600, 400, QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        Viewport view;
        view.size = {600, 400};
        const Stage stage{painter, view, editingTheme()};
        for (const Vec2& corner : {Vec2(0, 0), Vec2(-100, -100), Vec2(100, 100)}) {
            LabelPainter labels(stage);
            for (int i = 0; i < 6; ++i) {
                labels.paint(corner + Vec2(0.02 * i, 0), QStringLiteral("\u0394x 0.34\n1.76 m"),
                             i % 2 == 0 ? LabelSide::Above : LabelSide::Below);
            }
            for (const QRectF& plate : labels.plates()) {
                QVERIFY(QRectF(image.rect()).contains(plate));
                QCOMPARE(std::ranges::count_if(labels.plates(), [&](const QRectF& x) { return x.intersects(plate); }),
                         1);
            }
        }
    }

    void everythingHasAName() {
        Level level = ramp();
        level.objects.append(bodyWith(2, Circle{{0, 0}, 1}, {5, 5}));
        level.guides.push_back({{0, 0}, 0, "Floor"});
        QCOMPARE(snapName(level, {.kind = SnapKind::Vertex, .key = 1}), QString("vertex of Ramp"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Center, .key = 2}), QString("center of Circle"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Midpoint}), QString("midpoint"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Guide, .guide = 0}), QString("guide Floor"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Intersection, .key = 1, .other = 2}),
                 QString("intersection with Ramp and Circle"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Alignment, .lines = {line(1), line(2)}}),
                 QString("in line with Ramp and Circle"));
        QCOMPARE(snapName(level, {.kind = SnapKind::Edge, .key = 1, .lines = {line(2)}}),
                 QString("edge of Ramp, in line with Circle"));
        for (const SnapKind kind : allKinds) {
            QVERIFY(!snapName(level, {.kind = kind}).isEmpty());
        }
    }
};

SPACETOW_TEST(SnappingTest)
#include "snapping_test.moc"
