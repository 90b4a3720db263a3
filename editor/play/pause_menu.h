#pragma once
// The menu over a game that is held: go on, start again, back to the editor. Works with mouse and keyboard.

#include "core/game/snapshot.h"
#include "editor/play/key_map.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace spacetow {

class PauseMenu : public QFrame {
    Q_OBJECT

  public:
    explicit PauseMenu(QWidget* parent);

    /// Shows the menu in the middle of its parent, with the focus on what one most likely wants. It says what has
    /// happened in the game.
    void openFor(Phase phase);
    /// As large as its words need, or smaller with smaller type where the parent has no room.
    void placeIn(const QSize& room);
    void setKeys(const PlayKeys& keys);

  signals:
    void resumed();
    void restarted();
    void left();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QPushButton* addButton(const QString& text);

    PlayKeys m_keys;
    QLabel* m_title;
    QPushButton* m_resume;
    QPushButton* m_restart;
};

} // namespace spacetow
