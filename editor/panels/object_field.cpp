#include "editor/panels/object_field.h"

#include "core/level/key_text.h"
#include "editor/panels/history_keys.h"
#include "editor/panels/names.h"

#include <QCompleter>

namespace spacetow {

namespace {

constexpr int mostNames = 2000; // that are offered

} // namespace

ObjectField::ObjectField(std::function<bool(const Object&)> suits, bool mayBeNone, QWidget* parent)
    : QLineEdit(parent), m_suits(std::move(suits)), m_mayBeNone(mayBeNone) {
    connect(this, &QLineEdit::returnPressed, this, &ObjectField::commit);
    connect(this, &QLineEdit::textEdited, this, [this] { setFault({}); });
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
        const bool isTold =
            object != nullptr && !object->name.empty() && meant(QString::fromStdString(object->name)).size() == 1;
        wanted = isTold ? QString::fromStdString(object->name) : key;
        setToolTip(
            plainToolTip(object == nullptr ? tr("There is no object with this key.") : listedName(level(), *object)));
    }
    if (wanted != text() || isModified()) {
        setText(wanted);
    }
    setPlaceholderText(!m_key ? tr("mixed") : m_mayBeNone ? tr("none") : QString());
    setModified(false);
}

std::vector<Key> ObjectField::meant(const QString& text) const {
    std::vector<Key> keys;
    const std::string name = text.trimmed().toStdString();
    const std::optional<Key> asKey = keyFromText(name);
    for (const Object& object : level().objects) {
        if (object.name == name && m_suits(object)) {
            keys.push_back(object.key);
        } else if (asKey == object.key && m_suits(object)) {
            return {object.key};
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
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void ObjectField::focusInEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        QStringList names;
        for (const Object& object : level().objects) {
            if (!object.name.empty() && m_suits(object)) {
                names << QString::fromStdString(object.name);
            }
            if (names.size() >= mostNames) {
                break;
            }
        }
        auto* completer = new QCompleter(names, this);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        completer->setFilterMode(Qt::MatchContains);
        delete this->completer();
        setCompleter(completer);
    }
    QLineEdit::focusInEvent(event);
}

void ObjectField::focusOutEvent(QFocusEvent* event) {
    if (event->reason() != Qt::PopupFocusReason) {
        commit();
    }
    QLineEdit::focusOutEvent(event);
}

} // namespace spacetow
