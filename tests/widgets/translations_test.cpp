#include "editor/panels/form_rows.h"
#include "editor/window/key_bindings.h"
#include "editor/window/messages.h"
#include "editor/window/messages_table.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLibraryInfo>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

using namespace spacetow;
using spacetow::test::cutOffTexts;
using spacetow::test::misplacedIn;
using spacetow::test::TestWindow;

namespace {

struct Entry {
    QString context, source;
    QString state; // "unfinished", "vanished", "obsolete" or, when all is well, nothing
    QStringList forms;
};

/// The entries of a .ts file; an unreadable one gives none.
std::vector<Entry> entriesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    std::vector<Entry> entries;
    QString context;
    bool counts = false;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) {
            continue;
        }
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"message") {
            counts = xml.attributes().value("numerus") == u"yes";
        } else if (xml.name() == u"source") {
            entries.push_back({context, xml.readElementText(), {}, {}});
        } else if (xml.name() == u"translation") {
            entries.back().state = xml.attributes().value("type").toString();
            if (!counts) {
                entries.back().forms << xml.readElementText();
            }
        } else if (xml.name() == u"numerusform") {
            entries.back().forms << xml.readElementText();
        }
    }
    return xml.hasError() ? std::vector<Entry>() : entries;
}

/// English is the language of the sources; its file holds plurals alone.
bool isEnglish(const QString& path) {
    return path.endsWith(QStringLiteral("_en.ts"));
}

/// What has to be the same in every language: %1, %n, the mark of a changed file, the patterns of a file dialog.
QStringList fixedParts(const QString& text) {
    static const QRegularExpression fixed(R"(%[1-9n]|\[\*\]|\(\*[^)]*\)|…$)");
    QStringList parts;
    auto found = fixed.globalMatch(text);
    while (found.hasNext()) {
        parts << found.next().captured();
    }
    parts.sort();
    return parts;
}

QChar mnemonicOf(const QString& text) {
    static const QRegularExpression marked("&([^&])");
    const QRegularExpressionMatch found = marked.match(text);
    return found.hasMatch() ? found.captured(1)[0].toLower() : QChar();
}

QSet<QString> textsOf(const std::vector<Entry>& entries) {
    QSet<QString> texts;
    for (const Entry& entry : entries) {
        texts << entry.context + ": " + entry.source;
    }
    return texts;
}

/// Says everything in English with two fifths more letters, as some language may.
class LongWinded : public QTranslator {
  public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        const QString text = QString::fromUtf8(source);
        QString more;
        const qsizetype wanted = (2 * text.size() + 4) / 5;
        while (more.size() < wanted) {
            more += more.size() % 7 == 6 ? u' ' : u'o';
        }
        return more.trimmed() + text;
    }
};

/// A language, as the program speaks it, for as long as this lives; "long" is that of LongWinded.
class Spoken {
  public:
    explicit Spoken(const QString& locale)
        : m_translator(locale == QLatin1String("long") ? std::make_unique<LongWinded>()
                                                       : std::make_unique<QTranslator>()) {
        loaded = m_translator->load(QLocale(locale), QStringLiteral("spacetow"), QStringLiteral("_"),
                                    QStringLiteral(":/translations"));
        QCoreApplication::installTranslator(m_translator.get());
    }
    ~Spoken() { QCoreApplication::removeTranslator(m_translator.get()); }
    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

    bool loaded = false;
    const QTranslator& translator() const { return *m_translator; }

  private:
    std::unique_ptr<QTranslator> m_translator;
};

struct German : Spoken {
    German() : Spoken(QStringLiteral("de_AT")) {}
};

const QStringList spokenLocales{"de_AT", "fr_FR", "es_MX", "zh_CN"};

void addLanguages() {
    QTest::addColumn<QString>("path");
    const QDir folder(test::sourceFolder() + "/translations");
    for (const QString& name : folder.entryList({"*.ts"}, QDir::Files)) {
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
}

} // namespace

class TranslationsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyTextIsTranslated_data() { addLanguages(); }
    void everyTextIsTranslated() {
        QFETCH(QString, path);
        const std::vector<Entry> entries = entriesOf(path);
        QVERIFY(entries.size() > (isEnglish(path) ? 10 : 400));
        for (const Entry& entry : entries) {
            QVERIFY2(entry.state.isEmpty(), qPrintable(entry.state + ": " + entry.source));
            QVERIFY2(!entry.forms.isEmpty() && !entry.forms.contains(QString()), qPrintable(entry.source));
        }
    }

    void placeholdersAndMnemonicsAreKept_data() { addLanguages(); }
    void placeholdersAndMnemonicsAreKept() {
        QFETCH(QString, path);
        for (const Entry& entry : entriesOf(path)) {
            for (const QString& form : entry.forms) {
                QVERIFY2(fixedParts(form) == fixedParts(entry.source), qPrintable(form));
                QVERIFY2(mnemonicOf(form).isNull() == mnemonicOf(entry.source).isNull(), qPrintable(form));
            }
        }
    }

    void theTextsAreThoseOfTheSources_data() { addLanguages(); }
    void theTextsAreThoseOfTheSources() {
        QFETCH(QString, path);
        const QTemporaryDir folder;
        const QString copy = folder.filePath(QFileInfo(path).fileName());
        QVERIFY(QFile::copy(path, copy));
        QStringList arguments{"-silent", "-I", ".", "-no-obsolete", "app", "editor"};
        arguments << (isEnglish(path) ? QStringList{"-pluralonly", "-ts", copy} : QStringList{"-ts", copy});
        QProcess lupdate;
        lupdate.setWorkingDirectory(test::sourceFolder());
        lupdate.start(QLibraryInfo::path(QLibraryInfo::BinariesPath) + "/lupdate", arguments);
        QVERIFY2(lupdate.waitForFinished() && lupdate.exitCode() == 0, qPrintable(lupdate.errorString()));
        const QSet<QString> ours = textsOf(entriesOf(path));
        const QSet<QString> wanted = textsOf(entriesOf(copy));
        QVERIFY(!wanted.isEmpty());
        // Build the target update_translations and translate what is new.
        QCOMPARE((wanted - ours).values(), QStringList());
        QCOMPARE((ours - wanted).values(), QStringList());
    }

    void theTablesAreFoundWhenTheProgramRuns() {
        const German german;
        QVERIFY(german.loaded);
        const auto verify = [&](const char* context, const char* text) {
            return *text == '\0' || !german.translator().translate(context, text).isEmpty();
        };
        for (const auto texts : {problemTexts(), exchangeTexts(), explainTexts()}) {
            for (const MessageText& message : texts) {
                QVERIFY2(verify("messages", message.text), message.text);
                QVERIFY2(message.unnamed == nullptr || verify("messages", message.unnamed), message.unnamed);
            }
        }
        for (const HintText& hint : hintTexts()) {
            QVERIFY2(verify("messages", hint.text), hint.code);
        }
        for (const LabelText& label : labelTexts()) {
            for (const int count : {0, 1, 2}) {
                const QString english =
                    QString(count == 1 ? label.one : label.many).replace("%n", QString::number(count));
                QVERIFY2(sentence(Label{label.code, count}) != english, label.one);
            }
        }
        for (const ActionRow& row : actionRows()) {
            QVERIFY2(verify("Actions", row.text) && verify("Actions", row.tip), row.text);
        }
        for (const auto rows : {objectRows(), levelRows()}) {
            for (const FormRow& row : rows) {
                QVERIFY2(verify("Inspector", row.section) && verify("Inspector", row.label), row.label);
                QVERIFY2(verify("Inspector", row.meaning) && verify("Inspector", row.none), row.label);
            }
        }
    }

    void theWindowSpeaksGerman() {
        const German german;
        TestWindow test;
        QCOMPARE(test.window->actions()[Act::Save].text(), QString("&Speichern"));
        QCOMPARE(test.window->actions()[ToolId::Edge].text(), QString("Einseitige &Kante"));
        QCOMPARE(test.window->menuBar()->actions().front()->text(), QString("&Datei"));
        test.drawWalls();
        QCOMPARE(test.window->actions()[Act::Undo].text(), QString("&Rückgängig: Einseitige Kanten zeichnen"));
        QCOMPARE(sentence(Label{"move", 3}), QString("3 Objekte verschieben"));
        QCOMPARE(sentence(Problem{.code = "out-of-range", .arguments = {"depth", "-1", "0", "9"}}),
                 QString("„depth“ ist -1; der Wert muss zwischen 0 und 9 liegen."));
    }

    void englishKnowsOneFromMany_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("text");
        QTest::newRow("none") << 0 << "0 errors";
        QTest::newRow("one") << 1 << "1 error";
        QTest::newRow("many") << 2 << "2 errors";
    }
    void englishKnowsOneFromMany() {
        QFETCH(int, count);
        QFETCH(QString, text);
        QTranslator english;
        QVERIFY(english.load(QStringLiteral("spacetow_en"), QStringLiteral(":/translations")));
        QCoreApplication::installTranslator(&english);
        QCOMPARE(QCoreApplication::translate("spacetow::StatusLine", "%n errors", nullptr, count), text);
    }

    void anotherLanguageIsNotTakenForGerman() {
        QTranslator translator;
        QVERIFY(!translator.load(QLocale(QStringLiteral("ja_JP")), QStringLiteral("spacetow"), QStringLiteral("_"),
                                 QStringLiteral(":/translations")));
    }

    void noLetterStandsForTwoEntriesOfAMenu_data() {
        QTest::addColumn<QString>("locale");
        for (const QString& locale : spokenLocales + QStringList{"en_US"}) {
            QTest::newRow(qPrintable(locale)) << locale;
        }
    }
    void noLetterStandsForTwoEntriesOfAMenu() {
        QFETCH(QString, locale);
        const Spoken spoken(locale);
        QVERIFY(spoken.loaded);
        TestWindow test;
        QList<QList<QAction*>> menus{test.window->menuBar()->actions()};
        for (const QMenu* menu : test.window->menuBar()->findChildren<QMenu*>()) {
            menus << menu->actions();
        }
        QVERIFY(menus.size() > 5);
        for (const QList<QAction*>& menu : menus) {
            QSet<QChar> letters;
            for (const QAction* action : menu) {
                const QChar letter = mnemonicOf(action->text());
                QVERIFY2(letter.isNull() || !letters.contains(letter), qPrintable(action->text()));
                letters << letter;
            }
        }
    }

    void lettersOfMenusAreShownInMenusOnly_data() {
        QTest::addColumn<QString>("locale");
        for (const QString& locale : spokenLocales) {
            QTest::addRow("%s", qPrintable(locale)) << locale;
        }
    }
    void lettersOfMenusAreShownInMenusOnly() {
        QFETCH(QString, locale);
        const Spoken spoken(locale);
        TestWindow test;
        QStringList texts;
        for (const QDockWidget* dock : test.window->findChildren<QDockWidget*>()) {
            texts << dock->windowTitle();
        }
        for (const QToolButton* button : test.window->findChildren<QToolButton*>()) {
            texts << button->text();
        }
        for (const KeyOwner& owner : keyOwners()) {
            texts << owner.name << owner.place;
        }
        QVERIFY(texts.size() > 100);
        static const QRegularExpression letter(QStringLiteral("&|\\([A-Z0-9]\\)"));
        QCOMPARE(texts.filter(letter), QStringList());
    }

    void nothingIsCutOffInASmallWindow_data() {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QList<Act>>("acts");
        for (const QString& locale : spokenLocales + QStringList{"long"}) {
            const auto add = [&locale](const char* what, const QList<Act>& acts) {
                QTest::addRow("%s: %s", qPrintable(locale), what) << locale << acts;
            };
            add("level", {});
            add("wall", {Act::SelectAll});
            add("two objects", {Act::Duplicate, Act::SelectAll});
            add("linear array", {Act::LinearArray});
            add("radial array", {Act::RadialArray});
            add("transform", {Act::TypeTransform});
            add("export", {Act::ExportAs});
            add("game", {Act::Play});
            add("held game", {Act::Play, Act::Pause});
            add("simulation", {Act::Simulate});
        }
    }
    void nothingIsCutOffInASmallWindow() {
        QFETCH(QString, locale);
        QFETCH(QList<Act>, acts);
        const Spoken spoken(locale);
        TestWindow test;
        if (acts.contains(Act::Play)) {
            test.window->openExample(); // which has a ship
        } else {
            test.drawWalls();
        }
        test.trigger(Act::SelectAll);
        for (const Act act : acts) {
            test.trigger(act);
        }
        if (acts.isEmpty()) {
            test.trigger(Act::SelectNone);
        }
        test.window->resize(800, 600);
        QApplication::processEvents();
        QCOMPARE(test.window->size(), QSize(800, 600));
        QCOMPARE(cutOffTexts(*test.window), QStringList());
        for (const QWidget* bar : std::initializer_list<QWidget*>{
                 &test.window->arrayBar(), &test.window->transformBar(), &test.window->exchange().exportBar()}) {
            QCOMPARE(misplacedIn(*bar), QStringList());
        }
        if (test.window->isInGame()) {
            QTest::keyClick(&test.canvas(), Qt::Key_Escape);
            QApplication::processEvents();
            QVERIFY(acts.contains(Act::Play) && test.canvas().findChild<QWidget*>("pauseMenu")->isVisible());
            QCOMPARE(cutOffTexts(*test.window), QStringList());
        }
    }

    void anImportFitsASmallWindow_data() {
        QTest::addColumn<QString>("locale");
        for (const QString& locale : spokenLocales + QStringList{"long"}) {
            QTest::addRow("%s", qPrintable(locale)) << locale;
        }
    }
    void anImportFitsASmallWindow() {
        QFETCH(QString, locale);
        const Spoken spoken(locale);
        TestWindow test;
        QFile drawing(test.file("cave.svg"));
        QVERIFY(drawing.open(QIODevice::WriteOnly));
        drawing.write("<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0 C9 90 90 9 99 99 L50 0' fill='none' "
                      "stroke='black'/></svg>");
        drawing.close();
        test.window->resize(800, 600);
        test.window->open(drawing.fileName());
        ImportBar& bar = test.window->exchange().importBar();
        bar.finishWork();
        QApplication::processEvents();
        QVERIFY(bar.isVisible() && test.level().objects.size() == 1);
        QTRY_COMPARE(misplacedIn(bar), QStringList());
        QCOMPARE(test.window->size(), QSize(800, 600));
        QCOMPARE(cutOffTexts(*test.window), QStringList());
    }
};

SPACETOW_TEST(TranslationsTest)
#include "translations_test.moc"
