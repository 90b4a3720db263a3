#pragma once
// The shortcut editor: every action and panel with its keys. A key is given by pressing it; who has it already is named
// at once, and may lose it. What is changed holds at once, in all windows, and is remembered.

#include "editor/window/key_bindings.h"
#include "editor/window/key_recorder.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <functional>

namespace spacetow {

/// Which file; empty for none. In place of the desktop's dialogs, so that tests can answer.
struct KeyFileQuestions {
    std::function<QString()> whichToImport;
    std::function<QString()> whereToExport;
};

/// With the desktop's dialogs.
KeyFileQuestions keyFileDialogs(QWidget* parent);

class KeyEditor : public QDialog {
    Q_OBJECT

  public:
    explicit KeyEditor(QWidget* parent = nullptr);

    KeyFileQuestions questions;

    const KeyBindings& bindings() const { return m_bindings; }
    /// Marks the row of this owner.
    void choose(const QString& code);
    /// What is said about the key that was pressed, or the file that was read.
    QString note() const { return m_note.text(); }

    QLineEdit& filter() { return m_filter; }
    QComboBox& presets() { return m_presets; }
    QTreeWidget& tree() { return m_tree; }
    KeyRecorder& recorder() { return m_recorder; }
    QPushButton& takeOver() { return m_takeOver; }
    QPushButton& resetOne() { return m_resetOne; }
    QPushButton& undo() { return m_undo; }
    /// One for each key of the chosen owner, which takes it away.
    QList<QPushButton*> keyButtons() const { return m_keyButtons; }
    void importKeys();
    void exportKeys();

  private:
    void layOut();
    void layOutKeys();
    void fill();
    void addMenuKey(QTreeWidgetItem& game);
    void showKeys(const KeyOwner& owner, QTreeWidgetItem& row) const;
    void showFiltered();
    void showChosen();
    const KeyOwner* chosen() const;
    void consider(const QKeySequence& pressed);
    void give(const QKeySequence& key);
    /// Puts the keys on all windows.
    void change(const KeyBindings& bindings);
    void apply(const KeyBindings& bindings);
    void say(const QString& text, bool isFault);

    KeyBindings m_bindings;
    std::vector<KeyBindings> m_before; // for undo
    QVBoxLayout m_column;
    QHBoxLayout m_top;
    QLineEdit m_filter;
    QComboBox m_presets;
    QTreeWidget m_tree;
    QHBoxLayout m_keys;
    QLabel m_name;
    QList<QPushButton*> m_keyButtons; // owned by the dialog
    KeyRecorder m_recorder;
    QPushButton m_takeOver;
    QPushButton m_resetOne;
    QHBoxLayout m_notes;
    QLabel m_note;
    QDialogButtonBox m_buttons;
    QPushButton m_undo;
};

} // namespace spacetow
