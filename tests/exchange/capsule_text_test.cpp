#include "editor/exchange/capsule_text.h"

#include "core/base/hash.h"
#include "core/base/random.h"
#include "core/game/codes.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/capsule_fuzz.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int minuteOfUpdates = 3000;
constexpr std::size_t barBytes = 64u << 10;

std::shared_ptr<const Level> campaignLevel() {
    const auto file = readLevel((sourceFolder() + QStringLiteral("/levels/01_first_haul.json")).toStdString());
    return std::make_shared<const Level>(*file.value().level);
}

/// Somebody who plays level 1 without a plan.
Capsule randomRun(int updates, std::uint64_t seed, unsigned pause = 8) {
    Capsule capsule{"SpaceTow Studio 1.0", "Linux\nx86", campaignLevel(), {}, 0};
    capsule.run.level = "01_first_haul.json";
    capsule.run.seed = seed;
    Random random(seed);
    Controls held;
    for (int i = 0; i < updates; ++i) {
        if (random.below(pause) == 0) {
            held = controlsFromBits(static_cast<std::uint8_t>(random.below(16)));
        }
        capsule.run.append(held);
    }
    return capsule;
}

/// Who also pulls at the payload, and changes this and that.
Capsule playedWith(Capsule capsule) {
    Random random(7);
    const Key payload = firstOf<PayloadObject>(*capsule.level)->key;
    auto level = capsule.level;
    InputRuns inputs;
    for (InputReader reader(inputsOf(capsule.run, *level)); !reader.isAtEnd();) {
        StepInput input = reader.next();
        const std::int64_t i = inputs.updates();
        if (i % 50 >= 20 && i % 50 < 49) {
            const Vec2 target(random.uniform(-3, 3), random.uniform(-3, 3));
            input.grab = Grab{payload, {0.05, double(i / 50) / 64}, target};
        }
        if (i % 40 == 13) {
            Level edited = moved(*level, std::vector<Key>{payload}, {random.uniform(-0.01, 0.01), 0});
            edited.gravity.y() = random.uniform(-1, -0.5);
            level = std::make_shared<const Level>(std::move(edited));
            input.level = level;
        }
        inputs.append(input);
    }
    setInputs(capsule.run, inputs, *capsule.level);
    return capsule;
}

Capsule hashed(Capsule capsule) {
    capsule.hash = sessionOf(capsule).hash();
    return capsule;
}

std::string textOfCapsule(const Capsule& capsule) {
    const Result<std::string> text = capsuleText(capsule);
    EXPECTS(bool(text));
    return text.value();
}

QString codeOfCapsule(const std::string& text) {
    const Result<Capsule> capsule = capsuleFromText(text);
    return capsule ? QString() : QString::fromUtf8(capsule.error().code.text());
}

std::string replacedIn(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// A capsule around any bytes, as somebody with bad intentions would make it.
std::string wrapped(const QByteArray& packed) {
    const QByteArray base64 = packed.toBase64();
    StateHash hash;
    std::ranges::for_each(base64, [&hash](char c) { hash.add(std::uint64_t{static_cast<unsigned char>(c)}); });
    return "BEGIN SPACETOW BUG CAPSULE\n" + base64.toStdString() + "\nEND SPACETOW BUG CAPSULE " +
           QByteArray::number(static_cast<qulonglong>(hash.value()), 16).rightJustified(16, '0').toStdString() + "-";
}

QByteArray lengthBefore(const QByteArray& piece) {
    QByteArray all;
    for (int shift = 24; shift >= 0; shift -= 8) {
        all.append(static_cast<char>((piece.size() >> shift) & 0xff));
    }
    return all + piece;
}

} // namespace

class CapsuleTextTest : public QObject {
    Q_OBJECT

  private slots:
    void aRunComesBackAtTheSameMoment() {
        const Capsule capsule = hashed(playedWith(randomRun(300, 3)));
        const Result<Capsule> again = capsuleFromText(textOfCapsule(capsule));
        QVERIFY(bool(again));
        QVERIFY(again.value() == capsule);
        QCOMPARE(sessionOf(again.value()).hash(), capsule.hash);
        QCOMPARE(sessionOf(again.value()).updates(), std::int64_t(300));
    }

    void aMinuteOfLevelOneIsFarBelowTheBar() {
        const Capsule flown = randomRun(minuteOfUpdates, 11);
        const std::size_t bytes = textOfCapsule(flown).size();
        QVERIFY2(bytes < barBytes, qPrintable(QString::number(bytes)));
        const Capsule worst = randomRun(minuteOfUpdates, 12, 1); // other keys in every update
        QVERIFY(textOfCapsule(worst).size() < barBytes);
    }

    void itSurvivesQuotingIndentingAndOtherLineEnds() {
        const Capsule capsule = randomRun(200, 4);
        const std::string text = textOfCapsule(capsule);
        for (const std::string& line : {std::string("\n> "), std::string("\n> > "), std::string("\r\n"),
                                        std::string("\n    "), std::string("\n\n")}) {
            const Result<Capsule> again = capsuleFromText("Look at this:\n" + replacedIn(text, "\n", line) + "\nBye");
            QVERIFY(bool(again));
            QVERIFY(again.value() == capsule);
        }
        std::ranges::for_each(text, [](char c) { QVERIFY(c == '\n' || (c >= ' ' && c <= '~')); });
    }

