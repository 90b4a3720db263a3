// Import and export through the window: bars, files, messages.
#include "editor/window/exchange.h"

#include "core/geometry/polygon.h"
#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const foreignPicture =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"200\">\n"
    "  <g id=\"Rocks\"><rect id=\"box\" x=\"100\" y=\"50\" width=\"200\" height=\"100\"/></g>\n"
    "  <path id=\"bend\" d=\"M0 100Q200 -100 400 100\" fill=\"none\" stroke=\"black\"/>\n"
    "  <text>left out</text>\n"
    "</svg>";

struct Importing : TestWindow {
    explicit Importing(const QByteArray& content = foreignPicture, const char* name = "rocks.svg") {
        QFile out(file(name));
        out.open(QIODevice::WriteOnly);
        out.write(content);
        path = out.fileName();
        window->exchange().questions.whichToImport = [this](const QString&) { return path; };
    }
    ImportBar& bar() { return window->exchange().importBar(); }
    void begin() {
        trigger(Act::Import);
        bar().finishWork();
    }
    NumberField& field(int index) { return *bar().findChildren<NumberField*>().at(index); }
    void enter(int index, double value) {
        field(index).setValue(value);
        Q_EMIT field(index).entered(value);
        bar().finishWork();
    }
    QString message() { return window->messageBar().text(); }

    QString path;
};

enum Fields { ScaleField, ToleranceField };

std::size_t verticesOfBend(const Level& level) {
    for (const Object& object : level.objects) {
        if (object.name == "bend") {
            const LevelShape& shape = std::get<BodyObject>(object.data).shapes.front();
            const auto* const lines = std::get_if<LineChain>(&shape);
            return lines != nullptr ? lines->vertices.size() : std::get<EdgeChain>(shape).vertices.size();
        }
    }
    return 0;
}

QByteArray written(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

struct Exporting : TestWindow {
    Exporting() {
        window->exchange().questions.whereToExport = [this](const QString& wish) {
            wished = wish;
            return file(target);
        };
        document().commit({"import", 1}, {std::make_shared<const Level>(triangle()), Selection()});
    }
    static Level triangle() {
        Level level;
        BodyObject body;
        body.shapes = {Polygon{{{0, 0}, {4, 0}, {4, 2}, {0, 3}}}};
        body.position = {1, 1};
        level.objects.append({7, "rock", body, {}});
        return level;
    }
    ExportBar& bar() { return window->exchange().exportBar(); }
    void write() {
        bar().apply();
        window->exchange().finishWork();
    }
    QString target = QStringLiteral("out.png");
    QString wished;
};

} // namespace

class ExchangeTest : public QObject {
    Q_OBJECT

  private slots:
    void theNameOfAFileIsNoMarkup() {
        Importing test(foreignPicture, "<b>rocks.svg");
        test.begin();
        for (const QLabel* label : test.bar().findChildren<QLabel*>()) {
            QVERIFY2(!label->toolTip().contains("<b>rocks"), qPrintable(label->toolTip()));
        }
    }

    void whatWouldComeIsShownAndEnterMakesItOneEntry() {
        Importing test;
        const Level empty = test.level();
        test.begin();
        QVERIFY(test.bar().isVisible() && test.document().hasPreview());
        QCOMPARE(test.level().objects.size(), 3); // a layer, a box, a bend
        QVERIFY(*test.document().current().level == empty);
        QVERIFY2(test.bar().summary().startsWith("2 objects"), qPrintable(test.bar().summary()));
        QCOMPARE(test.bar().report().size(), 1);
        QTest::keyClick(&test.field(ToleranceField), Qt::Key_Return);
        QVERIFY(test.bar().isHidden());
        QCOMPARE(test.document().current().level->objects.size(), 3);
        QCOMPARE(test.document().undoLabel(), (Label{"import", 2}));
        QVERIFY2(test.message().contains("Text was left out"), qPrintable(test.message()));
        test.trigger(Act::Undo);
        QVERIFY(test.level() == empty);
    }

    void escapeLeavesTheLevelAsItWas() {
        Importing test;
        const Level empty = test.level();
        test.begin();
        QTest::keyClick(&test.field(ToleranceField), Qt::Key_Escape);
        QVERIFY(test.bar().isHidden() && !test.document().hasPreview());
        QVERIFY(test.level() == empty && test.document().history().empty());
        QVERIFY(test.canvas().hasFocus());
    }

