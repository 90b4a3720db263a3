#include "editor/window/difference_panel.h"

#include "core/level/compare.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/window/messages_compare.h"
#include "tests/support/pixels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QTimer>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using DifferingKeys = std::vector<Key>;

/// Three balls in a row, of which the last is far away.
Level ballsApart() {
    Level level;
    for (const Key key : {1u, 2u, 3u}) {
        BodyObject ball;
        ball.shapes = {Circle{{0, 0}, 0.5}};
        ball.position = {key == 3 ? 100.0 : 4.0 * key, 0};
        level.objects.append({key, "ball " + std::to_string(key), ball, {}});
    }
    return level;
}

struct ComparedWindow : TestWindow {
    /// The level is shown, the file has it with ball 1 elsewhere, without ball 2 and with another ball 4.
    explicit ComparedWindow(const Level& level) {
        Level other = removed(moved(level, DifferingKeys{1}, {0, 3}), DifferingKeys{2});
        other.objects.append({4, "gone", BodyObject{.shapes = {Circle{}}, .position = {-5, 0}}, {}});
        const QString path = file("other.json");
        if (writeLevel(path.toStdString(), other)) {
            qFatal("cannot write the level");
        }
        document().reset(level);
        window->files().questions.whichToCompare = [path](const QString&) { return path; };
        trigger(Act::Compare);
        panel().finish();
    }
    DifferencePanel& panel() { return window->differences(); }
    QListView& list() { return *panel().findChild<QListView*>(); }
    QStringList texts() {
        QStringList all;
        for (int i = 0; i < list().model()->rowCount(); ++i) {
            all << list().model()->index(i, 0).data().toString();
        }
        return all;
    }
    void click(int row) {
        const QModelIndex index = list().model()->index(row, 0);
        list().scrollTo(index);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(index).center());
    }
};

} // namespace

class DifferencePanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itSaysWhatIsDifferentFromTheChosenFile() {
        ComparedWindow shown(ballsApart());
        QVERIFY(shown.window->panels().dock("differences").isVisible());
        QCOMPARE(shown.texts(),
                 (QStringList{"gone (Circle): removed", "ball 1 (Circle): Position y 3\u00a0m → 0\u00a0m",
                              "ball 2 (Circle): added"}));
    }

    void numbersHaveAsManyDigitsAsTellThemApart() {
        const Level before = ballsApart();
        const auto told = [&](double x) {
            const Level after = moved(before, DifferingKeys{1}, {x - 4, 0});
            return differenceLines(before, after, differenceBetween(before, after)).at(0).text;
        };
        QCOMPARE(told(1.393538219070134), QString("ball 1 (Circle): Position x 4\u00a0m → 1.3935\u00a0m"));
        QVERIFY2(told(4.0000000003).contains("4.0000000003"), qPrintable(told(4.0000000003)));
    }

    void theDialogSaysWhatTheLevelIsFor() {
        QWidget parent;
        QString title;
        QTimer::singleShot(0, [&title] {
            title = QApplication::activeModalWidget()->windowTitle();
            qobject_cast<QDialog*>(QApplication::activeModalWidget())->reject();
        });
        QVERIFY(dialogQuestions([&parent] { return &parent; }).whichToCompare(QDir::tempPath()).isEmpty());
        QCOMPARE(title, QStringLiteral("Compare with level"));
    }

    void itFollowsEdits() {
        ComparedWindow shown(ballsApart());
        shown.document().commit({"delete", 1},
                                {std::make_shared<const Level>(removed(shown.level(), DifferingKeys{2})), {}});
        shown.panel().finish();
        QCOMPARE(shown.texts().size(), 2);
        shown.document().undo();
        shown.panel().finish();
        QCOMPARE(shown.texts().size(), 3);
    }

    void aClickLeadsToTheObjectAndToWhereOneWasThatHasGone() {
        ComparedWindow shown(ballsApart());
        shown.click(1);
        QCOMPARE(shown.document().selection().keys(), DifferingKeys{1});
        shown.canvas().setView({});
        shown.click(0);
        QVERIFY(shown.canvas().view().visible().contains(Vec2(-5, 0)));
        QVERIFY(!shown.canvas().view().visible().contains(Vec2(100, 0)));
    }

    void takingOverMakesObjectsAsTheyAreThereInOneUndoStep() {
        ComparedWindow shown(ballsApart());
        const Level before = shown.level();
        shown.list().selectAll();
        shown.panel().takeOver();
        shown.panel().finish();
        QVERIFY(shown.texts().isEmpty());
        QCOMPARE(shown.level().objects.find(2), nullptr);
        QVERIFY(shown.level().objects.find(4) != nullptr);
        QCOMPARE(std::get<BodyObject>(shown.level().objects.find(1)->data).position, Vec2(4, 3));
        QCOMPARE(shown.document().historySize(), 1);
        shown.document().undo();
        QVERIFY(shown.level() == before);
    }

    void theCanvasMarksWhatHasComeGoneAndMovedUntilComparingEnds() {
        ComparedWindow shown(ballsApart());
        shown.document().select({});
        Viewport view;
        view.center = {2, 0};
        view.scale = 40;
        shown.canvas().setView(view);
        const auto grabbed = [&] {
            shown.canvas().finishPainting();
            return shown.canvas().grab().toImage();
        };
        const MarkColors marks = markColors(shadeOf(shown.canvas().palette()));
        const QImage with = grabbed();
        shown.panel().end();
        QVERIFY(!shown.panel().isComparing());
        const QImage without = grabbed();
        for (const QColor& color : {marks.good, marks.error, marks.warning}) {
            QVERIFY2(pixelsLike(with, color, 24) > pixelsLike(without, color, 24) + 60, qPrintable(color.name()));
        }
        QVERIFY(shown.texts().isEmpty());
    }
};

SPACETOW_TEST(DifferencePanelTest)
#include "difference_panel_test.moc"
