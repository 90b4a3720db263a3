#include "editor/window/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <algorithm>

namespace spacetow {

namespace {

constexpr auto textsFolder = ":/translations";
constexpr auto textsName = "spacetow";

/// Qt looks up the names of keys in this context. Its own translations are not installed everywhere, and menus are to
/// call a key what the hints call it.
[[maybe_unused]] constexpr const char* namesOfKeys[] = {
    QT_TRANSLATE_NOOP("QShortcut", "Ctrl"),      QT_TRANSLATE_NOOP("QShortcut", "Shift"),
    QT_TRANSLATE_NOOP("QShortcut", "Alt"),       QT_TRANSLATE_NOOP("QShortcut", "Del"),
    QT_TRANSLATE_NOOP("QShortcut", "Ins"),       QT_TRANSLATE_NOOP("QShortcut", "Home"),
    QT_TRANSLATE_NOOP("QShortcut", "End"),       QT_TRANSLATE_NOOP("QShortcut", "PgUp"),
    QT_TRANSLATE_NOOP("QShortcut", "PgDown"),    QT_TRANSLATE_NOOP("QShortcut", "Space"),
    QT_TRANSLATE_NOOP("QShortcut", "Backspace"), QT_TRANSLATE_NOOP("QShortcut", "Esc"),
};

/// Qt asks the one that was installed last first. They go with the application, which comes and goes in tests.
QTranslator* installed(const QLocale& locale, const QString& name, const QString& folder) {
    auto* const translator = new QTranslator(QCoreApplication::instance()); // owned by it
    if (!translator->load(locale, name, QStringLiteral("_"), folder)) {
        delete translator;
        return nullptr;
    }
    translator->setObjectName(QStringLiteral("spoken"));
    QCoreApplication::installTranslator(translator);
    return translator;
}

/// In the language itself.
QString nameOf(const QString& code) {
    // Without a country in the code it is not one of its kinds, as Qt has it for these.
    if (code == QLatin1String("en")) {
        return QStringLiteral("English");
    }
    if (code == QLatin1String("es")) {
        return QString::fromUtf8("Español");
    }
    QString name = QLocale(code).nativeLanguageName();
    if (!name.isEmpty()) {
        name[0] = name[0].toUpper();
    }
    return name;
}

} // namespace

std::vector<Language> languages() {
    std::vector<Language> all;
    for (const QString& file : QDir(QLatin1String(textsFolder)).entryList({QStringLiteral("*.qm")}, QDir::Files)) {
        const QString code = file.section(QLatin1Char('.'), 0, 0).mid(static_cast<qsizetype>(qstrlen(textsName)) + 1);
        all.push_back({code, nameOf(code)});
    }
    std::ranges::sort(all, {}, &Language::name);
    return all;
}

void speak(const QString& code) {
    for (QTranslator* translator : QCoreApplication::instance()->findChildren<QTranslator*>(
             QStringLiteral("spoken"), Qt::FindDirectChildrenOnly)) {
        delete translator; // which takes it out
    }
    const QLocale locale = code.isEmpty() ? QLocale() : QLocale(code);
    const QString name = QLatin1String(textsName);
    const QString folder = QLatin1String(textsFolder);
    // Qt's own texts only with ours, so that two languages never mix in one window.
    QTranslator probe;
    if (probe.load(locale, name, QStringLiteral("_"), folder)) {
        installed(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
        installed(locale, name, folder);
    } else {
        installed(QLocale(QStringLiteral("en")), name, folder);
    }
}

} // namespace spacetow
