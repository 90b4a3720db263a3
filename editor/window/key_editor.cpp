#include "editor/window/key_editor.h"

#include "editor/canvas/palette.h"
#include "editor/window/fuzzy_query.h"
#include "editor/window/main_window.h"
#include "editor/window/screen_room.h"

#include <QApplication>
#include <QHeaderView>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int codeRole = Qt::UserRole;
constexpr QSize editorSize(760, 640);

QString keysShown(const QList<QKeySequence>& keys) {
    QStringList shown;
    for (const QKeySequence& key : keys) {
        shown << key.toString(QKeySequence::NativeText);
    }
    return shown.join(QStringLiteral(" · "));
}

QFont boldIf(bool bold, QFont font) {
    font.setBold(bold);
    return font;
}

} // namespace

KeyEditor::KeyEditor(QWidget* parent)
    : QDialog(parent), questions(keyFileDialogs(this)), m_bindings(Preferences().keyBindings()), m_column(this),
      m_buttons(QDialogButtonBox::Close) {
    setWindowTitle(tr("Keyboard Shortcuts"));
    layOut();
    fill();
    connect(&m_filter, &QLineEdit::textChanged, this, &KeyEditor::showFiltered);
    connect(&m_tree, &QTreeWidget::currentItemChanged, this, [this] { showChosen(); });
    connect(&m_tree, &QTreeWidget::itemActivated, &m_recorder, [this] { m_recorder.setFocus(); });
    connect(&m_recorder, &KeyRecorder::recorded, this, &KeyEditor::consider);
    connect(&m_takeOver, &QPushButton::clicked, this, [this] { give(spelledFor(*chosen(), m_recorder.key())); });
    connect(&m_resetOne, &QPushButton::clicked, this, [this] {
        KeyBindings bindings = m_bindings;
        bindings.reset(*chosen());
        change(bindings);
    });
    connect(&m_presets, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(keyPresets().size())) {
            change(keyPresets()[static_cast<std::size_t>(index)].make());
        } else {
            apply(m_bindings); // there is nothing to choose: these come of changing keys
        }
    });
    connect(&m_undo, &QPushButton::clicked, this, [this] {
        const KeyBindings before = m_before.back();
        m_before.pop_back();
        apply(before);
    });
    connect(&m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showChosen();
    m_filter.setFocus();
    resizeWithinScreen(*this, editorSize);
}

void KeyEditor::layOut() {
    m_filter.setPlaceholderText(tr("Find an action or a key"));
    m_filter.setAccessibleName(m_filter.placeholderText());
    m_filter.setClearButtonEnabled(true);
    for (const KeyPreset& preset : keyPresets()) {
        m_presets.addItem(QString::fromUtf8(preset.name));
    }
    m_presets.addItem(tr("My own"));
    m_presets.setAccessibleName(tr("Keys as in"));
    m_presets.setToolTip(tr("Take all keys from a program that you know"));
    auto* const presetLabel = new QLabel(tr("Keys as &in"), this); // owned by the dialog, as are those below
    presetLabel->setBuddy(&m_presets);
    m_top.addWidget(&m_filter, 1);
    m_top.addWidget(presetLabel);
    m_top.addWidget(&m_presets);
    m_column.addLayout(&m_top);

    m_tree.setHeaderLabels({tr("Action"), tr("Keys")});
    m_tree.setRootIsDecorated(true);
    m_tree.setUniformRowHeights(true);
    m_tree.header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree.header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree.header()->setStretchLastSection(false);
    m_column.addWidget(&m_tree, 1);
    layOutKeys();

    auto* const import = m_buttons.addButton(tr("&Import…"), QDialogButtonBox::ActionRole);
    auto* const exporting = m_buttons.addButton(tr("&Export…"), QDialogButtonBox::ActionRole);
    auto* const resetAll = m_buttons.addButton(tr("Reset &All"), QDialogButtonBox::ActionRole);
    connect(resetAll, &QPushButton::clicked, this, [this] { change(KeyBindings()); });
    m_undo.setText(tr("&Undo"));
    m_undo.setToolTip(tr("Take back the last change of keys"));
    m_buttons.addButton(&m_undo, QDialogButtonBox::ActionRole);
    for (QAbstractButton* button : m_buttons.buttons()) {
        static_cast<QPushButton*>(button)->setAutoDefault(false);
    }
    connect(import, &QPushButton::clicked, this, &KeyEditor::importKeys);
    connect(exporting, &QPushButton::clicked, this, &KeyEditor::exportKeys);
    m_column.addWidget(&m_buttons);
}