    void scaleToleranceAndKindsAreShownLive() {
        Importing test;
        test.begin();
        QCOMPARE(test.field(ScaleField).value(), std::optional(0.01));
        const double width = boundsOf(test.level()).size().x();
        const std::size_t coarse = verticesOfBend(test.level());
        QVERIFY(coarse > 4);
        const QString before = test.bar().summary();
        test.enter(ToleranceField, 0.001);
        QVERIFY(verticesOfBend(test.level()) > 2 * coarse);
        QVERIFY(test.bar().summary() != before);
        test.enter(ScaleField, 0.02);
        QVERIFY(std::abs(boundsOf(test.level()).size().x() - 2 * width) < 1e-3);
        const QList<QComboBox*> kinds = test.bar().findChildren<QComboBox*>();
        kinds.at(0)->setCurrentIndex(1);
        test.bar().finishWork();
        QVERIFY(std::holds_alternative<EdgeChain>(std::get<BodyObject>(test.level().objects[2].data).shapes.front()));
        kinds.at(1)->setCurrentIndex(1);
        test.bar().finishWork();
        QVERIFY(std::holds_alternative<EdgeChain>(std::get<BodyObject>(test.level().objects[1].data).shapes.front()));
        QVERIFY(test.document().history().empty());
    }

    void itComesIntoTheMiddleOfTheViewOrWhereTheFileHasIt() {
        Importing test;
        Viewport view = test.canvas().view();
        view.center = {100, 50};
        test.canvas().setView(view);
        test.begin();
        QVERIFY((boundsOf(test.level()).center() - Vec2(100, 50)).norm() < test.window->toolbox().snap.step);
        for (QCheckBox* const box : test.bar().findChildren<QCheckBox*>()) {
            box->setChecked(!box->isChecked()); // not centred, into a new layer
        }
        test.bar().finishWork();
        QVERIFY(boundsOf(test.level()).min.x() > -1e-9);
        QCOMPARE(test.level().objects[0].name, std::string("rocks"));
        QVERIFY(std::get<GroupObject>(test.level().objects[0].data).layer);
        QVERIFY(!std::get<GroupObject>(test.level().objects[1].data).layer);
        QCOMPARE(test.level().objects[1].parent, test.level().objects[0].key);
    }

    void enterBeforeTheWorkIsDoneImportsWhenItIs() {
        Importing test;
        test.trigger(Act::Import);
        test.bar().apply();
        test.bar().finishWork();
        QVERIFY(test.bar().isHidden());
        QCOMPARE(test.document().current().level->objects.size(), 3);
    }

    void escapeWhileTheWorkIsDoneStopsIt() {
        Importing test;
        test.trigger(Act::Import);
        test.bar().cancel();
        QVERIFY(test.bar().isHidden() && !test.document().hasPreview());
        QCOMPARE(test.level().objects.size(), 0);
    }

    void aFileThatIsNoneIsRefusedInASentence() {
        Importing test("<svg xmlns='http://www.w3.org/2000/svg'>\n<g></svg>");
        test.begin();
        QVERIFY(test.bar().isHidden());
        QVERIFY2(test.message().contains("line 2") && test.message().contains("column"), qPrintable(test.message()));
        test.path = test.file("missing.svg");
        test.begin();
        QVERIFY2(test.message().contains("missing.svg"), qPrintable(test.message()));
    }

    void ofShipPayloadAndFinishTheLevelKeepsItsOwnWhichIsTold() {
        Importing test("<map orientation='orthogonal' width='9' height='9' tilewidth='16' tileheight='16'><objectgroup>"
                       "<object id='1' class='ship' x='40' y='40'><point/></object>"
                       "<object id='2' x='0' y='0' width='16' height='16'/></objectgroup></map>",
                       "map.tmx");
        Level level;
        level.objects.append({7, "mine", ShipObject{}, {}});
        test.document().reset(level);
        test.begin();
        QTest::keyClick(&test.bar(), Qt::Key_Return);
        int ships = 0;
        for (const Object& object : test.level().objects) {
            ships += std::holds_alternative<ShipObject>(object.data) ? 1 : 0;
        }
        QCOMPARE(ships, 1);
        QCOMPARE(firstOf<ShipObject>(test.level())->name, std::string("mine"));
        QVERIFY2(test.message().contains("The level has a ship, a payload or a finish already; those of the file were "
                                         "left out."),
                 qPrintable(test.message()));
    }

    void whatElseIsDoneToTheLevelClosesTheBar() {
        Importing test;
        test.begin();
        test.document().select(Selection());
        QVERIFY(test.bar().isHidden());
        QCOMPARE(test.level().objects.size(), 0);
    }

    void openingAForeignFileImportsIt() {
        Importing test;
        QVERIFY(test.window->open(test.path));
        test.bar().finishWork();
        QVERIFY(test.bar().isVisible());
        QCOMPARE(test.level().objects.size(), 3);
        test.window->play();
        QVERIFY(test.bar().isHidden() && !test.document().hasPreview());
    }

