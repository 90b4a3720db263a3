// Keys as text: {"schema": 1, "keys": {"file/save": ["Ctrl+S"]}}.
#include "core/level/codes.h"
#include "editor/window/key_bindings.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace spacetow {

namespace {

struct KeyFileTexts {
    Q_DECLARE_TR_FUNCTIONS(KeyFileTexts)
};

constexpr int keysSchema = 1;
constexpr auto keysField = "keys";
constexpr auto schemaField = "schema";

int lineAt(const QByteArray& text, int offset) {
    return 1 + static_cast<int>(text.left(offset).count('\n'));
}

/// Of one owner; what is wrong is added to the faults.
std::optional<QList<QKeySequence>> keysOfEntry(const KeyOwner& owner, const QJsonValue& entry, QStringList& faults) {
    if (!entry.isArray()) {
        faults << KeyFileTexts::tr("“%1” needs a list of keys, as in [\"Ctrl+S\"].").arg(owner.code);
        return {};
    }
    QList<QKeySequence> keys;
    for (const QJsonValue& word : entry.toArray()) {
        const QKeySequence key =
            spelledFor(owner, QKeySequence::fromString(word.toString(), QKeySequence::PortableText));
        if (key.count() != 1 || key[0].key() == Qt::Key_unknown) {
            faults << KeyFileTexts::tr("“%1” of “%2” is no key.").arg(word.toVariant().toString(), owner.code);
            return {};
        }
        if (const QString objection = objectionTo(key, owner); !objection.isEmpty()) {
            faults << objection;
            return {};
        }
        if (!keys.contains(key)) {
            keys << key;
        }
    }
    return keys;
}

/// Keys that lead to two actions.
void addKeysGivenTwice(const KeyBindings& bindings, QStringList& faults) {
    for (const KeyOwner& owner : keyOwners()) {
        for (const QKeySequence& key : bindings.keys(owner)) {
            const KeyOwner* const first = bindings.ownerBeside(owner, key);
            if (first->code != owner.code) {
                faults << KeyFileTexts::tr("%1 is given to “%2” and to “%3”.")
                              .arg(key.toString(QKeySequence::NativeText), first->name, owner.name);
            }
        }
    }
}

} // namespace

QByteArray keysText(const KeyBindings& bindings, bool all) {
    QJsonObject keys;
    for (const KeyOwner& owner : keyOwners()) {
        if (all || !bindings.isUsual(owner)) {
            QJsonArray list;
            for (const QKeySequence& key : bindings.keys(owner)) {
                list << key.toString(QKeySequence::PortableText);
            }
            keys[owner.code] = list;
        }
    }
    return QJsonDocument(QJsonObject{{schemaField, keysSchema}, {keysField, keys}}).toJson();
}

ReadKeys readKeys(const QByteArray& text) {
    ReadKeys read;
    if (text.trimmed().isEmpty()) {
        read.faults << sentence(Error{LevelCode("empty-file"), {}});
        return read;
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        read.faults
            << KeyFileTexts::tr("Line %1 is no JSON: %2.").arg(lineAt(text, error.offset)).arg(error.errorString());
        return read;
    }
    const QJsonObject file = document.object();
    if (file[schemaField].toInt() > keysSchema) {
        read.faults << KeyFileTexts::tr("These keys were written by a newer version of the program.");
        return read;
    }
    if (!file[keysField].isObject()) {
        read.faults << KeyFileTexts::tr("There are no keys in it; it should look like {\"schema\": 1, \"keys\": {…}}.");
        return read;
    }
    const QJsonObject keys = file[keysField].toObject();
    KeyBindings bindings;
    for (auto entry = keys.begin(); entry != keys.end(); ++entry) {
        const KeyOwner* const owner = keyOwner(entry.key());
        if (owner == nullptr) {
            read.unknown << entry.key();
        } else if (const auto list = keysOfEntry(*owner, entry.value(), read.faults)) {
            bindings.setKeys(*owner, *list);
        }
    }
    addKeysGivenTwice(bindings, read.faults);
    if (read.faults.isEmpty()) {
        read.bindings = std::move(bindings);
    }
    return read;
}

} // namespace spacetow
