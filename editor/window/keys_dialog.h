#pragma once
// The overview of keys, made from the table of actions and a few lines about mouse and game.

#include "editor/window/key_bindings.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace spacetow {

class KeysDialog : public QDialog {
    Q_OBJECT

  public:
    explicit KeysDialog(const KeyBindings& bindings, QWidget* parent = nullptr);

    /// Every action and panel that has a key stands in it.
    static QString overview(const KeyBindings& bindings);

  private:
    QVBoxLayout m_column;
    QTextBrowser m_text;
    QDialogButtonBox m_buttons;
};

} // namespace spacetow
