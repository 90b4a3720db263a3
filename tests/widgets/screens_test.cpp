// The window in each of its modes, in light and dark, small and large: nothing may be cut off. With SPACETOW_SCREENS
// naming a folder every one of them is left there as a picture; QT_SCALE_FACTOR=2 takes them as on a fine display.
#include "editor/window/key_editor.h"
#include "editor/window/keys_dialog.h"
#include "editor/window/screen_room.h"
#include "tests/support/color_vision.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDir>
#include <QDockWidget>
#include <QScreen>
#include <QToolBar>

#include <functional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Mode {
    std::string name;
    std::function<void(TestWindow&)> enter;
};

/// Takes the tool and draws half a shape with it.
Mode busy(const ToolRow& row) {
    return {"tool " + row.make()->code(), [tool = row.id](TestWindow& test) {
                test.window->takeTool(tool);
                const Vec2 center = test.canvas().view().center;
                test.click(center.x() - 1, center.y() - 1);
                test.click(center.x() + 1, center.y() - 1);
                QTest::mouseMove(&test.canvas(), test.at(center.x() + 1.5, center.y() + 0.5));
            }};
}

const std::vector<Mode>& modes() {
    static const std::vector<Mode> all = [] {
        std::vector<Mode> modes{
            {"edit", [](TestWindow&) {}},
            {"selected", [](TestWindow& test) { test.trigger(Act::SelectAll); }},
            {"one selected",
             [](TestWindow& test) { test.document().select(Selection({test.level().objects[0].key})); }},
            {"overlays",
             [](TestWindow& test) {
                 test.window->setOverlays({true, true, true, true, true, true});
             }},
            {"information",
             [](TestWindow& test) {
                 test.window->messageBar().say(MessageBar::Tone::Info, QStringLiteral("This level was made by an older "
                                                                                      "version and has been brought up "
                                                                                      "to date."));
             }},
            {"warning",
             [](TestWindow& test) {
                 test.window->messageBar().say(MessageBar::Tone::Warning,
                                               QStringLiteral("The level has 3 errors and may not play as it should; "
                                                              "see Problems."));
             }},
            {"error",
             [](TestWindow& test) {
                 test.window->messageBar().say(MessageBar::Tone::Error,
                                               QStringLiteral("The file /home/user/levels/a_rather_long_name.json "
                                                              "cannot be written: there is no space left on the "
                                                              "device. The level is as it was."));
             }},
            {"play", [](TestWindow& test) { test.trigger(Act::Play); }},
            {"pause",
             [](TestWindow& test) {
                 test.trigger(Act::Play);
                 QTest::keyClick(&test.canvas(), Qt::Key_Escape);
             }},
        };
        for (const ToolRow& tool : toolRows()) {
            modes.push_back(busy(tool));
        }
        return modes;
    }();
    return all;
}

void save(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("SPACETOW_SCREENS");
    if (folder.isEmpty()) {
        return;
    }
    const double ratio = widget.devicePixelRatioF();
    QDir().mkpath(folder);
    QString file = QStringLiteral("%1 @%2.png").arg(name).arg(ratio);
    QVERIFY(widget.grab().save(QDir(folder).filePath(file.replace(QLatin1Char(' '), QLatin1Char('-')))));
}

} // namespace

class ScreensTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void nothingIsCutOff_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark");
        for (const QSize size : {QSize(800, 600), QSize(1920, 1080), QSize(3840, 2160)}) {
            for (const bool dark : {false, true}) {
                QTest::addRow("%dx%d %s", size.width(), size.height(), dark ? "dark" : "light") << size << dark;
            }
        }
    }
    void nothingIsCutOff() {
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        const QString look = QLatin1String(QTest::currentDataTag());
        for (const Mode& mode : modes()) {
            TestWindow test;
            test.window->setAppearance(dark ? Appearance::Dark : Appearance::Light);
            test.window->openExample();
            test.window->resize(size);
            QApplication::processEvents();
            QCOMPARE(test.window->size(), size); // its parts leave it that small
            test.canvas().fitLevel();
            mode.enter(test);
            QApplication::processEvents();
            QVERIFY2(cutOffTexts(*test.window).isEmpty(),
                     qPrintable(QStringLiteral("%1: %2").arg(QString::fromStdString(mode.name),
                                                             cutOffTexts(*test.window).join(QStringLiteral(", ")))));
            save(*test.window, QStringLiteral("%1 %2").arg(QString::fromStdString(mode.name), look));
        }
    }

    void wordsTurnWithTheShade_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("from dark to light") << false;
        QTest::newRow("from light to dark") << true;
    }
    void wordsTurnWithTheShade() {
        QFETCH(bool, dark);
        TestWindow test;
        test.window->setAppearance(dark ? Appearance::Light : Appearance::Dark);
        QApplication::processEvents();
        test.window->setAppearance(dark ? Appearance::Dark : Appearance::Light);
        QApplication::processEvents();
        const QColor ground = test.window->palette().color(QPalette::Window);
        int looked = 0;
        for (QToolButton* button : test.window->findChildren<QToolButton*>()) {
            if (!button->isVisible() || !button->isEnabled() || button->text().isEmpty() ||
                button->toolButtonStyle() == Qt::ToolButtonIconOnly) {
                continue;
            }
            ++looked;
            const QImage image = button->grab().toImage();
            int readable = 0; // pixels
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width() * 2 / 3; ++x) { // an arrow may follow
                    readable += contrast(image.pixelColor(x, y), ground) > 4.5 ? 1 : 0;
                }
            }
            QVERIFY2(readable > 20, qPrintable(button->text()));
        }
        QVERIFY(looked >= 2); // snapping and the problems
    }

    void dialogsFitTheSmallestScreen_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void dialogsFitTheSmallestScreen() {
        QFETCH(bool, dark);
        TestWindow test;
        test.window->setAppearance(dark ? Appearance::Dark : Appearance::Light);
        KeysDialog keys({}, test.window.get());
        KeyEditor editor(test.window.get());
        keys.show();
        QApplication::processEvents();
        QCOMPARE(cutOffTexts(keys), QStringList());
        const QSize room = withinScreen({9999, 9999}, {800, 600});
        for (const QWidget* dialog : std::initializer_list<QWidget*>{&keys, &editor}) {
            const QSize least = dialog->minimumSizeHint();
            QVERIFY(least.width() <= room.width() && least.height() <= room.height());
            QCOMPARE(withinScreen(dialog->size(), dialog->screen()->availableGeometry().size()), dialog->size());
        }
        save(keys, QStringLiteral("keys %1").arg(QLatin1String(dark ? "dark" : "light")));
    }

    void withAllPanelsTheWindowIsNoHigherThanHalfAFullHdScreen() {
        constexpr int most = 500; // px: 1080 at a scale of 2, without the desktop's bars
        TestWindow test;
        test.window->openExample();
        QStringList heights;
        for (const PanelRow& row : panelRows()) {
            QDockWidget& dock = test.window->panels().dock(QLatin1String(row.name));
            dock.show();
            heights
                << QStringLiteral("%1 %2").arg(QLatin1String(row.name)).arg(dock.widget()->minimumSizeHint().height());
        }
        test.trigger(Act::Simulate);
        QApplication::processEvents();
        const int height = test.window->minimumSizeHint().height();
        heights << QStringLiteral("all %1").arg(height);
        QVERIFY2(height <= most, qPrintable(heights.join(QStringLiteral(", "))));
    }

    void everyActionOfABarIsReachedInTheSmallestWindow() {
        TestWindow test;
        test.window->resize(800, 600);
        QApplication::processEvents();
        for (QToolBar* bar : test.window->findChildren<QToolBar*>()) {
            int hidden = 0;
            for (QAction* action : bar->actions()) {
                const QWidget* const button = bar->widgetForAction(action);
                hidden += button != nullptr && !action->isSeparator() && button->isHidden() ? 1 : 0;
            }
            const auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
            QVERIFY2(hidden == 0 || (more != nullptr && more->isVisible()), qPrintable(bar->windowTitle()));
        }
    }
};

SPACETOW_TEST(ScreensTest)
#include "screens_test.moc"
