// levelc with pipes, odd file names and texts that would steer a terminal, and what simulate takes in.

#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Ran {
    int status = -1;
    QByteArray out, err;
};

/// A command of the shell in the folder, in which $levelc is the program.
Ran shell(const QString& folder, const QByteArray& command, const QByteArray& input = {}) {
    QProcess process;
    process.setWorkingDirectory(folder);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("levelc", binaryFolder() + "/bin/levelc");
    process.setProcessEnvironment(environment);
    process.start("bash", {"-s"});
    process.write(input.isEmpty() ? command : command + " <<'END'\n" + input + "\nEND\n");
    process.closeWriteChannel();
    process.waitForFinished(120000);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

Level fallingBall() {
    Level level;
    BodyObject ball;
    ball.kind = BodyKind::Dynamic;
    ball.shapes = {Circle{{0, 0}, 0.5}};
    level.objects.append({0xb0, "ball", ball, {}});
    return level;
}

Level cave(double ship, double payload, double finish) {
    Level level = fallingBall();
    level.objects.append({1, {}, ShipObject{{ship, 20}}, {}});
    level.objects.append({2, {}, PayloadObject{{payload, 30}}, {}});
    level.objects.append({3, {}, FinishObject{{finish, 40}, {finish + 1, 40}}, {}});
    return level;
}

} // namespace

class LevelcStreamsTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_folder.emplace(); }

    void levelsAreReadFromPipes() {
        const Ran in =
            shell(m_folder->path(), "$levelc check /dev/stdin", "{\"schema\": 1, \"objects\": [], \"x\": 1}");
        QCOMPARE(in.status, 0);
        QVERIFY2(in.out.startsWith("/dev/stdin:1: warning: unknown-field:"), in.out + in.err);
        write("level.json", levelText(fallingBall()));
        QCOMPARE(shell(m_folder->path(), "$levelc check <(cat level.json)").status, 0);
        QCOMPARE(shell(m_folder->path(), "cat level.json | $levelc info /dev/stdin").status, 0);
        const Ran broken = shell(m_folder->path(), "echo '{' | $levelc check /dev/stdin");
        QCOMPARE(broken.status, 1);
        QVERIFY(broken.out.contains("unexpected-end"));
    }

    void whatIsDumpedToStandardOutputIsAllThatIsThere() {
        write("level.json", levelText(fallingBall()));
        for (const char* rest : {" | cat", " > out; cat out", ""}) {
            const QByteArray command = "$levelc simulate level.json --updates 3 --hash --dump /dev/stdout";
            const Ran ran = shell(m_folder->path(), command + rest);
            QCOMPARE(QJsonDocument::fromJson(ran.out)["updates"].toInt(), 3);
            QVERIFY2(ran.err.contains("updates=3 time="), ran.err);
        }
        const Ran piped =
            shell(m_folder->path(), "$levelc simulate level.json --updates 3 --dump >(cat > dump; echo) | cat");
        QVERIFY2(piped.out.contains("updates=3"), piped.err);
        const Ran full = shell(m_folder->path(), "$levelc simulate level.json --updates 3 --dump /dev/full");
        QCOMPARE(full.status, 2);
        QVERIFY2(full.err.contains("disk is full"), full.err);
    }

    void fileNamesMayBeAnyBytes() {
        write("level.json", levelText(fallingBall()));
        const Ran named = shell(m_folder->path(), "f=$'h\\xf6hle\\xff.json'; cp level.json $f && $levelc check $f && "
                                                  "$levelc simulate $f --updates 1 --dump $'\\xfe.out' && "
                                                  "$levelc render $f -o $'\\xfd.svg' && ls -b");
        QCOMPARE(named.status, 0);
        QVERIFY2(named.out.contains("\\376.out") && named.out.contains("\\375.svg"), named.out);
        const Ran bad = shell(m_folder->path(), "f=$'h\\xf6hle.json'; printf '{' > $f; $levelc check $f; rm *");
        QVERIFY2(bad.out.startsWith("h\\xf6hle.json:1: error: unexpected-end:"), bad.out);
    }

    void percentSignsInAFileNameStay() {
        write("pct%2%3.json", "{");
        const Ran ran = shell(m_folder->path(), "$levelc check pct%2%3.json");
        QVERIFY2(ran.out.startsWith("pct%2%3.json:1: error: unexpected-end:"), ran.out);
    }

    void nothingInAFileSteersTheTerminal() {
        write("\x1b[31mred\n.json", "{\"schema\": 1, \"name\": \"a\\u001b[2J\\u0007b\\u202ec\\nd\", \"objects\": [],"
                                    " \"\\u001b]0;title\\u0007\": 1, \"é😀\": 1}");
        for (const char* command : {"check", "info", "simulate --updates"}) {
            const Ran ran = shell(m_folder->path(), QByteArray("$levelc ") + command + " *.json 2>&1");
            for (const char c : ran.out) {
                QVERIFY2(c == '\n' || static_cast<unsigned char>(c) >= 0x20, ran.out.toHex());
            }
            QVERIFY(!ran.out.contains("\xe2\x80\xae"));
        }
        const Ran check = shell(m_folder->path(), "$levelc check *.json");
        QVERIFY2(check.out.startsWith("\\x1b[31mred\\n.json:1: warning: unknown-field: "), check.out);
        QVERIFY(check.out.contains("\\x1b]0;title\\x07") && check.out.contains("é😀"));
        QVERIFY(shell(m_folder->path(), "$levelc info *.json").out.contains("name: a\\x1b[2J\\x07b\\u202ec\\nd\n"));
    }

    void simulateSaysWhatItLeavesOutAndTakesItInWhenAsked() {
        const Level caves[] = {cave(0, 5, 10), cave(1, 5, 10), cave(0, 6, 10), cave(0, 5, 11)};
        std::set<QByteArray> without;
        std::set<QByteArray> with;
        for (const Level& level : caves) {
            write("cave.json", levelText(level));
            const Ran plain = shell(m_folder->path(), "$levelc simulate cave.json --updates 2 --hash");
            const Ran game = shell(m_folder->path(), "$levelc simulate cave.json --updates 2 --hash --game");
            QCOMPARE(plain.status, 0);
            QCOMPARE(game.status, 0);
            QVERIFY2(plain.err.contains("ship, payload and finish are left out"), plain.err);
            QVERIFY2(game.err.isEmpty(), game.err);
            QVERIFY(plain.out.contains(" bodies=1 ") && game.out.contains(" bodies=4 "));
            without.insert(plain.out);
            with.insert(game.out);
        }
        QCOMPARE(without.size(), std::size_t{1});
        QCOMPARE(with.size(), std::size_t{4});
    }

    void simulateNamesTheFaultyObjectsThatItLeavesOut() {
        Level level = fallingBall();
        BodyObject crossed;
        crossed.shapes = {Polygon{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}};
        level.objects.append({0xbad, "bow", crossed, {}});
        write("level.json", levelText(level));
        const Ran ran = shell(m_folder->path(), "$levelc simulate level.json --updates 1");
        QCOMPARE(ran.status, 1);
        QVERIFY(ran.out.contains("bodies=1"));
        QVERIFY2(ran.err.startsWith("levelc: the object 00000bad is left out: "), ran.err);
    }

  private:
    void write(const QString& name, const std::string& text) const {
        QFile file(m_folder->filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())), static_cast<qint64>(text.size()));
    }

    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(LevelcStreamsTest)
#include "levelc_streams_test.moc"
