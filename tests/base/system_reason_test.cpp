#include "core/base/system_reason.h"

#include "tests/support/test_main.h"

#include <QDir>
#include <QTemporaryDir>

#include <cerrno>
#include <clocale>
#include <cstring>

#ifdef __GLIBC__
#include <libintl.h>
#endif

using namespace spacetow;

namespace {

constexpr auto english = "No such file or directory";

/// A catalogue as msgfmt writes it, of one text (GNU gettext manual, "The Format of GNU MO Files").
QByteArray catalogue(const QByteArray& text, const QByteArray& translation) {
    const QByteArray head = "Content-Type: text/plain; charset=UTF-8\n";
    const std::array<QByteArray, 4> strings{QByteArray(), text, head, translation};
    QByteArray file;
    const auto put = [&file](qsizetype number) {
        const auto word = static_cast<quint32>(number);
        file.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    constexpr qsizetype tables = 28; // behind the header of seven words
    constexpr qsizetype texts = tables + 4 * 8;
    for (const qsizetype word :
         {qsizetype{0x950412de}, qsizetype{0}, qsizetype{2}, tables, tables + 16, qsizetype{0}, texts}) {
        put(word);
    }
    qsizetype offset = texts;
    for (const QByteArray& string : strings) {
        put(string.size());
        put(offset);
        offset += string.size() + 1;
    }
    for (const QByteArray& string : strings) {
        file += string + '\0';
    }
    return file;
}

} // namespace

class SystemReasonTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsEnglishThoughTheSystemSpeaksAnotherLanguage() {
#ifdef __GLIBC__
        const QTemporaryDir folder;
        const QString place = folder.path() + QStringLiteral("/de/LC_MESSAGES");
        QVERIFY(QDir().mkpath(place));
        QFile file(place + QStringLiteral("/libc.mo"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(catalogue(english, "Datei fehlt"));
        file.close();
        bindtextdomain("libc", folder.path().toUtf8().constData());
        qputenv("LANGUAGE", "de");
        QVERIFY(std::setlocale(LC_ALL, "C.UTF-8") != nullptr);
        QCOMPARE(std::strerror(ENOENT), "Datei fehlt"); // or there would be nothing to prove
#endif
        QCOMPARE(systemReason(ENOENT), std::string(english));
    }

    void everyCodeHasOne() {
        QVERIFY(!systemReason(EACCES).empty());
        QVERIFY(!systemReason(123456).empty());
    }
};

SPACETOW_TEST(SystemReasonTest)
#include "system_reason_test.moc"
