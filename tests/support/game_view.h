#pragma once
// A game in a view, whose time the test makes pass.

#include "editor/play/play_view.h"
#include "tests/support/game_levels.h"

#include <QPushButton>
#include <QTest>

namespace spacetow::test {

/// A view with a manual runner: nothing moves but by `run`.
class Game {
  public:
    explicit Game(const Level& level = openSpace(), const QSize& size = {880, 660})
        : m_view(nullptr, Runner::Mode::Manual) {
        m_view.resize(size);
        m_view.show();
        m_view.start(level);
    }
    PlayView& view() { return m_view; }
    Phase phase() { return picture()->phase; }
    std::shared_ptr<const Snapshot> picture() { return m_view.runner()->frame()->now; }
    void run(int updates) { m_view.runner()->advance(updates); }
    void tap(Qt::Key key) {
        QTest::keyPress(&m_view, key);
        run(1);
        QTest::keyRelease(&m_view, key);
        run(1);
    }
    QWidget* menu() { return m_view.findChild<QWidget*>("pauseMenu"); }
    QPushButton* button(const QString& text) {
        for (auto* button : m_view.findChildren<QPushButton*>()) {
            if (button->text() == text) {
                return button;
            }
        }
        return nullptr;
    }

  private:
    PlayView m_view;
};

} // namespace spacetow::test
