#pragma once
// The overview of keys, made from the table of actions and a few lines about mouse and game.

#include "editor/window/key_bindings.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace spacetow {

class KeysDialog : public QDialog {
    Q_OBJECT

  public:
    explicit KeysDialog(const KeyBindings& bindings, QWidget* parent = nullptr);

    /// Every action and panel that has a key stands in it; with a filter, those lines that hold all its words.
    static QString overview(const KeyBindings& bindings, const QString& filter = {});
    QLineEdit& search() { return m_search; }
    const QTextBrowser& text() const { return m_text; }

  private:
    QVBoxLayout m_column;
    QLineEdit m_search;
    QTextBrowser m_text;
    QDialogButtonBox m_buttons;
};

} // namespace spacetow
