#pragma once
// A field that takes the next key in place of typing it.

#include <QKeySequence>
#include <QLineEdit>

namespace spacetow {

class KeyRecorder : public QLineEdit {
    Q_OBJECT

  public:
    explicit KeyRecorder(QWidget* parent = nullptr);

    /// What was pressed last; empty after clear().
    const QKeySequence& key() const { return m_key; }
    void forget();

  Q_SIGNALS:
    void recorded(const QKeySequence& key);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    QKeySequence m_key;
};

/// As a shortcut has to be spelled to be hit by this stroke; empty for a modifier by itself.
QKeySequence keyOfStroke(const QKeyEvent& stroke);

} // namespace spacetow
