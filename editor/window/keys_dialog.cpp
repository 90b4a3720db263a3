#include "editor/window/keys_dialog.h"

#include "editor/window/screen_room.h"

#include <QCoreApplication>

#include <array>

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
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Shift while dragging"), QT_TRANSLATE_NOOP("Keys", "Keep to an axis, or to steps of 15°")},
    KeyLine{QT_TRANSLATE_NOOP("Keys", "Ctrl while dragging"), QT_TRANSLATE_NOOP("Keys", "Switch snapping off or on for the moment")},
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

QString line(const QString& keys, const QString& meaning) {
    return QStringLiteral("<tr><td style=\"padding-right:24px\"><b>%1</b></td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
}

/// Of the game, or of all the others.
QString linesOf(const KeyBindings& bindings, bool ofGame) {
    QString html;
    QString place;
    for (const KeyOwner& owner : keyOwners()) {
        QStringList keys;
        for (const QKeySequence& key : bindings.keys(owner)) {
            keys << key.toString(QKeySequence::NativeText);
        }
        if (keys.isEmpty() || (owner.inGame != PlayKey::None) != ofGame) {
            continue;
        }
        if (place != owner.place) {
            html += heading(owner.place);
            place = owner.place;
        }
        html += line(keys.join(QStringLiteral(" · ")), owner.name);
    }
    return html;
}

} // namespace

QString KeysDialog::overview(const KeyBindings& bindings) {
    QString html = QStringLiteral("<table cellpadding=\"2\">");
    html += heading(translatedKeys(QT_TRANSLATE_NOOP("Keys", "On the drawing board")));
    for (const KeyLine& each : canvasLines) {
        html += line(translatedKeys(each.keys), translatedKeys(each.meaning));
    }
    html += linesOf(bindings, true);
    // This one cannot be changed.
    html += line(escapeKey(), translatedKeys(QT_TRANSLATE_NOOP("Keys", "Hold the game and show the menu")));
    html += linesOf(bindings, false);
    return html + QStringLiteral("</table>");
}

KeysDialog::KeysDialog(const KeyBindings& bindings, QWidget* parent)
    : QDialog(parent), m_column(this), m_buttons(QDialogButtonBox::Close) {
    setWindowTitle(tr("Keys"));
    m_text.setHtml(overview(bindings));
    m_text.setFrameShape(QFrame::NoFrame);
    m_column.addWidget(&m_text);
    m_column.addWidget(&m_buttons);
    connect(&m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resizeWithinScreen(*this, {680, 620});
}

} // namespace spacetow
