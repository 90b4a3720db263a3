#pragma once
// The language that the program speaks: that of the desktop, or one that the user has chosen. Numbers are written as
// the desktop has them in any case.

#include <QString>

#include <vector>

namespace spacetow {

struct Language {
    QString code; // as of QLocale: "de", "zh_CN"
    QString name; // what it calls itself
};

/// Those that the program has texts in, English among them, by their names.
std::vector<Language> languages();

/// From now on texts are looked up in this language; empty: in that of the desktop or, where there are none, in
/// English. What is on the screen already stays as it is.
void speak(const QString& code);

} // namespace spacetow
