#pragma once
// The program's window for tests: with preferences and files of its own, questions answered in advance, and the mouse
// in metres. Nothing of it waits for time to pass.

#include "editor/window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <vector>

namespace spacetow::test {

class TestWindow {
  public:
    TestWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath(QStringLiteral("settings")));
        QCoreApplication::setOrganizationName(QStringLiteral("spacetow-test"));
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
        makeWindow();
        window->resize(1280, 800);
        show();
    }
    ~TestWindow() { unsaved = Unsaved::Discard; }

    /// As if the program were started again, with what it remembers.
    void reopen() {
        window.reset();
        makeWindow();
        show();
    }

    QString file(const QString& name) const { return m_folder.filePath(name); }
    Canvas& canvas() { return window->canvas(); }
    Document& document() { return window->document(); }
    const Level& level() { return window->document().level(); }
    void trigger(ActionId id) { window->actions()[id].trigger(); }

    QPoint at(double x, double y) {
        const Vec2 screen = canvas().view().toScreen(Vec2(x, y));
        return {qRound(screen.x()), qRound(screen.y())};
    }
    void click(double x, double y) {
        QTest::mouseMove(&canvas(), at(x, y));
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(x, y));
    }
    void drag(double fromX, double fromY, double toX, double toY) {
        QTest::mouseMove(&canvas(), at(fromX, fromY));
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(fromX, fromY));
        QTest::mouseMove(&canvas(), at(0.5 * (fromX + toX), 0.5 * (fromY + toY)));
        QTest::mouseMove(&canvas(), at(toX, toY));
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(toX, toY));
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window.get(), key,
                        modifiers);
    }
    /// A square of one-way walls about the origin.
    void drawWalls() {
        trigger(ToolId::Edge);
        click(-2, -2);
        click(2, -2);
        click(2, 2);
        key(Qt::Key_Return);
        trigger(ToolId::Select);
    }

    /// Keys 1 and 2, each a ball about the origin.
    static Level twoBallsAtOneSpot() {
        Level level;
        for (const Key key : {Key{1}, Key{2}}) {
            Object ball;
            ball.key = key;
            ball.data = BodyObject{.shapes = {Circle{{0, 0}, 0.5}}};
            level.objects.append(ball);
        }
        return level;
    }

    QString toOpen;
    QString toSave;
    Unsaved unsaved = Unsaved::Cancel;
    int asked = 0;
    std::unique_ptr<MainWindow> window;

  private:
    void makeWindow() {
        window = std::make_unique<MainWindow>();
        window->files().questions = {
            [this](const QString&) { return toOpen.isEmpty() ? QStringList() : QStringList{toOpen}; },
            [this](const QString&) { return toSave; },
            [this](const QString&) {
                ++asked;
                return unsaved;
            }};
    }
    void show() {
        window->show();
        window->activateWindow();
        QApplication::processEvents();
        window->toolbox().snap.grid = false;
    }

    QTemporaryDir m_folder;
};

/// What stands outside of the bar, or in it on something else.
inline QStringList misplacedIn(const QWidget& bar) {
    QStringList found;
    QList<QRect> taken;
    for (const QWidget* child : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        const QRect place = child->geometry();
        if (!child->isVisible()) {
            continue;
        }
        if (!bar.rect().contains(place) ||
            std::ranges::any_of(taken, [&](const QRect& other) { return other.intersects(place); })) {
            found << QStringLiteral("%1 at %2, %3").arg(child->metaObject()->className()).arg(place.x()).arg(place.y());
        }
        taken << place;
    }
    return found;
}

/// What the visible labels and buttons of the window say of which a part is cut off.
inline QStringList cutOffTexts(const QWidget& window) {
    QStringList texts;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        // The hint is shortened on purpose and says all of itself in its tooltip.
        const bool shortened = label != nullptr && !label->toolTip().isEmpty();
        if (!widget->isVisible() || (label == nullptr && button == nullptr) || shortened) {
            continue;
        }
        const QString text = label != nullptr ? label->text() : button->text();
        const bool wraps = label != nullptr && label->wordWrap();
        const QSize wanted = widget->minimumSizeHint();
        const int height = wraps ? label->heightForWidth(label->width()) : wanted.height();
        // What says nothing is an icon, sized by the style.
        if (!text.isEmpty() && (widget->height() < height || (!wraps && widget->width() < wanted.width()))) {
            texts << text;
        }
    }
    return texts;
}

} // namespace spacetow::test
