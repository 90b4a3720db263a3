#include "editor/window/keys_dialog.h"

#include "editor/window/screen_room.h"

#include <QCoreApplication>
#include <QShortcut>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace spacetow {

namespace {

struct KeyLine {
    const char* keys;
    const char* meaning;
};

// clang-format off
constexpr std::array canvasLines{
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Click · Shift or Ctrl + click"), QT_TRANSLATE_NOOP("Keys", "Select · add to the selection or take from it")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Drag on empty space"), QT_TRANSLATE_NOOP("Keys", "Select with a rubber band; Alt or B: only what lies wholly inside")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Alt + click · B + click"), QT_TRANSLATE_NOOP("Keys", "Select the next object underneath; a right click lists them all")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Alt + drag · B + drag"), QT_TRANSLATE_NOOP("Keys", "Move the selection from anywhere")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Shift · Ctrl while moving or drawing"), QT_TRANSLATE_NOOP("Keys", "Keep to an axis or to steps of 15° · switch snapping off or on for the moment")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Shift · Ctrl while drawing a rectangle"), QT_TRANSLATE_NOOP("Keys", "From its middle · a square")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Shift · Ctrl · Alt while scaling"), QT_TRANSLATE_NOOP("Keys", "About the middle · keep the proportions · switch snapping off or on")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Shift · Ctrl while turning"), QT_TRANSLATE_NOOP("Keys", "About the opposite corner · in steps of 15°")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Enter or right click"), QT_TRANSLATE_NOOP("Keys", "End the shape that is being drawn")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Backspace"), QT_TRANSLATE_NOOP("Keys", "Take back the last point")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Esc"), QT_TRANSLATE_NOOP("Keys", "Cancel: gesture, shape, selection, tool")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Arrow keys"), QT_TRANSLATE_NOOP("Keys", "Move the selection a little; Shift: a grid step; Alt: a pixel")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Wheel · pinch"), QT_TRANSLATE_NOOP("Keys", "Zoom at the pointer")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Middle or right drag · Space + drag · two fingers"), QT_TRANSLATE_NOOP("Keys", "Move the view")},
};
// clang-format on

QString translatedKeys(const char* words) {
    return QCoreApplication::translate("Keys", words);
}

QString escapeKey() {
    return QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText);
}

QString heading(const QString& words) {
    return QStringLiteral("<tr><td colspan=\"2\"><h3>%1</h3></td></tr>").arg(words.toHtmlEscaped());
}

/// The lines below one heading of which something is left by a search for these words; empty when nothing is.
class Section {
  public:
    Section(const QString& title, const QStringList& wanted) : m_title(title), m_wanted(wanted) {}

    void add(const QString& keys, const QString& meaning) {
        const QString all = m_title + QLatin1Char(' ') + keys + QLatin1Char(' ') + meaning;
        if (std::ranges::all_of(m_wanted,
                                [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); })) {
            m_lines += line(keys, meaning);
        }
    }
    QString html() const { return m_lines.isEmpty() ? QString() : heading(m_title) + m_lines; }

  private:
    static QString line(const QString& keys, const QString& meaning);

    QString m_title;
    QStringList m_wanted;
    QString m_lines;
};

QString Section::line(const QString& keys, const QString& meaning) {
    return QStringLiteral("<tr><td style=\"padding-right:24px\"><b>%1</b></td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
}

struct Overview {
    const KeyBindings& bindings;
    QStringList wanted;
    QString html = {};

    /// Of the game, or of all the others; `finish` adds to the last section.
    void addOwners(bool ofGame, const std::function<void(Section&)>& finish = {}) {
        std::optional<Section> section;
        QString place;
        for (const KeyOwner& owner : keyOwners()) {
            QStringList keys;
            for (const QKeySequence& key : bindings.keys(owner)) {
                keys << key.toString(QKeySequence::NativeText);
            }
            if (keys.isEmpty() || (owner.inGame != PlayKey::None) != ofGame) {
                continue;
            }
            if (!section || place != owner.place) {
                html += section ? section->html() : QString();
                section.emplace(owner.place, wanted);
                place = owner.place;
            }
            section->add(keys.join(QStringLiteral(" · ")), owner.name);
        }
        if (section) {
            if (finish) {
                finish(*section);
            }
            html += section->html();
        }
    }
};

} // namespace

QString KeysDialog::overview(const KeyBindings& bindings, const QString& filter) {
    Overview all{bindings, filter.split(QLatin1Char(' '), Qt::SkipEmptyParts)};
    Section canvas(translatedKeys(QT_TRANSLATE_NOOP("Keys", "On the drawing board")), all.wanted);
    for (const KeyLine& each : canvasLines) {
        canvas.add(translatedKeys(each.keys), translatedKeys(each.meaning));
    }
    all.html = canvas.html();
    all.addOwners(true, [](Section& game) { // this one cannot be changed
        game.add(escapeKey(), translatedKeys(QT_TRANSLATE_NOOP("Keys", "Hold the game and show the menu")));
    });
    all.addOwners(false);
    return QStringLiteral("<table cellpadding=\"2\">") + all.html + QStringLiteral("</table>");
}

KeysDialog::KeysDialog(const KeyBindings& bindings, QWidget* parent)
    : QDialog(parent), m_column(this), m_buttons(QDialogButtonBox::Close) {
    setWindowTitle(tr("Keys"));
    m_search.setPlaceholderText(tr("Search: a word, or a key as it is written"));
    m_search.setAccessibleName(tr("Search"));
    m_search.setClearButtonEnabled(true);
    m_text.setFrameShape(QFrame::NoFrame);
    m_column.addWidget(&m_search);
    m_column.addWidget(&m_text);
    const auto refill = [this, bindings] {
        const QString html = overview(bindings, m_search.text());
        m_text.setHtml(html.contains(QLatin1String("<tr>")) ? html : tr("No key does anything of that name."));
    };
    refill();
    connect(&m_search, &QLineEdit::textChanged, this, refill);
    auto* const find = new QShortcut(QKeySequence::Find, this); // owned by it
    connect(find, &QShortcut::activated, this, [this] {
        m_search.setFocus(Qt::ShortcutFocusReason);
        m_search.selectAll();
    });
    m_search.setFocus();
    m_column.addWidget(&m_buttons);
    connect(&m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resizeWithinScreen(*this, {680, 620});
}

} // namespace spacetow
