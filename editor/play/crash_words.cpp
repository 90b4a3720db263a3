#include "editor/play/crash_words.h"

#include <QCoreApplication>

namespace spacetow {

namespace {

struct CrashWords {
    Q_DECLARE_TR_FUNCTIONS(CrashWords)
};

/// Of the first of them.
QString tagNameIn(const Level& level, TagMask tags) {
    for (int index = 0; index < TagTable::size; ++index) {
        if (tags.contains(index) && !level.tags[index].name.empty()) {
            return QString::fromStdString(level.tags[index].name);
        }
    }
    return {};
}

} // namespace

QString crashWords(const Loss& loss, const Level& level) {
    const bool isShip = loss.who == BodyRole::Ship;
    if (loss.whom == BodyRole::Payload) {
        return CrashWords::tr("The ship hit the payload.");
    }
    const Object* const object = loss.what != 0 ? level.objects.find(loss.what) : nullptr;
    if (object != nullptr && !object->name.empty()) {
        return (isShip ? CrashWords::tr("The ship hit “%1”.") : CrashWords::tr("The payload hit “%1”."))
            .arg(QString::fromStdString(object->name));
    }
    const QString tag = tagNameIn(level, TagMask{loss.tags});
    if (tag.isEmpty()) {
        return {};
    }
    return (isShip ? CrashWords::tr("The ship hit something tagged “%1”.")
                   : CrashWords::tr("The payload hit something tagged “%1”."))
        .arg(tag);
}

} // namespace spacetow
