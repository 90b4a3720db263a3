// What is shown while no level is open.

#include "editor/window/welcome_page.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"
#include "tests/support/windows.h"

#include <QFile>

using namespace spacetow;
using spacetow::test::TestApplication;

namespace {

/// How many different colours there are in the picture of a card, up to a few.
int colorsIn(const LevelCard& card) {
    const QImage image = card.picture().toImage();
    QSet<QRgb> colors;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width() && colors.size() < 4; ++x) {
            colors.insert(image.pixel(x, y));
        }
    }
    return static_cast<int>(colors.size());
}

void writeText(const QString& path, const QByteArray& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
}

} // namespace

class WelcomePageTest : public QObject {
    Q_OBJECT

  private slots:
    void theFirstStartShowsTheLevelsThatComeWithTheProgram() {
        TestApplication test;
        test.start();
        QCOMPARE(test.count(), 1u);
        MainWindow& window = test.window(0);
        QVERIFY(window.isWelcoming() && window.welcome().isVisible());
        QVERIFY(window.windowTitle().startsWith(MainWindow::tr("Welcome")));
        QVERIFY(window.welcome().recent().isHidden());
        QVERIFY(!window.welcome().shipped().cards().empty());
        QVERIFY(window.welcome().sandboxes().cards().size() >= 11);
        QVERIFY(!window.actions()[Act::Save].isEnabled() && !window.actions()[ToolId::Edge].isEnabled());
        QVERIFY(window.actions()[Act::New].isEnabled() && window.actions()[Act::Open].isEnabled());
        QVERIFY(window.panels().areAway());
    }