    void aPngHasTheSizeThatTheBarTells() {
        Exporting test;
        test.trigger(Act::ExportAs);
        QVERIFY(test.bar().isVisible());
        NumberField& scale = *test.bar().findChild<NumberField*>();
        scale.setValue(100);
        Q_EMIT scale.entered(100);
        QCOMPARE(test.bar().summary(), QStringLiteral("500 × 400 pixels"));
        test.write();
        QVERIFY(test.wished.endsWith(".png"));
        const QImage image(test.file("out.png"));
        QCOMPARE(image.size(), QSize(500, 400));
        QCOMPARE(qAlpha(image.pixel(2, 2)), 255);
        QVERIFY(image.pixel(200, 200) != image.pixel(2, 2)); // the rock
        QVERIFY(test.window->messageBar().text().contains("out.png"));
    }

    void aTransparentPngHasNoGround() {
        Exporting test;
        test.trigger(Act::ExportAs);
        test.bar().findChildren<QCheckBox*>().front()->setChecked(true);
        test.write();
        const QImage image(test.file("out.png"));
        QCOMPARE(qAlpha(image.pixel(2, 2)), 0);
        QVERIFY(qAlpha(image.pixel(image.width() / 2, image.height() / 2)) > 0);
    }

    void whatIsInViewIsAsLargeAsTheView() {
        Exporting test;
        Viewport view = test.canvas().view();
        view.scale = 66;
        test.canvas().setView(view);
        test.trigger(Act::ExportAs);
        test.bar().findChild<QComboBox*>()->setCurrentIndex(1);
        test.write();
        const QSize size = QImage(test.file("out.png")).size();
        QVERIFY((size - test.canvas().size()).width() <= 1 && (size - test.canvas().size()).height() <= 1);
    }

    void aPictureThatIsTooLargeIsRefusedInASentence() {
        Exporting test;
        test.trigger(Act::ExportAs);
        NumberField& scale = *test.bar().findChild<NumberField*>();
        scale.setValue(20000);
        Q_EMIT scale.entered(20000);
        QVERIFY2(test.bar().summary().contains("too large"), qPrintable(test.bar().summary()));
        test.write();
        QVERIFY(!QFile::exists(test.file("out.png")));
        QTest::keyClick(&scale, Qt::Key_Escape);
        QVERIFY(test.bar().isHidden());
    }

    void exportingAgainWritesTheSameFileWithoutAsking() {
        Exporting test;
        test.trigger(Act::ExportAgain);
        QVERIFY(test.bar().isVisible()); // nothing to repeat yet
        test.write();
        const QByteArray before = written(test.file("out.png"));
        QVERIFY(!before.isEmpty());
        test.target = "other.png";
        test.document().commit(
            {"move", 1},
            {std::make_shared<const Level>(rotated(test.level(), std::vector<Key>{7}, {0, 0}, 1)), Selection()});
        test.trigger(Act::ExportAgain);
        test.window->exchange().finishWork();
        QVERIFY(test.bar().isHidden());
        QVERIFY(written(test.file("out.png")) != before);
        QVERIFY(!QFile::exists(test.file("other.png")));
    }

    void aPictureThatCannotBeWrittenIsTold() {
        Exporting test;
        test.target = "missing/out.png";
        test.trigger(Act::ExportAs);
        test.write();
        QVERIFY2(test.window->messageBar().text().contains("missing"), qPrintable(test.window->messageBar().text()));
    }

    void anSvgThatWasExportedIsImportedWithTheSameOutlines() {
        Exporting test;
        test.target = "out.svg";
        test.trigger(Act::ExportAs);
        NumberField& scale = *test.bar().findChild<NumberField*>();
        scale.setValue(100);
        Q_EMIT scale.entered(100);
        test.write();
        const std::string text = written(test.file("out.svg")).toStdString();
        const Result<Drawing> drawing = readDrawing(text);
        QVERIFY(drawing);
        const Result<Import> import = importOf(drawing.value(), {0.01});
        QVERIFY(import);
        bool isFound = false;
        for (const Object& object : import.value().foreign.objects) {
            const auto* const body = std::get_if<BodyObject>(&object.data);
            const auto* const polygon = body != nullptr ? std::get_if<Polygon>(&body->shapes.front()) : nullptr;
            isFound = isFound || (polygon != nullptr && std::abs(signedArea(polygon->vertices) - 10) < 0.1);
        }
        QVERIFY(isFound);
    }
};

SPACETOW_TEST(ExchangeTest)
#include "exchange_test.moc"