/// What is done to the keys of the chosen action.
void KeyEditor::layOutKeys() {
    m_name.setTextFormat(Qt::PlainText);
    m_recorder.setMaximumWidth(180);
    m_takeOver.setText(tr("&Take It Over"));
    m_takeOver.setAutoDefault(false);
    m_resetOne.setText(tr("&Reset"));
    m_resetOne.setToolTip(tr("Give this action the keys that it came with"));
    m_resetOne.setAutoDefault(false);
    m_keys.addWidget(&m_name);
    m_keys.addStretch(1);
    m_keys.addWidget(&m_recorder);
    m_keys.addWidget(&m_resetOne);
    m_column.addLayout(&m_keys);
    m_note.setWordWrap(true);
    m_note.setTextFormat(Qt::PlainText);
    m_notes.addWidget(&m_note, 1);
    m_notes.addWidget(&m_takeOver);
    m_column.addLayout(&m_notes);
}

void KeyEditor::fill() {
    QTreeWidgetItem* group = nullptr;
    for (const KeyOwner& owner : keyOwners()) {
        if (group == nullptr || group->text(0) != owner.place) {
            group = nullptr;
            for (int i = 0; i < m_tree.topLevelItemCount() && group == nullptr; ++i) {
                group = m_tree.topLevelItem(i)->text(0) == owner.place ? m_tree.topLevelItem(i) : nullptr;
            }
        }
        if (group == nullptr) {
            group = new QTreeWidgetItem(&m_tree, {owner.place}); // owned by the tree, as are the others
            group->setFlags(Qt::ItemIsEnabled);
            group->setFirstColumnSpanned(true);
        }
        auto* const row = new QTreeWidgetItem(group, {owner.name});
        row->setData(0, codeRole, owner.code);
    }
    addMenuKey(*group); // the keys of the game come last
    m_tree.expandAll();
    apply(m_bindings);
    m_tree.setCurrentItem(m_tree.topLevelItem(0)->child(0));
}

/// The only one that stays as it is.
void KeyEditor::addMenuKey(QTreeWidgetItem& game) {
    auto* const row =
        new QTreeWidgetItem(&game, {QCoreApplication::translate("Keys", "Hold the game and show the menu"),
                                    QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText)});
    row->setFlags(Qt::ItemIsEnabled);
    row->setToolTip(0, tr("This key cannot be changed, so that there is always a way out of the game."));
}

void KeyEditor::showKeys(const KeyOwner& owner, QTreeWidgetItem& row) const {
    row.setText(1, keysShown(m_bindings.keys(owner)));
    row.setFont(1, boldIf(!m_bindings.isUsual(owner), m_tree.font()));
}

void KeyEditor::showFiltered() {
    const FuzzyQuery query(m_filter.text());
    const QString key = folded(m_filter.text().trimmed());
    for (int i = 0; i < m_tree.topLevelItemCount(); ++i) {
        QTreeWidgetItem& group = *m_tree.topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group.childCount(); ++j) {
            QTreeWidgetItem& row = *group.child(j);
            const bool found = query.isEmpty() || query.score(row.text(0)) || folded(row.text(1)).contains(key);
            row.setHidden(!found);
            any = any || found;
        }
        group.setHidden(!any);
    }
}

const KeyOwner* KeyEditor::chosen() const {
    const QTreeWidgetItem* const row = m_tree.currentItem();
    return row == nullptr ? nullptr : keyOwner(row->data(0, codeRole).toString());
}

void KeyEditor::choose(const QString& code) {
    for (QTreeWidgetItemIterator row(&m_tree); *row != nullptr; ++row) {
        if ((*row)->data(0, codeRole).toString() == code) {
            m_tree.setCurrentItem(*row);
        }
    }
}

