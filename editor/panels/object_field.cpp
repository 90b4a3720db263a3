#include "editor/panels/object_field.h"

#include "core/level/key_text.h"
#include "editor/canvas/icons.h"
#include "editor/panels/history_keys.h"
#include "editor/panels/names.h"

#include <QAction>
#include <QCompleter>
#include <QKeyEvent>

namespace spacetow {

namespace {

constexpr int mostNames = 2000; // that are offered

} // namespace

ObjectField::ObjectField(std::function<bool(const Object&)> suits, bool mayBeNone, QWidget* parent)
    : QLineEdit(parent), m_suits(std::move(suits)), m_mayBeNone(mayBeNone) {
    connect(this, &QLineEdit::returnPressed, this, &ObjectField::commit);
    connect(this, &QLineEdit::textEdited, this, [this] { setFault({}); });
    QAction* const list = addAction(livingIcon(QStringLiteral("outliner")), TrailingPosition);
    list->setToolTip(tr("Choose from a list (Down)"));
    connect(list, &QAction::triggered, this, &ObjectField::openList);
    m_show = addAction(livingIcon(QStringLiteral("center")), TrailingPosition);
    m_show->setToolTip(tr("Select it and bring it into the middle of the view"));
    connect(m_show, &QAction::triggered, this, [this] {
        commit(); // a button takes no focus
        if (m_fault.isEmpty() && showObject && m_key && level().objects.find(*m_key) != nullptr) {
            showObject(*m_key);
        }
    });
}

void ObjectField::setValue(std::optional<Key> key) {
    const bool isSame = key == m_key;
    m_key = key;
    if (!isModified() || (!hasFocus() && !isSame)) {
        revert();
    }
}

void ObjectField::revert() {
    setFault({});
    QString wanted;
    if (m_key && *m_key != 0) {
        const Object* object = level().objects.find(*m_key);
        const QString key = QString::fromStdString(keyText(*m_key));
        const bool isAmbiguous =
            object == nullptr || (!object->name.empty() && meant(QString::fromStdString(object->name)).size() != 1);
        wanted = isAmbiguous ? key : told(*object);
        setToolTip(plainToolTip(object == nullptr ? tr("There is no object with this key.")
                                                  : tr("%1, key %2").arg(listedName(level(), *object), key)));
    }
    m_show->setVisible(!wanted.isEmpty());
    if (wanted != text() || isModified()) {
        setText(wanted);
        setCursorPosition(0);
    }
    setPlaceholderText(!m_key ? tr("mixed") : m_mayBeNone ? tr("none") : QString());
    setModified(false);
}

/// By its name where it has one, else by kind and place.
QString ObjectField::told(const Object& object) const {
    return object.name.empty() ? listedName(level(), object) : QString::fromStdString(object.name);
}

std::vector<Key> ObjectField::meant(const QString& text) const {
    std::vector<Key> keys;
    const QString wanted = text.trimmed();
    const std::string name = wanted.toStdString();
    const std::optional<Key> asKey = keyFromText(name);
    for (const Object& object : level().objects) {
        if (object.name == name && m_suits(object)) {
            keys.push_back(object.key);
        } else if (asKey == object.key && m_suits(object)) {
            return {object.key};
        }
    }
    for (const Object& object : level().objects) {
        if (name.empty() || !keys.empty()) {
            break;
        }
        if (object.name.empty() && m_suits(object) && listedName(level(), object) == wanted) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

void ObjectField::commit() {
    if (!isModified()) {
        return;
    }
    const QString typed = text().trimmed();
    const std::vector<Key> keys = typed.isEmpty() ? std::vector<Key>() : meant(typed);
    if (typed.isEmpty() && (m_mayBeNone || !m_key)) {
        const bool isMeant = m_mayBeNone && m_key;
        setModified(false);
        revert();
        setFault(isMeant && enter ? enter(0) : QString());
    } else if (keys.size() == 1) {
        const QString objection = enter ? enter(keys.front()) : QString();
        if (objection.isEmpty()) {
            revert();
        }
        setFault(objection);
    } else {
        setFault(keys.empty()
                     ? tr("Nothing here is called “%1”; write the name or the key of another object.").arg(typed)
                     : tr("Several objects are called “%1”; write the key of the one you mean.").arg(typed));
    }
}

void ObjectField::setFault(const QString& fault) {
    if (m_fault != fault) {
        m_fault = fault;
        setAccessibleDescription(fault);
        Q_EMIT faultChanged();
    }
}

bool ObjectField::event(QEvent* event) {
    return isHistoryOfLevel(*event, isModified()) ? false : QLineEdit::event(event);
}

void ObjectField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && (isModified() || !m_fault.isEmpty())) {
        revert();
        selectAll();
    } else if (event->key() == Qt::Key_Down && completer() != nullptr) {
        openList();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void ObjectField::focusInEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        offerNames();
    }
    QLineEdit::focusInEvent(event);
}

void ObjectField::offerNames() {
    QStringList names;
    for (const Object& object : level().objects) {
        if (m_suits(object)) {
            names << told(object);
        }
        if (names.size() >= mostNames) {
            break;
        }
    }
    names.removeDuplicates();
    auto* completer = new QCompleter(names, this);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    completer->setFilterMode(Qt::MatchContains);
    connect(completer, qOverload<const QString&>(&QCompleter::activated), this, [this](const QString& chosen) {
        setText(chosen);
        setModified(true);
        commit();
    });
    delete this->completer();
    setCompleter(completer);
}

void ObjectField::openList() {
    setFocus(Qt::OtherFocusReason);
    offerNames(); // a window that is not active tells of no focus, and the level may have changed since
    completer()->setCompletionPrefix({});
    completer()->complete();
}

void ObjectField::focusOutEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        commit();
    }
    QLineEdit::focusOutEvent(event);
}

} // namespace spacetow
