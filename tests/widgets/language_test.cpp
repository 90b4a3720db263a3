#include "editor/window/language.h"

#include "editor/window/preferences.h"
#include "tests/support/test_main.h"
#include "tests/support/windows.h"

#include <QMenuBar>

using namespace spacetow;
using spacetow::test::TestApplication;

class LanguageTest : public QObject {
    Q_OBJECT

  private slots:
    void eachLanguageIsNamedByItselfWithoutACountry() {
        QStringList names;
        for (const Language& language : languages()) {
            names << language.name;
        }
        for (const char* name : {"Deutsch", "English", "Español", "Français", "简体中文"}) {
            QVERIFY2(names.contains(QString::fromUtf8(name)), name);
        }
    }

    void aLanguageIsSpokenInAllWindowsAtOnceAndNothingElseChanges() {
        TestApplication test;
        test.start({test.writtenLevel("a.json")});
        test.application->newView(test.window(0));
        Level edited = test.window(0).document().level();
        edited.name = "edited";
        test.window(0).document().commit({"change-level", 1}, {std::make_shared<const Level>(edited), {}});
        Viewport view = test.window(1).canvas().view();
        view.center = Vec2(7, 3);
        view.scale = 50;
        test.window(1).canvas().setView(view);
        const QString english = test.window(0).menuBar()->actions().front()->text();
        for (const Language& language : languages()) {
            test.application->setLanguage(language.code);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCOMPARE(test.count(), 2u);
            QCOMPARE(test.window(0).openLevel(), test.window(1).openLevel());
            QCOMPARE(test.window(0).openLevel()->views().size(), std::size_t(2));
            QCOMPARE(test.window(0).document().level().name, std::string("edited"));
            QVERIFY(test.window(0).document().canUndo() && test.window(0).isVisible());
            QCOMPARE(test.window(1).canvas().view().center, Vec2(7, 3));
            const QString spoken = test.window(1).menuBar()->actions().front()->text();
            QCOMPARE(spoken == english, language.code == QLatin1String("en"));
            QCOMPARE(Preferences().language(), language.code);
        }
        QVERIFY(languages().size() >= 5);
        test.application->setLanguage(QString());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(test.window(0).menuBar()->actions().front()->text(), english);
    }
};

SPACETOW_TEST(LanguageTest)
#include "language_test.moc"
