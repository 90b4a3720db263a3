#include "editor/canvas/palette.h"
#include "editor/canvas/theme.h"
#include "tests/support/color_vision.h"
#include "tests/support/test_main.h"

#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double readable = 4.5; // WCAG 2, AA, for text
constexpr double visible = 3;    // likewise, for lines and marks
constexpr double distinct = 20;  // ΔE

struct Named {
    QString name;
    QColor color;
};

/// Everything that is drawn over the level to say something.
std::vector<Named> marks(const Theme& theme) {
    return {{"hover", theme.hover},
            {"selection", theme.selection},
            {"collision", theme.collision},
            {"snap", theme.snap},
            {"guide", theme.guide},
            {"bounding box", theme.overlayBox},
            {"incircle", theme.overlayIncircle},
            {"velocity", theme.overlayVelocity},
            {"orientation", theme.overlayOrientation},
            {"normal", theme.overlayNormal},
            {"cell", theme.overlayCell}};
}

void bothShades() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

Shade shade() {
    QFETCH(bool, dark);
    return dark ? Shade::Dark : Shade::Light;
}

} // namespace

class ColorsTest : public QObject {
    Q_OBJECT

  private slots:
    void contrastAndDifferenceAreTheKnownOnes() {
        QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21) < 1e-9);
        QVERIFY(std::abs(contrast(QColor(119, 119, 119), Qt::white) - 4.478) < 0.01);
        QCOMPARE(difference(Qt::red, Qt::red), 0.0);
        QVERIFY(difference(Qt::black, Qt::white) > 99);
        // Told apart by most, but not by those without green cones.
        QVERIFY(difference(QColor(200, 100, 60), QColor(140, 128, 60)) < 12);
    }

    void panelsAreOfTheShadeTheySay_data() { bothShades(); }
    void panelsAreOfTheShadeTheySay() {
        QCOMPARE(shadeOf(panelPalette(shade())), shade());
        QCOMPARE(editingTheme(shade()).shade, shade());
        QCOMPARE(canvasTheme().shade, Shade::Dark); // space is
    }

    void everyTextOnPanelsIsReadable_data() { bothShades(); }
    void everyTextOnPanelsIsReadable() {
        const QPalette palette = panelPalette(shade());
        using Role = QPalette::ColorRole;
        const std::vector<std::pair<Role, std::vector<Role>>> grounds{
            {Role::WindowText, {Role::Window, Role::Midlight, Role::Button}},
            {Role::Text, {Role::Base, Role::AlternateBase, Role::Midlight, Role::Window}},
            {Role::ButtonText, {Role::Button, Role::Midlight, Role::Window, Role::Mid}},
            {Role::PlaceholderText, {Role::Base, Role::Window, Role::AlternateBase}},
            {Role::Link, {Role::Base, Role::Window}},
            {Role::LinkVisited, {Role::Base, Role::Window}},
            {Role::HighlightedText, {Role::Highlight}},
            {Role::ToolTipText, {Role::ToolTipBase}},
        };
        for (const auto& [text, on] : grounds) {
            for (const Role ground : on) {
                const double ratio = contrast(palette.color(text), palette.color(ground));
                QVERIFY2(ratio >= readable,
                         qPrintable(QStringLiteral("%1 on %2: %3").arg(text).arg(ground).arg(ratio)));
            }
        }
        const MarkColors colors = markColors(shade());
        for (const QColor& mark : {colors.error, colors.warning, colors.good}) {
            QVERIFY(contrast(mark, palette.color(Role::Window)) >= readable);
            QVERIFY(contrast(mark, palette.color(Role::Base)) >= readable);
        }
    }

    void hoverAndSelectionOnPanelsDiffer_data() { bothShades(); }
    void hoverAndSelectionOnPanelsDiffer() {
        const QPalette palette = panelPalette(shade());
        const QColor hover = palette.color(QPalette::Midlight);
        const QColor selection = palette.color(QPalette::Highlight);
        QVERIFY(difference(hover, selection) >= distinct);
        for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base}) {
            QVERIFY(difference(palette.color(ground), selection) >= distinct);
            QVERIFY(difference(palette.color(ground), hover) > 4); // a hint, not a shout
        }
    }

    void textOnTheCanvasIsReadable_data() { bothShades(); }
    void textOnTheCanvasIsReadable() {
        const Theme& theme = editingTheme(shade());
        for (const QColor& below : {theme.background, over(theme.background, theme.rock)}) {
            QVERIFY(contrast(theme.text, below) >= readable);
            QVERIFY(contrast(theme.text, over(below, theme.halo)) >= readable);
        }
    }

    void whatIsDrawnIsSeen_data() { bothShades(); }
    void whatIsDrawnIsSeen() {
        const Theme& theme = editingTheme(shade());
        const Shape shapes[] = {Circle{}, Polygon{}, Edge{}};
        for (const BodyKind kind : {BodyKind::Static, BodyKind::Dynamic, BodyKind::Kinematic}) {
            for (const Shape& shape : shapes) {
                QVERIFY(contrast(theme.body(kind, shape).line, theme.background) >= visible);
            }
        }
        for (const QColor& line :
             {theme.wall, theme.rim, theme.draft, theme.finish, theme.shipLine, theme.payloadLine, theme.band}) {
            QVERIFY(contrast(line, theme.background) >= visible);
        }
        for (const Named& mark : marks(theme)) {
            QVERIFY2(contrast(mark.color, theme.background) >= visible, qPrintable(mark.name));
        }
        // The wall stands out from its solid side, and that from the free one.
        QVERIFY(contrast(theme.wall, over(theme.background, theme.rock)) >= visible);
        QVERIFY(difference(over(theme.background, theme.rock), theme.background) > 8);
    }

    void marksAreToldApartWithAnyColorVision_data() { bothShades(); }
    void marksAreToldApartWithAnyColorVision() {
        const Theme& theme = editingTheme(shade());
        const std::vector<Named> all = marks(theme);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const double apart = difference(all[i].color, all[k].color);
                QVERIFY2(apart >= distinct,
                         qPrintable(QStringLiteral("%1, %2: %3").arg(all[i].name, all[k].name).arg(apart)));
            }
            const double fromWalls = difference(all[i].color, theme.wall);
            QVERIFY2(fromWalls >= distinct, qPrintable(QStringLiteral("%1: %2").arg(all[i].name).arg(fromWalls)));
            QCOMPARE(all[i].color.alpha(), 255); // else it would depend on what is below
        }
    }

    void majorGridLinesStandOutAndWallsStandOutFromThem_data() { bothShades(); }
    void majorGridLinesStandOutAndWallsStandOutFromThem() {
        const Theme& theme = editingTheme(shade());
        const QColor minor = over(theme.background, theme.gridMinor);
        const QColor major = over(theme.background, theme.gridMajor);
        QVERIFY(difference(minor, theme.background) > 2);
        QVERIFY(difference(major, theme.background) > difference(minor, theme.background) + 3);
        QVERIFY(contrast(theme.wall, major) >= visible);
    }

    void mixingGoesFromOneColorToTheOther() {
        QCOMPARE(mixed(Qt::black, Qt::white, 0), QColor(Qt::black));
        QCOMPARE(mixed(Qt::black, Qt::white, 1), QColor(Qt::white));
        QCOMPARE(mixed(QColor(0, 100, 200), QColor(200, 100, 0), 0.5).rgb(), QColor(100, 100, 100).rgb());
    }
};

SPACETOW_TEST(ColorsTest)
#include "colors_test.moc"
