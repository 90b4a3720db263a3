#include "editor/play/pause_menu.h"

#include "editor/canvas/key_place.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace spacetow {
namespace {

constexpr int normalType = 15, smallestType = 7; // pixels

QString styleFor(int type) {
    return QStringLiteral("spacetow--PauseMenu { background: rgba(10, 20, 38, 235); border: 1px solid #5a6f96;"
                          " border-radius: %1px; }"
                          "QLabel { color: #ffffff; font-size: %2px; font-weight: bold; background: transparent; }"
                          "QPushButton { color: #e2e8f2; background: #22304c; border: 2px solid #4a5f86;"
                          " border-radius: %3px; padding: %3px %4px; font-size: %5px; outline: none; }"
                          "QPushButton:hover { background: #2c4068; }"
                          "QPushButton:focus { border: 2px solid #54b4ff; background: #2c4068; }"
                          "QPushButton:pressed { background: #1a2740; }")
        .arg(type * 2 / 3)
        .arg(type * 4 / 3)
        .arg(type * 2 / 5)
        .arg(type * 3 / 2)
        .arg(type);
}

QString titleFor(Phase phase) {
    switch (phase) {
    case Phase::Won:
        return PauseMenu::tr("You made it!");
    case Phase::Crashed:
        return PauseMenu::tr("Crashed");
    case Phase::GameOver:
        return PauseMenu::tr("Game over");
    default:
        return PauseMenu::tr("Paused");
    }
}

QString withKey(const QString& text, const QString& key) {
    return key.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, key);
}

} // namespace

PauseMenu::PauseMenu(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("pauseMenu"));
    auto* layout = new QVBoxLayout(this); // owned by this widget, as are all children
    m_title = new QLabel(this);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setAlignment(Qt::AlignCenter);
    layout->addWidget(m_title);
    m_resume = addButton(tr("Resume"));
    m_restart = addButton(tr("Restart"));
    QPushButton* leave = addButton(tr("Back to the editor"));
    leave->setToolTip(tr("Stop playing"));
    connect(m_resume, &QPushButton::clicked, this, &PauseMenu::resumed);
    connect(m_restart, &QPushButton::clicked, this, &PauseMenu::restarted);
    connect(leave, &QPushButton::clicked, this, &PauseMenu::left);
    setKeys({});
    hide();
}

void PauseMenu::setKeys(const PlayKeys& keys) {
    m_keys = keys;
    m_resume->setToolTip(withKey(tr("Go on playing"), QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText)));
    m_restart->setToolTip(withKey(tr("Start the level over"), keys.shown(PlayKey::Restart)));
}

QPushButton* PauseMenu::addButton(const QString& text) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    button->setFocusPolicy(Qt::StrongFocus);
    layout()->addWidget(button);
    return button;
}

void PauseMenu::openFor(Phase phase) {
    const QString title = titleFor(phase);
    m_title->setText(title);
    setAccessibleName(title);
    m_resume->setVisible(phase != Phase::Won); // there is nothing left to go on with
    show();                                    // first, because only then are the buttons as large as they will be
    placeIn(parentWidget()->size());
    raise();
    (phase == Phase::Won ? m_restart : m_resume)->setFocus(Qt::OtherFocusReason);
}

void PauseMenu::placeIn(const QSize& room) {
    for (int type = normalType; type >= smallestType; --type) {
        setStyleSheet(styleFor(type));
        layout()->setContentsMargins(type, type, type, type);
        layout()->setSpacing(type / 2);
        ensurePolished();
        layout()->invalidate();
        const QSize wanted = sizeHint(); // of the layout, with the frame
        if (type == smallestType || (wanted.width() <= room.width() - 8 && wanted.height() <= room.height() - 8)) {
            resize(wanted);
            break;
        }
    }
    move((room.width() - width()) / 2, (room.height() - height()) / 2);
}

bool PauseMenu::event(QEvent* event) {
    // Plain keys are the menu's, even where the window has a shortcut on the same letter.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
        if (plain && (key->key() < Qt::Key_F1 || key->key() > Qt::Key_F35)) {
            event->accept();
            return true;
        }
    }
    return QFrame::event(event);
}

void PauseMenu::keyPressEvent(QKeyEvent* event) {
    const int key = latinKey(*event);
    const PlayKey meaning = m_keys.meaningOf(*event);
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (auto* button = qobject_cast<QPushButton*>(focusWidget())) {
            button->click();
        }
    } else if (key == Qt::Key_Up) {
        focusPreviousChild();
    } else if (key == Qt::Key_Down) {
        focusNextChild();
    } else if (meaning == PlayKey::Menu || meaning == PlayKey::Pause) {
        Q_EMIT resumed(); // after a win as well: back to the message
    } else if (meaning == PlayKey::Restart) {
        Q_EMIT restarted();
    } else if (meaning == PlayKey::Thrust) {
        focusPreviousChild();
    } else if (key == Qt::Key_S) {
        focusNextChild();
    } // nothing reaches the game behind the menu
}

} // namespace spacetow