    void whatIsCutOffIsSaid() {
        const std::string text = textOfCapsule(randomRun(500, 5));
        QCOMPARE(codeOfCapsule(text.substr(0, text.size() / 2)), QStringLiteral("capsule-cut"));
        QCOMPARE(codeOfCapsule("nothing of the kind"), QStringLiteral("capsule-none"));
        QCOMPARE(codeOfCapsule(""), QStringLiteral("capsule-none"));
        // The middle is missing.
        const std::string holed = text.substr(0, text.size() / 3) + text.substr(text.size() / 2);
        QCOMPARE(codeOfCapsule(holed), QStringLiteral("capsule-damaged"));
        QVERIFY(holdsCapsule(text) && !holdsCapsule("capsule"));
    }

    void whatIsEditedIsSaid() {
        const std::string text = textOfCapsule(randomRun(500, 6));
        const std::size_t body = text.find("CAPSULE-----\n") + 13;
        const std::size_t end = text.rfind("-----END");
        int refused = 0;
        int tried = 0;
        for (std::size_t at = body; at < end; at += 17) {
            if (text[at] != '\n') {
                std::string other = text;
                other[at] = other[at] == 'A' ? 'B' : 'A';
                ++tried;
                refused += capsuleFromText(other) ? 0 : 1;
            }
        }
        QVERIFY(tried > 20);
        QCOMPARE(refused, tried);
    }

    void aNewerOneAndOneWithoutALevelAreRefused() {
        const std::string json = capsuleJson(randomRun(10, 7)).value();
        const auto code = [](const std::string& text) {
            const Result<Capsule> capsule = parseCapsule(text);
            return capsule ? QString() : QString::fromUtf8(capsule.error().code.text());
        };
        QCOMPARE(code(json), QString());
        QCOMPARE(code(replacedIn(json, "\"capsule\":1", "\"capsule\":2")), QStringLiteral("capsule-newer"));
        QCOMPARE(code(replacedIn(json, "schema", "scheme")), QStringLiteral("capsule-bad-level"));
        const Error noSchema = parseCapsule(replacedIn(json, "schema", "scheme")).error();
        QVERIFY(noSchema.arguments.size() >= 2);
        QCOMPARE(noSchema.arguments[1], std::string("missing-schema"));
        QCOMPARE(code(replacedIn(json, "\\\"seed\\\": 7", "\\\"seed\\\": -7")), QStringLiteral("replay-bad-field"));
        QCOMPARE(code(replacedIn(json, "\"hash\"", "\"hush\"")), QStringLiteral("capsule-bad-field"));
        QCOMPARE(code("[[[[[[[[[[[[]]]]]]]]]]]]"), QStringLiteral("capsule-damaged"));
        QCOMPARE(code("{}"), QStringLiteral("capsule-bad-field"));
    }

    void aBombIsRefusedBeforeItGoesOff() {
        const QByteArray zeros(16 << 20, '\0'); // of which deflate makes 16 KB
        QByteArray bomb = qCompress(zeros, 9);
        QCOMPARE(codeOfCapsule(wrapped(lengthBefore(bomb))), QStringLiteral("capsule-damaged"));
        bomb[0] = bomb[1] = bomb[2] = 0; // it says that it is small
        QCOMPARE(codeOfCapsule(wrapped(lengthBefore(bomb))), QStringLiteral("capsule-damaged"));
        QCOMPARE(codeOfCapsule(wrapped("what is no piece")), QStringLiteral("capsule-damaged"));
        QByteArray many;
        const QByteArray piece = lengthBefore(qCompress(QByteArray(128 << 10, ' '), 9));
        for (int i = 0; i < 300; ++i) {
            many += piece;
        }
        QCOMPARE(codeOfCapsule(wrapped(many)), QStringLiteral("capsule-damaged"));
        const std::string much(maxCapsuleText + 1, 'A');
        QCOMPARE(codeOfCapsule("BEGIN SPACETOW BUG CAPSULE\n" + much), QStringLiteral("capsule-too-large"));
    }

    void aRunThatIsTooLongForACapsuleIsToldWithTheMostThatItMayHave() {
        Capsule capsule = randomRun(10, 3);
        capsule.run.runs = {{{}, maxReplayUpdates}};
        QVERIFY(bool(capsuleText(capsule)));
        capsule.run.runs.push_back({{}, 1});
        const Result<std::string> text = capsuleText(capsule);
        QVERIFY(!text);
        QVERIFY((text.error() == Error{GameCode("capsule-too-long"), {"1000000"}}));
    }

    void whatMustHoldHoldsForCapsulesThatAreDamaged() {
        const Capsule capsule = playedWith(randomRun(60, 8));
        const std::string json = capsuleJson(capsule).value();
        tryCapsule(textOfCapsule(capsule));
        Random random(9);
        for (int i = 0; i < fullOrQuick(2000, 100); ++i) {
            std::string other = json;
            other[random.below(static_cast<unsigned>(other.size()))] = "0123456789{}[]\",-:a"[random.below(19)];
            tryCapsule(other); // what does not hold ends the program
        }
    }
};

SPACETOW_TEST(CapsuleTextTest)
#include "capsule_text_test.moc"
