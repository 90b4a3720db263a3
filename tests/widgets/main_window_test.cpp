#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/window/keys_dialog.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QMimeData>
#include <QScreen>
#include <QSet>
#include <QToolButton>

using namespace spacetow;
using spacetow::test::TestWindow;

class MainWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void aWallDrawnWithTheMouseIsUndoneAndRedone() {
        TestWindow test;
        const Level empty = test.level();
        test.drawWalls();
        QCOMPARE(test.level().objects.size(), 1);
        const Level drawn = test.level();
        const auto& body = std::get<BodyObject>(drawn.objects[0].data);
        QCOMPARE(std::get<EdgeChain>(body.shapes.front()).vertices.size(), std::size_t{3});
        QVERIFY(test.window->isWindowModified());
        test.trigger(Act::Undo);
        QVERIFY(test.level() == empty);
        QVERIFY(!test.window->isWindowModified());
        test.trigger(Act::Redo);
        QVERIFY(test.level() == drawn);
    }

    void aDragIsOneEntryInTheHistory() {
        TestWindow test;
        test.drawWalls();
        const int before = test.document().position();
        test.drag(0, -2, 1, -1);
        QCOMPARE(test.document().position(), before + 1);
        const auto& body = std::get<BodyObject>(test.level().objects[0].data);
        QVERIFY((body.position - Vec2(-1, -1)).norm() < 2 * test.canvas().view().pixel());
    }

    void escapeDuringADragLeavesEverythingAsItWas() {
        TestWindow test;
        test.drawWalls();
        const Level before = test.level();
        QTest::mousePress(&test.canvas(), Qt::LeftButton, {}, test.at(0, -2));
        QTest::mouseMove(&test.canvas(), test.at(1, 1));
        QVERIFY(!(test.level() == before));
        QTest::keyClick(&test.canvas(), Qt::Key_Escape);
        QVERIFY(test.level() == before);
        QTest::mouseRelease(&test.canvas(), Qt::LeftButton, {}, test.at(1, 1));
        QVERIFY(test.level() == before);
    }

    void whatIsSavedIsReadBackTheSame() {
        TestWindow test;
        test.drawWalls();
        const Level drawn = test.level();
        test.toSave = test.file("drawn.json");
        test.trigger(Act::Save);
        QVERIFY(!test.window->isWindowModified());
        QVERIFY(test.window->windowTitle().startsWith("drawn.json[*] - "));
        test.trigger(Act::New);
        QCOMPARE(test.level().objects.size(), 0);
        QVERIFY(test.window->open(test.toSave));
        QVERIFY(test.level() == drawn);
        QVERIFY(!test.document().canUndo());
        QCOMPARE(test.window->files().preferences.recentFiles(), QStringList{test.toSave});
    }

    void aSaveThatFailsKeepsTheWorkAndSaysWhy() {
        TestWindow test;
        test.drawWalls();
        const Level drawn = test.level();
        test.toSave = test.file("no/such/folder/level.json");
        test.trigger(Act::Save);
        QVERIFY(test.level() == drawn);
        QVERIFY(test.window->isWindowModified());
        QVERIFY(test.window->files().path().isEmpty());
        QVERIFY(test.window->messageBar().isVisible());
        QVERIFY(test.window->messageBar().text().contains("level.json"));
    }

    void aFileThatCannotBeReadKeepsWhatIsOpen_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("not json") << QByteArray("{ nonsense");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("another thing") << QByteArray("[1, 2, 3]\n");
        QTest::newRow("newer") << QByteArray("{\"schema\": 999}\n");
    }
    void aFileThatCannotBeReadKeepsWhatIsOpen() {
        QFETCH(QByteArray, content);
        TestWindow test;
        test.drawWalls();
        const Level drawn = test.level();
        QFile file(test.file("broken.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        QVERIFY(!test.window->open(file.fileName()));
        QVERIFY(test.level() == drawn);
        QCOMPARE(test.asked, 0);
        QVERIFY(test.window->messageBar().text().contains("broken.json"));
    }

    void closingWithChangesAsksFirst_data() {
        QTest::addColumn<Unsaved>("answer");
        QTest::addColumn<bool>("closes");
        QTest::addColumn<bool>("writes");
        QTest::newRow("save") << Unsaved::Save << true << true;
        QTest::newRow("discard") << Unsaved::Discard << true << false;
        QTest::newRow("cancel") << Unsaved::Cancel << false << false;
    }
    void closingWithChangesAsksFirst() {
        QFETCH(Unsaved, answer);
        QFETCH(bool, closes);
        QFETCH(bool, writes);
        TestWindow test;
        test.drawWalls();
        test.toSave = test.file("kept.json");
        test.unsaved = answer;
        QCOMPARE(test.window->close(), closes);
        QCOMPARE(test.asked, 1);
        QCOMPARE(QFile::exists(test.toSave), writes);
    }

    void reopeningAfterSavingShowsWhatWasSaved() {
        TestWindow test;
        const QString path = test.file("level.json");
        QVERIFY(!writeLevel(path.toStdString(), Level()));
        QVERIFY(test.window->open(path));
        test.drawWalls();
        const Level drawn = test.level();
        test.unsaved = Unsaved::Save;
        QVERIFY(test.window->open(path));
        QCOMPARE(test.asked, 1);
        QVERIFY(test.level() == drawn);
        QVERIFY(!test.window->isWindowModified());
    }

    void savingLeavesTheViewAsItIs() {
        TestWindow test;
        test.window->openExample();
        test.trigger(Act::ZoomIn);
        const double scale = test.canvas().view().scale;
        const Vec2 centre = test.canvas().view().toWorld(Vec2(0, 0));
        test.toSave = test.file("level.json");
        test.trigger(Act::Save);
        test.trigger(Act::SaveAs);
        QCOMPARE(test.canvas().view().scale, scale);
        QCOMPARE(test.canvas().view().toWorld(Vec2(0, 0)), centre);
        QVERIFY(test.window->open(test.toSave));
        QVERIFY(test.canvas().view().scale != scale);
    }

    void aHalfDrawnShapeStaysBehindWhenAnotherLevelIsOpened_data() {
        QTest::addColumn<bool>("file");
        QTest::newRow("new") << false;
        QTest::newRow("open") << true;
    }
    void aHalfDrawnShapeStaysBehindWhenAnotherLevelIsOpened() {
        QFETCH(bool, file);
        TestWindow test;
        test.toOpen = test.file("level.json");
        QVERIFY(!writeLevel(test.toOpen.toStdString(), Level()));
        test.trigger(ToolId::Edge);
        test.click(-2, -2);
        test.click(2, -2);
        QVERIFY(test.window->toolbox().isBusy());
        test.trigger(file ? Act::Open : Act::New);
        QVERIFY(!test.window->toolbox().isBusy());
    }

    void whatIsStillBeingTypedIsNotLost_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Act>("act");
        for (const char* id : {"gravity.x", "name", "description"}) {
            for (const Act act : {Act::Save, Act::SaveAs, Act::New, Act::Open, Act::Play, Act::Quit}) {
                QTest::addRow("%s %d", id, static_cast<int>(act)) << QString(id) << act;
            }
        }
    }
    void whatIsStillBeingTypedIsNotLost() {
        QFETCH(QString, id);
        QFETCH(Act, act);
        TestWindow test;
        test.toSave = test.file("level.json");
        test.toOpen = test.toSave;
        QVERIFY(!writeLevel(test.toSave.toStdString(), Level()));
        test.unsaved = Unsaved::Save;
        QWidget* field = test.window->inspector().form().editor(id.toUtf8().constData());
        field->setFocus();
        QTest::keyClicks(field, "7");
        QVERIFY(test.level() == Level());
        test.trigger(act);
        if (act == Act::Play) {
            QVERIFY(!(test.level() == Level()));
            return;
        }
        const Result<LevelFile> saved = readLevel(test.toSave.toStdString());
        QVERIFY(bool(saved) && saved.value().level);
        QVERIFY(!(*saved.value().level == Level()));
    }

    void closingAsksNothingWhenNothingChanged() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::Undo);
        QVERIFY(test.window->close());
        QCOMPARE(test.asked, 0);
    }

    void playingLeavesTheLevelAsItWas() {
        TestWindow test;
        test.window->openExample();
        const auto before = test.document().current().level;
        test.trigger(Act::Play);
        QVERIFY(test.window->isPlaying());
        QVERIFY(test.window->liveRun().isRunning());
        QTest::keyClick(&test.canvas(), Qt::Key_Left);
        test.trigger(Act::Stop);
        QVERIFY(!test.window->isPlaying());
        QVERIFY(!test.window->liveRun().isRunning());
        QCOMPARE(test.document().current().level, before);
        QVERIFY(!test.document().canUndo());
        QVERIFY(!test.window->isWindowModified());
    }

    void whilePlayingPlainKeysBelongToTheGame() {
        TestWindow test;
        test.window->openExample();
        test.trigger(Act::Play);
        for (const ActionRow& row : actionRows()) {
            const QAction& action = test.window->actions()[row.id];
            for (const QKeySequence& key : action.shortcuts()) {
                const QKeyCombination stroke = key[0];
                const bool plain = (stroke.keyboardModifiers() & ~Qt::ShiftModifier) == Qt::NoModifier &&
                                   (stroke.key() < Qt::Key_F1 || stroke.key() > Qt::Key_F35);
                const bool callsPanels = row.id == ActionId(Act::HidePanels); // by Tab, which the game has no use for
                const bool yields = (row.flags & YieldsToGame) != 0;          // see aKeyThatTheGameHasMovesNoView
                QVERIFY2(!plain || callsPanels || yields || !action.isEnabled(), qPrintable(action.text()));
            }
        }
        QVERIFY(test.window->actions()[Act::Stop].isEnabled());
        QVERIFY(test.window->actions()[Act::OverlayAabb].isEnabled());
        QVERIFY(!test.window->actions()[Act::Undo].isEnabled());
    }

    void leavingTheGameFromItsMenuBringsTheEditorBack() {
        TestWindow test;
        test.window->openExample();
        test.trigger(Act::Play);
        Q_EMIT test.window->liveView().finished();
        QVERIFY(!test.window->isPlaying());
        QVERIFY(test.window->actions()[ToolId::Edge].isEnabled());
    }

    void theExampleIsSavedUnderAnotherName() {
        TestWindow test;
        test.window->openExample();
        QVERIFY(test.level().objects.size() > 0);
        QVERIFY(test.window->files().path().isEmpty());
        test.toSave = test.file("mine.json");
        test.trigger(Act::Save);
        QCOMPARE(test.window->files().path(), test.toSave);
    }

    void cutAndPasteInPlaceGivesTheSameObjects() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::SelectAll);
        const Object before = test.level().objects[0];
        test.trigger(Act::Cut);
        QCOMPARE(test.level().objects.size(), 0);
        test.trigger(Act::PasteInPlace);
        QCOMPARE(test.level().objects.size(), 1);
        QVERIFY(test.level().objects[0].data == before.data);
        QVERIFY(test.document().selection().contains(test.level().objects[0].key));
    }

    void aDroppedFileIsOpened() {
        TestWindow test;
        Level level;
        level.name = "dropped";
        const QString path = test.file("dropped.json");
        QVERIFY(!writeLevel(path.toStdString(), level));
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(test.window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(test.window.get(), &drop);
        QCOMPARE(test.level().name, std::string("dropped"));
    }

    void everyActionSaysWhatItDoesAndHowItIsReached() {
        TestWindow test;
        QSet<QString> editingKeys;
        QSet<QString> playingKeys;
        for (const ActionRow& row : actionRows()) {
            const QAction& action = test.window->actions()[row.id];
            QVERIFY2(!action.text().isEmpty() && !action.statusTip().isEmpty(), row.text);
            QVERIFY2(!action.shortcuts().isEmpty() || (row.flags & KeyElsewhere) != 0, row.text);
            if (!action.shortcuts().isEmpty()) {
                const QString shown = action.shortcut().toString(QKeySequence::NativeText);
                QVERIFY2(!shown.isEmpty() && action.toolTip().contains(shown), row.text);
            }
            if (*row.icon != '\0') {
                QVERIFY2(!action.icon().isNull(), row.icon);
            }
            for (const QKeySequence& key : action.shortcuts()) {
                for (auto* keys : {&editingKeys, &playingKeys}) {
                    const bool possible =
                        keys == &editingKeys ? (row.flags & OnlyPlaying) == 0 : (row.flags & WhilePlaying) != 0;
                    QVERIFY2(!possible || !keys->contains(key.toString()), qPrintable(key.toString()));
                    if (possible) {
                        keys->insert(key.toString());
                    }
                }
            }
        }
    }

    void thePanelOfNodesIsOpenedFromTheMenu() {
        TestWindow test;
        auto* const dock = test.window->findChild<QDockWidget*>(QStringLiteral("nodes"));
        QVERIFY(dock != nullptr && dock->isHidden());
        dock->toggleViewAction()->trigger();
        QVERIFY(!dock->isHidden() && dock->widget() == &test.window->nodes());
        dock->toggleViewAction()->trigger();
        QVERIFY(dock->isHidden());
    }

    void theOverviewListsEveryKey() {
        const QString overview = KeysDialog::overview({});
        for (const ActionRow& row : actionRows()) {
            for (const QKeySequence& key : keysOf(row)) {
                QVERIFY2(overview.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()), row.text);
            }
        }
        KeyBindings bindings;
        bindings.give(*keyOwner("file/save"), QKeySequence("Ctrl+Alt+F7"));
        QVERIFY(
            KeysDialog::overview(bindings).contains(QKeySequence("Ctrl+Alt+F7").toString(QKeySequence::NativeText)));
    }

    void theFirstWindowFitsTheScreen_data() {
        QTest::addColumn<QSize>("screen");
        QTest::newRow("1366 x 768 less a bar") << QSize(1366, 728);
        QTest::newRow("1920 x 1080 at 150 %, less a bar") << QSize(1280, 680);
        QTest::newRow("800 x 600") << QSize(800, 600);
        QTest::newRow("large") << QSize(3840, 2160);
    }
    void theFirstWindowFitsTheScreen() {
        QFETCH(QSize, screen);
        const QSize size = MainWindow::firstSize(screen);
        QVERIFY(size.width() < screen.width() && size.height() + 30 < screen.height());
        QVERIFY(size.width() <= 1280 && size.height() <= 800);
        QVERIFY(size.width() >= std::min(1200, screen.width() - 40));
        TestWindow test;
        const MainWindow first;
        QCOMPARE(first.size(), MainWindow::firstSize(first.screen()->availableGeometry().size()));
        test.window->resize(size);
        QCOMPARE(test.window->size(), size); // nothing in it asks for more
    }

    void nothingIsCutOffInASmallWindow_data() {
        QTest::addColumn<bool>("selection");
        QTest::newRow("level") << false;
        QTest::newRow("object") << true;
    }
    void nothingIsCutOffInASmallWindow() {
        QFETCH(bool, selection);
        TestWindow test;
        test.drawWalls();
        if (selection) {
            test.trigger(Act::SelectAll);
        }
        test.window->resize(1024, 640);
        QApplication::processEvents();
        QCOMPARE(test.window->size(), QSize(1024, 640));
        QCOMPARE(spacetow::test::cutOffTexts(*test.window), QStringList());
    }
};

SPACETOW_TEST(MainWindowTest)
#include "main_window_test.moc"
