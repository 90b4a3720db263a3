// Menus and hints call a key the same, in every language and whatever else is installed.
#include "editor/window/messages_table.h"
#include "tests/support/test_main.h"

#include <QKeySequence>
#include <QTranslator>

using namespace spacetow;

class KeyNamesTest : public QObject {
    Q_OBJECT

  private slots:
    void hintsCallKeysAsMenusDo_data() {
        QTest::addColumn<QString>("locale");
        for (const char* name : {"de_AT", "fr_FR", "es_MX", "zh_CN"}) {
            QTest::newRow(name) << QString(name);
        }
    }
    void hintsCallKeysAsMenusDo() {
        QFETCH(QString, locale);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(locale), "spacetow", "_", ":/translations"));
        QCoreApplication::installTranslator(&translator);
        int keys = 0;
        for (const auto& [key, name] : {std::pair(Qt::CTRL, "Ctrl"), std::pair(Qt::SHIFT, "Shift")}) {
            const QString shown = QKeySequence(key | Qt::Key_A).toString(QKeySequence::NativeText).section('+', 0, 0);
            for (const HintText& hint : hintTexts()) {
                if (QString::fromUtf8(hint.text).contains(name)) {
                    const QString said = QCoreApplication::translate("messages", hint.text);
                    QVERIFY2(said.contains(shown), qPrintable(shown + ": " + said));
                    ++keys;
                }
            }
        }
        QCoreApplication::removeTranslator(&translator);
        QVERIFY(keys > 20);
    }
};

SPACETOW_TEST(KeyNamesTest)
#include "key_names_test.moc"
