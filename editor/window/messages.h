#pragma once
// The one place where codes become sentences, in the language of the user. Texts stand in messages_problems.cpp,
// messages_labels.cpp and messages_hints_<tool>.cpp; a code without a text is shown as it is, which the tests do not
// let happen for ours.

#include "core/base/result.h"
#include "core/level/problem.h"
#include "editor/editing/tool.h"

#include <QString>

#include <string_view>

namespace spacetow {

QString sentence(const Problem& problem);
QString sentence(const Error& error);
/// The same of a file that cannot be read: it says which one.
QString sentence(const QString& file, const Error& error);
/// Whether the sentence of the error itself says which file it is about.
bool namesItsFile(const Error& error);
/// For the status bar.
QString sentence(const Hint& hint);
/// For "Undo …" and the history, e.g. "Move 3 objects".
QString sentence(const Label& label);

/// What a point was snapped to: "vertex of Wall 3", "grid".
QString snapName(const Level& level, const SnapAnswer& snap);

/// Whether there is a text for the code of a problem, error or hint.
bool hasSentence(std::string_view code);
bool hasLabel(std::string_view code);

} // namespace spacetow
