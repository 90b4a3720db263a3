#pragma once
// A game in a canvas, whose time the test makes pass.

#include "editor/play/live_view.h"
#include "tests/support/game_levels.h"

#include <QPushButton>
#include <QTest>

namespace spacetow::test {

/// A canvas with a manual runner: nothing moves but by `run`. The game begins as from the welcome page, with the
/// classic view.
class Game {
  public:
    explicit Game(const Level& level = openSpace(), const QSize& size = {880, 660},
                  LiveRun::Kind kind = LiveRun::Kind::Game)
        : m_document(level), m_toolbox(m_document, 1), m_canvas(m_document, m_toolbox),
          m_run(nullptr, Runner::Mode::Manual), m_live(m_document, m_toolbox, m_canvas, m_run) {
        m_toolbox.snap.grid = m_toolbox.snap.smart = false;
        m_canvas.resize(size);
        m_canvas.show();
        start(level, kind);
    }
    ~Game() {
        m_run.stop();
        m_live.hide();
    }
    void start(const Level& level, LiveRun::Kind kind = LiveRun::Kind::Game, bool anew = true) {
        m_live.hide();
        m_run.start(level, kind);
        m_live.show(level, anew);
        m_canvas.setFocus();
        m_live.refresh();
    }
    Canvas& view() { return m_canvas; }
    LiveRun& live() { return m_run; }
    LiveView& scene() { return m_live; }
    Document& document() { return m_document; }
    Toolbox& toolbox() { return m_toolbox; }
    Phase phase() { return picture()->phase; }
    std::shared_ptr<const Snapshot> picture() { return m_run.runner()->frame()->now; }
    const BodyPicture& body(Key key) {
        const BodyPicture* const found =
            picture()->find([key](const BodyPicture& one) { return one.look->key == key; });
        EXPECTS(found != nullptr);
        return *found;
    }
    /// As it is shown now.
    Viewport viewport() {
        m_live.refresh();
        return m_canvas.view();
    }
    void run(int updates) { m_run.runner()->advance(updates); }
    void tap(Qt::Key key) {
        QTest::keyPress(&m_canvas, key);
        run(1);
        QTest::keyRelease(&m_canvas, key);
        run(1);
    }
    QPoint at(const Vec2& world) {
        const Vec2 screen = viewport().toScreen(world);
        return {qRound(screen.x()), qRound(screen.y())};
    }
    void drag(const Vec2& from, const Vec2& to) {
        QTest::mouseMove(&m_canvas, at(from));
        QTest::mousePress(&m_canvas, Qt::LeftButton, {}, at(from));
        QTest::mouseMove(&m_canvas, at(0.5 * (from + to)));
        QTest::mouseMove(&m_canvas, at(to));
        QTest::mouseRelease(&m_canvas, Qt::LeftButton, {}, at(to));
    }
    QWidget* menu() { return m_canvas.findChild<QWidget*>("pauseMenu"); }
    QPushButton* button(const QString& text) {
        for (auto* button : m_canvas.findChildren<QPushButton*>()) {
            if (button->text() == text) {
                return button;
            }
        }
        return nullptr;
    }

  private:
    Document m_document;
    Toolbox m_toolbox;
    Canvas m_canvas;
    LiveRun m_run;
    LiveView m_live;
};

} // namespace spacetow::test