    void eachLevelHasItsPictureAndRecentOnesStandFirst() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        const QString b = test.writtenLevel("b.json");
        Preferences().addRecent(a);
        Preferences().addRecent(b);
        test.start();
        WelcomePage& page = test.window(0).welcome();
        QCOMPARE(page.recent().cards().size(), 2u);
        QCOMPARE(page.recent().cards()[0]->path(), b);
        page.pictures().finish();
        for (const CardGrid* grid : {&page.recent(), &page.shipped(), &page.sandboxes()}) {
            for (const LevelCard* card : grid->cards()) {
                QVERIFY2(colorsIn(*card) > 2, qPrintable(card->path()));
            }
        }
    }

    void aPictureIsPaintedAnewWhenTheColoursOfThePanelsChange() {
        TestApplication test;
        test.start();
        MainWindow& window = test.window(0);
        const LevelCard& card = *window.welcome().shipped().cards().front();
        window.setAppearance(Appearance::Dark);
        QApplication::processEvents();
        window.welcome().pictures().finish();
        const QRgb dark = card.picture().toImage().pixel(1, 1);
        window.setAppearance(Appearance::Light);
        QApplication::processEvents();
        window.welcome().pictures().finish();
        QVERIFY(qGray(card.picture().toImage().pixel(1, 1)) > qGray(dark));
    }

    void aShippedLevelOpensAsACopyWithoutAFile() {
        TestApplication test;
        test.start();
        test.window(0).welcome().shipped().cards().front()->click();
        QVERIFY(!test.window(0).isWelcoming() && test.window(0).canvas().isVisible());
        QVERIFY(test.window(0).files().path().isEmpty());
        QVERIFY(test.window(0).document().level().objects.size() > 2);
        QVERIFY(!test.window(0).panels().areAway());
    }

    void aSandboxSaysWhatToTryWhenItOpens() {
        TestApplication test;
        test.start();
        MainWindow& window = test.window(0);
        for (LevelCard* card : window.welcome().sandboxes().cards()) {
            QVERIFY2(!card->toolTip().isEmpty(), qPrintable(card->path()));
        }
        window.welcome().sandboxes().cards()[1]->click();
        QVERIFY(!window.isWelcoming());
        QCOMPARE(window.messageBar().text(), QString::fromStdString(window.document().level().description));
        QVERIFY(window.messageBar().text().contains("raise its limit"));
        QCOMPARE(window.messageBar().tone(), MessageBar::Tone::Info);
        QCOMPARE(window.messageBar().buttons().size(), 1u);
        window.messageBar().buttons().front()->click();
        QVERIFY(window.isPlaying() && !window.isInGame());
        QVERIFY(window.messageBar().text().contains("raise its limit")); // while one tries it
        QVERIFY(window.messageBar().buttons().empty());                  // which would do nothing any more
    }

    void aRecentLevelIsOpenedInThisWindow() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        Preferences().addRecent(a);
        test.start();
        test.window(0).welcome().recent().cards().front()->click();
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), a);
    }

    void aFileThatIsNoLevelStaysAndSaysWhy() {
        TestApplication test;
        const QString broken = test.file("broken.json");
        writeText(broken, "{");
        Preferences().addRecent(broken);
        test.start();
        WelcomePage& page = test.window(0).welcome();
        page.pictures().finish();
        QVERIFY(page.pictures().isUnreadable(broken));
        page.recent().cards().front()->click();
        QVERIFY(test.window(0).isWelcoming());
        QVERIFY(test.window(0).messageBar().text().contains("broken.json"));
    }

    void theKeyboardReachesAllOfIt() {
        TestApplication test;
        test.start();
        MainWindow& window = test.window(0);
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        WelcomePage& page = window.welcome();
        page.newButton().setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), &page.openButton());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), page.shipped().cards()[0]);
        const auto& cards = page.sandboxes().cards();
        for (std::size_t i = 0; i < page.shipped().cards().size(); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(QApplication::focusWidget(), cards[0]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QCOMPARE(QApplication::focusWidget(), cards[1]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(!window.isWelcoming());
    }

    void newLevelLeavesItAndClosingTheLastLevelBringsItBack() {
        TestApplication test;
        test.start();
        test.window(0).welcome().newButton().click();
        QVERIFY(!test.window(0).isWelcoming());
        test.trigger(0, Act::Close);
        QVERIFY(test.window(0).isWelcoming());
        QVERIFY(!test.window(0).actions()[Act::ReopenClosed].isEnabled()); // nothing had been done
        test.trigger(0, Act::Close);
        QCOMPARE(test.count(), 0u);
    }

    void theLevelThatWasClosedLastIsReopenedFromIt() {
        TestApplication test;
        const QString a = test.writtenLevel("a.json");
        test.start({a});
        test.trigger(0, Act::Close);
        QVERIFY(test.window(0).isWelcoming());
        QCOMPARE(test.window(0).welcome().recent().cards().front()->path(), a);
        test.trigger(0, Act::ReopenClosed);
        QCOMPARE(test.count(), 1u);
        QCOMPARE(test.window(0).files().path(), a);
    }

    void switchedOffTheProgramBeginsWithAnEmptyLevel() {
        TestApplication test;
        test.start();
        test.window(0).welcome().atStart().click();
        test.startAgain();
        QVERIFY(!test.window(0).isWelcoming());
        QCOMPARE(test.window(0).document().level().objects.size(), 0);
        test.trigger(0, Act::Welcome); // and is there when it is asked for
        QVERIFY(test.window(0).isWelcoming() && !test.window(0).welcome().atStart().isChecked());
    }

    void noLetterOfANameIsAKey() {
        const LevelCard card(QStringLiteral("/levels/salt&pepper.json"), QStringLiteral("salt&pepper"), QString(),
                             nullptr);
        QVERIFY(card.shortcut().isEmpty());
        QCOMPARE(card.accessibleName(), QStringLiteral("salt&pepper"));
    }

    void theBottomLineSaysNothingOfABoardThatIsNotThere() {
        TestApplication test;
        test.start();
        QVERIFY(test.window(0).isWelcoming());
        const auto* zoom = test.window(0).statusLine().findChild<ZoomField*>();
        QVERIFY(!zoom->isVisible());
        test.trigger(0, Act::New);
        QVERIFY(zoom->isVisible());
    }

    void nothingIsCutOffInAnySize_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small") << QSize(800, 600);
        QTest::newRow("large") << QSize(1920, 1080);
    }
    void nothingIsCutOffInAnySize() {
        QFETCH(QSize, size);
        TestApplication test;
        for (const char* name : {"a.json", "b.json", "c.json", "d.json"}) {
            Preferences().addRecent(test.writtenLevel(name));
        }
        test.start();
        MainWindow& window = test.window(0);
        window.resize(size);
        QApplication::processEvents();
        QCOMPARE(window.size(), size);
        QCOMPARE(spacetow::test::cutOffTexts(window.welcome()), QStringList());
        for (const LevelCard* card : window.welcome().recent().cards()) {
            QVERIFY(window.welcome().recent().rect().contains(card->geometry()));
        }
    }
};

SPACETOW_TEST(WelcomePageTest)
#include "welcome_page_test.moc"
