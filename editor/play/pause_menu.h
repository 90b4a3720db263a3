#pragma once
// The menu over a paused game: go on, start again, back to the editor. Works with mouse and keyboard.

#include <QFrame>

class QPushButton;

namespace spacetow {

class PauseMenu : public QFrame {
    Q_OBJECT

  public:
    explicit PauseMenu(QWidget* parent);

    /// Shows the menu in the middle of its parent, with the focus on "Resume".
    void open();
    /// As large as its words need, or smaller with smaller type where the parent has no room.
    void placeIn(const QSize& room);

  signals:
    void resumed();
    void restarted();
    void left();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QPushButton* addButton(const QString& text, const QString& tip);

    QPushButton* m_resume;
};

} // namespace spacetow
