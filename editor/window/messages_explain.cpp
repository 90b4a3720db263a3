#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

// %1 is whom the answer is about, %2 the other one.
constexpr MessageText explanations[] = {
    {"apart-touch", QT_TRANSLATE_NOOP("messages", "They touch: “%1” and “%2” are in contact.")},
    {"apart-same-body", QT_TRANSLATE_NOOP("messages", "Both are the same body, which does not collide with itself.")},
    {"apart-inactive", QT_TRANSLATE_NOOP("messages", "“%1” is switched off, so it touches nothing.")},
    {"apart-unmovable",
     QT_TRANSLATE_NOOP("messages", "Neither is moved by forces: “%1” and “%2” pass through each other unless one of "
                                   "them is dynamic.")},
    {"apart-no-tags", QT_TRANSLATE_NOOP("messages", "“%2” has no tags, and what has none is touched by nothing.")},
    {"apart-mask", QT_TRANSLATE_NOOP("messages", "“%1” does not touch what “%2” is: %3.")},
    {"apart-both-masks",
     QT_TRANSLATE_NOOP("messages", "“%1” does not touch what “%2” is: %3. Nor does “%2” touch what “%1” is.")},
    {"apart-connected",
     QT_TRANSLATE_NOOP("messages", "“%3” connects “%1” and “%2”, and bodies that it connects do not collide.")},
    {"apart-rope",
     QT_TRANSLATE_NOOP("messages", "The tow rope connects “%1” and “%2”, which therefore do not collide.")},
    {"apart-intangible", QT_TRANSLATE_NOOP("messages", "“%1” is intangible: it would be felt, but stops nothing.")},
    {"apart-felt",
     QT_TRANSLATE_NOOP("messages", "“%1” is intangible: “%2” touches it and is felt, but nothing stops it.")},
    {"apart-walls", QT_TRANSLATE_NOOP("messages", "Both are nothing but walls, and walls pass through each other.")},
    {"apart-passing",
     QT_TRANSLATE_NOOP("messages",
                       "“%2” is on its way through a one-way wall of “%1”, from %3; %4 to %5; %6: it came from "
                       "behind, and touches nothing until all of it is in front.")},
    {"apart-behind",
     QT_TRANSLATE_NOOP("messages", "“%2” is behind a one-way wall of “%1”, from %3; %4 to %5; %6, which is open "
                                   "from there.")},
    {"apart-distance", QT_TRANSLATE_NOOP("messages", "“%1” and “%2” may collide, but are %3 m apart.")},
    {"apart-next-update",
     QT_TRANSLATE_NOOP("messages", "“%1” and “%2” overlap, and collide as soon as the simulation goes on.")},
    {"cure-tick-tag", QT_TRANSLATE_NOOP("messages", "Let “%1” touch “%2”")},
    {"cure-give-tag", QT_TRANSLATE_NOOP("messages", "Give “%1” the tag “%2”")},
    {"cure-make-solid", QT_TRANSLATE_NOOP("messages", "Make “%1” tangible")},
    {"cure-let-collide", QT_TRANSLATE_NOOP("messages", "Let the bodies of “%1” collide")},
};

} // namespace

std::span<const MessageText> explainTexts() {
    return explanations;
}

} // namespace spacetow
