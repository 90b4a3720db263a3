// Names of files and objects may hold anything, and are shown as they are.
#include "editor/panels/names.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextDocument>
#include <QTimer>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

const QString oddName = QStringLiteral("<b>a&b[*].json");

/// What is painted of a menu's text: doubled & are single ones, single ones are marks.
QString asPainted(QString text) {
    return text.replace(QStringLiteral("&&"), QChar(1)).remove(QLatin1Char('&')).replace(QChar(1), QLatin1Char('&'));
}

Object namedBall(Key key, const Vec2& position, const char* name = "") {
    Object ball;
    ball.key = key;
    ball.name = name;
    ball.data = BodyObject{.shapes = {Circle{{0, 0}, 0.5}}, .position = position};
    return ball;
}

} // namespace

class NamesTest : public QObject {
    Q_OBJECT

  private slots:
    void recentFilesKeepTheirNames() {
        TestWindow test;
        const QString path = test.file(oddName);
        QVERIFY(!writeLevel(path.toStdString(), Level()));
        QVERIFY(test.window->open(path));
        QStringList texts;
        for (const QMenu* menu : test.window->findChildren<QMenu*>()) {
            for (const QAction* action : menu->actions()) {
                texts << asPainted(action->text());
            }
        }
        QVERIFY(texts.contains(QStringLiteral("1 ") + oddName));
    }

    void theTitleShowsTheNameAndTheMark() {
        TestWindow test;
        const QString path = test.file(oddName);
        QVERIFY(!writeLevel(path.toStdString(), Level()));
        QVERIFY(test.window->open(path));
        // The toolkit takes pairs for the letters and the odd one for the mark.
        QCOMPARE(test.window->windowTitle(), QStringLiteral("<b>a&b[*][*].json[*] - SpaceTow Studio"));
    }

    void aQuestionShowsTheNameAsItIs() {
        TestWindow test;
        QString shown;
        Qt::TextFormat format = Qt::AutoText;
        QTimer::singleShot(0, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            shown = box->text();
            format = box->textFormat();
            box->close();
        });
        const Unsaved answer = dialogQuestions([&] { return test.window.get(); }).whatAboutChanges(oddName);
        QCOMPARE(answer, Unsaved::Cancel);
        QVERIFY(shown.contains(oddName));
        QCOMPARE(format, Qt::PlainText);
    }

    void elsewhereTextsOfMenusAreWithoutTheMarkOfTheLetter() {
        QCOMPARE(withoutMnemonic(QStringLiteral("&Open…")), QStringLiteral("Open…"));
        QCOMPARE(withoutMnemonic(QString::fromUtf8("打开(&O)…")), QString::fromUtf8("打开…"));
        QCOMPARE(withoutMnemonic(QStringLiteral("Save (&S)")), QStringLiteral("Save"));
        QCOMPARE(withoutMnemonic(QStringLiteral("Undo: a&&b (&&c) (d)")), QStringLiteral("Undo: a&b (&c) (d)"));
        QCOMPARE(withoutMnemonic(QStringLiteral("&")), QString());
    }

    void tooltipsAreNoRichText() {
        QCOMPARE(plainToolTip("Click: select"), QString("Click: select"));
        QVERIFY(plainToolTip("<img src=\"/etc/passwd\">").contains("&lt;img"));
    }

    void aLongTooltipTakesSeveralLines() {
        const QString sentences =
            QStringLiteral("Three <equal> pendulums swing & bend; take one and let it go. ").repeated(4);
        QLabel tip(plainToolTip(sentences));
        tip.setWordWrap(Qt::mightBeRichText(tip.text())); // as tooltips do
        QVERIFY(tip.sizeHint().width() < tip.fontMetrics().horizontalAdvance(sentences) / 2);
        QTextDocument document;
        document.setHtml(tip.text());
        QCOMPARE(document.toPlainText().trimmed(), sentences.trimmed());
    }

    void anObjectWithoutANameIsToldByKindAndPlace() {
        Level level;
        level.objects.append(namedBall(1, {3, -2.5}));
        level.objects.append(namedBall(2, {0, 0}, "wheel & axle"));
        QCOMPARE(listedName(level, level.objects[0]), QString("Circle at 3; -2.5"));
        QCOMPARE(listedName(level, level.objects[1]), QString("wheel & axle (Circle)"));
        QCOMPARE(menuSafe(listedName(level, level.objects[1])), QString("wheel && axle (Circle)"));
    }

    void whateverNamesAnObjectWithoutANameSaysTheSamePlace() {
        Level level;
        Object corner{1, "", BodyObject{.shapes = {}, .position = {-1.5, -2.5}}, {}};
        std::get<BodyObject>(corner.data).shapes = {Polygon{{{0, 0}, {0.254, 0}, {0.254, 0.25}, {0, 0.25}}}};
        level.objects.append(corner);
        level.objects.append({2, "", ShipObject{{-3.25, 1.75}, 0}, {}});
        level.objects.append({3, "", FinishObject{{1, 2}, {3, 2}}, {}});
        const QStringList names{"Polygon at -1.37; -2.38", "Ship at -3.25; 1.75", "Finish at 2; 2"};
        for (int i = 0; i < names.size(); ++i) {
            QCOMPARE(listedName(level, level.objects[i]), names[i]);
            QCOMPARE(placedKind(level.objects[i]), names[i]);
        }
    }

    void theContextMenuListsAllThatLiesUnderThePointer() {
        TestWindow test;
        Level level;
        level.objects.append(namedBall(1, {0, 0}, "wheel & axle"));
        level.objects.append(namedBall(2, {0.1, 0}));
        level.objects.append(namedBall(3, {4, 0}));
        test.document().reset(level);
        QStringList listed;
        QTimer watch;
        QObject::connect(&watch, &QTimer::timeout, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu == nullptr) {
                return;
            }
            watch.stop();
            for (const QMenu* below : menu->findChildren<QMenu*>()) {
                for (QAction* action : below->actions()) {
                    listed << asPainted(action->text());
                }
                below->actions().back()->trigger();
            }
            menu->close();
        });
        watch.start(0);
        QTest::mouseMove(&test.canvas(), test.at(0, 0));
        QTest::mouseClick(&test.canvas(), Qt::RightButton, {}, test.at(0, 0));
        QCOMPARE(listed.size(), 2);
        QVERIFY(listed.contains("wheel & axle (Circle)"));
        QVERIFY(listed.contains("Circle at 0.1; 0"));
        QCOMPARE(test.document().selection().size(), 1);
    }
};

SPACETOW_TEST(NamesTest)
#include "names_test.moc"