void KeyEditor::showChosen() {
    const KeyOwner* const owner = chosen();
    qDeleteAll(m_keyButtons);
    m_keyButtons.clear();
    m_recorder.forget();
    m_recorder.setEnabled(owner != nullptr);
    m_resetOne.setEnabled(owner != nullptr && !m_bindings.isUsual(*owner));
    m_takeOver.hide();
    say(QString(), false);
    m_name.setText(owner != nullptr ? owner->name : QString());
    if (owner == nullptr) {
        return;
    }
    for (const QKeySequence& key : m_bindings.keys(*owner)) {
        const QString shown = key.toString(QKeySequence::NativeText);
        auto* const button =
            new QPushButton(QStringLiteral("%1  ✕").arg(shown).replace(QLatin1Char('&'), QStringLiteral("&&")), this);
        button->setAutoDefault(false);
        button->setToolTip(tr("Take %1 away").arg(shown).toHtmlEscaped());
        button->setAccessibleName(tr("Take %1 away").arg(shown));
        connect(
            button, &QPushButton::clicked, this,
            [this, key] {
                KeyBindings bindings = m_bindings;
                bindings.take(*chosen(), key);
                m_recorder.setFocus(); // the button is about to go
                change(bindings);
            },
            Qt::QueuedConnection);
        m_keys.insertWidget(1 + static_cast<int>(m_keyButtons.size()), button);
        m_keyButtons << button;
    }
}

/// A key that is free is given at once.
void KeyEditor::consider(const QKeySequence& pressed) {
    const KeyOwner* const owner = chosen();
    m_takeOver.hide();
    if (owner == nullptr) {
        return;
    }
    const QKeySequence key = spelledFor(*owner, pressed);
    if (const QString objection = objectionTo(key, *owner); !objection.isEmpty()) {
        say(objection, true);
        return;
    }
    const KeyOwner* const before = m_bindings.ownerBeside(*owner, key);
    const QString shown = key.toString(QKeySequence::NativeText);
    if (before != nullptr && before->code != owner->code) {
        say(tr("%1 leads to “%2” (%3).").arg(shown, before->name, before->place), true);
        m_takeOver.show();
        return;
    }
    give(key);
}

void KeyEditor::give(const QKeySequence& key) {
    const KeyOwner* const owner = chosen();
    const KeyOwner* const before = m_bindings.ownerBeside(*owner, key);
    KeyBindings bindings = m_bindings;
    bindings.give(*owner, key);
    change(bindings);
    const QString shown = key.toString(QKeySequence::NativeText);
    say(before != nullptr && before->code != owner->code
            ? tr("%1 leads to “%2” now, and no longer to “%3”.").arg(shown, owner->name, before->name)
            : tr("%1 leads to “%2” now.").arg(shown, owner->name),
        false);
}

void KeyEditor::change(const KeyBindings& bindings) {
    if (bindings != m_bindings) {
        m_before.push_back(m_bindings);
        apply(bindings);
    }
}

void KeyEditor::apply(const KeyBindings& bindings) {
    m_bindings = bindings;
    Preferences().setKeyBindings(bindings);
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* const window = qobject_cast<MainWindow*>(widget)) {
            window->updateKeys();
        }
    }
    for (QTreeWidgetItemIterator row(&m_tree); *row != nullptr; ++row) {
        if (const KeyOwner* const owner = keyOwner((*row)->data(0, codeRole).toString())) {
            showKeys(*owner, **row);
        }
    }
    const auto presets = keyPresets();
    const auto preset = std::ranges::find_if(presets, [&](const KeyPreset& one) { return one.make() == m_bindings; });
    m_presets.setCurrentIndex(static_cast<int>(preset - presets.begin()));
    m_undo.setEnabled(!m_before.empty());
    showChosen();
    showFiltered();
}

void KeyEditor::say(const QString& text, bool isFault) {
    QPalette colors = palette();
    if (isFault) {
        colors.setColor(QPalette::WindowText, markColors(shadeOf(colors)).warning);
    }
    m_note.setPalette(colors);
    m_note.setText(text);
}

} // namespace spacetow
