#include "tests/support/test_main.h"

#include "editor/play/crash_words.h"
#include "editor/play/hud.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

using namespace spacetow;

class PlayHudTest : public QObject {
    Q_OBJECT

  private slots:
    void noTextLeavesTheViewAndNoTwoOverlap_data() {
        QTest::addColumn<QSizeF>("size");
        QTest::addColumn<Phase>("phase");
        const std::array<std::pair<const char*, Phase>, 6> phases{{{"ready", Phase::AwaitingInput},
                                                                   {"flying", Phase::Flying},
                                                                   {"towing", Phase::Towing},
                                                                   {"won", Phase::Won},
                                                                   {"crashed", Phase::Crashed},
                                                                   {"over", Phase::GameOver}}};
        for (const QSizeF size : {QSizeF(240, 180), QSizeF(320, 900), QSizeF(1600, 240), QSizeF(880, 660),
                                  QSizeF(1600, 600), QSizeF(3840, 2160)}) {
            for (const auto& [name, phase] : phases) {
                QTest::addRow("%s at %g x %g", name, size.width(), size.height()) << size << phase;
            }
        }
    }
    void noTextLeavesTheViewAndNoTwoOverlap() {
        QFETCH(QSizeF, size);
        QFETCH(Phase, phase);
        const bool flying = phase == Phase::Flying;
        for (const bool paused : {false, true}) {
            const HudInput input{phase, {3, 1234.56, 3599.9, flying, 0.5}, paused};
            const std::vector<HudText> texts = hudLayout(input, size, QFont());
            QVERIFY(texts.size() >= (paused || phase == Phase::Flying || phase == Phase::Towing ? 4 : 5));
            const QRectF view(QPointF(0, 0), size);
            for (std::size_t i = 0; i < texts.size(); ++i) {
                QVERIFY2(view.contains(texts[i].box), qPrintable(texts[i].text));
                const QRectF needed =
                    QFontMetricsF(texts[i].font)
                        .boundingRect(texts[i].box, Qt::AlignCenter | Qt::TextWordWrap, texts[i].text);
                QVERIFY2(texts[i].box.adjusted(-1, -1, 1, 1).contains(needed), qPrintable(texts[i].text));
                for (std::size_t j = 0; j < i; ++j) {
                    QVERIFY2(!texts[i].box.intersects(texts[j].box), qPrintable(texts[i].text + " | " + texts[j].text));
                }
            }
        }
    }
    void everyPhaseSaysWhatToDo_data() {
        QTest::addColumn<Phase>("phase");
        QTest::addColumn<QString>("words");
        QTest::addRow("ready") << Phase::AwaitingInput << "Press a direction to start";
        QTest::addRow("crashed") << Phase::Crashed << "Press any key to try again";
        QTest::addRow("won") << Phase::Won << "You made it!";
        QTest::addRow("over") << Phase::GameOver << "Game over";
    }
    void everyPhaseSaysWhatToDo() {
        QFETCH(Phase, phase);
        QFETCH(QString, words);
        QString all;
        for (const HudText& text : hudLayout({phase, {2, 1.5, 61.25, false, -1}, false}, {880, 660}, QFont())) {
            all += text.text + '\n';
        }
        QVERIFY2(all.contains(words), qPrintable(all));
        QVERIFY2(all.contains("Lives 2"), qPrintable(all));
        QVERIFY2(all.contains("1.50"), qPrintable(all));
        QVERIFY2(all.contains("1:01.2"), qPrintable(all));
    }
    void adviceNamesTheKeysThatThePlayerHas() {
        PlayKeys keys;
        keys.set(PlayKey::Tow, {QKeySequence("K")});
        keys.set(PlayKey::Step, {});
        const auto words = [&](const HudInput& input) {
            QString all;
            for (const HudText& text : hudLayout(input, {880, 660}, QFont())) {
                all += text.text + '\n';
            }
            return all;
        };
        QVERIFY(words({Phase::Flying, {3, 0, 0, true, -1}, false}).contains("Space: tow"));
        QVERIFY(words({Phase::Flying, {3, 0, 0, true, -1}, false, keys}).contains("K: tow"));
        QVERIFY(words({Phase::Won, {3, 0, 0, false, -1}, false, keys}).contains("K: fly again"));
        const QString paused = words({Phase::Flying, {3, 0, 0, false, -1}, true, keys});
        QVERIFY2(paused.contains("P: go on") && !paused.contains("one step"), qPrintable(paused));
    }
    void whoHasNotBegunIsToldTheGoalAndTheKeys() {
        PlayKeys keys;
        keys.set(PlayKey::Thrust, {QKeySequence("K")});
        HudInput input{Phase::AwaitingInput, {3, 0, 0, false, -1}, false, keys};
        const auto words = [&] {
            QString all;
            for (const HudText& text : hudLayout(input, {880, 660}, QFont())) {
                all += text.text + '\n';
            }
            return all;
        };
        QVERIFY2(words().contains("A/Left, D/Right: turn · K: thrust · Space: tow"), qPrintable(words()));
        QVERIFY2(words().contains("across the finish"), qPrintable(words()));
        input.goal = "Mind the bats.";
        QVERIFY2(words().contains("Mind the bats.") && !words().contains("finish"), qPrintable(words()));
        input.phase = Phase::Flying;
        QVERIFY2(!words().contains("bats") && !words().contains("turn"), qPrintable(words()));
    }
    void aCrashSaysWhatIsLost() {
        HudInput input{Phase::Crashed, {2, 0, 0, false, -1}, false};
        const auto says = [&](bool ship, bool payload, const QString& words) {
            input.shipLost = ship;
            input.payloadLost = payload;
            return std::ranges::any_of(hudLayout(input, {880, 660}, QFont()), [&](const HudText& text) {
                return text.role == HudText::Role::Advice && text.text == words + "Press any key to try again";
            });
        };
        QVERIFY(says(true, false, "The ship is lost.\n"));
        QVERIFY(says(false, true, "The payload is lost.\n"));
        QVERIFY(says(true, true, "Ship and payload are lost.\n"));
        QVERIFY(says(false, false, {}));
        input.cause = "The ship hit “Reef”.";
        QVERIFY(says(true, false, "The ship hit “Reef”.\n"));
        QVERIFY(says(true, true, "The ship hit “Reef”. Ship and payload are lost.\n"));
        input.phase = Phase::GameOver;
        QVERIFY(std::ranges::any_of(hudLayout(input, {880, 660}, QFont()),
                                    [](const HudText& text) { return text.text.contains("Reef"); }));
    }
    void aCrashSaysWhoHitWhat() {
        Level level;
        level.objects.append({7, "Reef", BodyObject(), {}});
        level.objects.append({8, {}, BodyObject(), {}});
        const std::uint32_t wall = TagMask::bit(wallTag).bits;
        QCOMPARE(crashWords({.ship = true, .what = 7, .tags = wall}, level), QString("The ship hit “Reef”."));
        QCOMPARE(crashWords({.payload = true, .who = BodyRole::Payload, .what = 7, .tags = wall}, level),
                 QString("The payload hit “Reef”."));
        const QString name = QString::fromStdString(level.tags[wallTag].name);
        QCOMPARE(crashWords({.ship = true, .what = 8, .tags = wall}, level),
                 QString("The ship hit something tagged “%1”.").arg(name));
        QCOMPARE(crashWords({.ship = true, .whom = BodyRole::Payload, .what = 9}, level),
                 QString("The ship hit the payload."));
        QVERIFY(crashWords({.ship = true}, level).isEmpty());
    }
    void noWordsCoverTheShip() {
        for (const QSizeF size : {QSizeF(320, 900), QSizeF(880, 660), QSizeF(1920, 1000)}) {
            for (const Phase phase : {Phase::AwaitingInput, Phase::Flying, Phase::Won}) {
                for (double y = 0.12; y < 0.98; y += 0.02) {
                    const QRectF ship(size.width() / 2 - 12, y * size.height() - 12, 24, 24);
                    const HudInput input{phase, {3, 0, 0, true, -1}, false, {}, "Through the gap, then up.", ship};
                    const std::vector<HudText> texts = hudLayout(input, size, QFont());
                    for (std::size_t i = 0; i < texts.size(); ++i) {
                        QVERIFY2(!texts[i].box.intersects(ship), qPrintable(texts[i].text + QString::number(y)));
                        for (std::size_t j = 0; j < i; ++j) {
                            QVERIFY2(!texts[i].box.intersects(texts[j].box), qPrintable(texts[i].text));
                        }
                    }
                }
            }
        }
    }
    void theTowHintShowsInRangeOnly() {
        const auto hints = [](bool inRange) {
            int found = 0;
            for (const HudText& text : hudLayout({Phase::Flying, {3, 0, 0, inRange, -1}, false}, {880, 660}, {})) {
                found += text.role == HudText::Role::Hint ? 1 : 0;
            }
            return found;
        };
        QCOMPARE(hints(true), 1);
        QCOMPARE(hints(false), 0);
    }
    void theGravityBannerStaysForOneAndAHalfSeconds() {
        const auto banners = [](double since) {
            int found = 0;
            for (const HudText& text : hudLayout({Phase::Towing, {3, 0, 0, false, since}, false}, {880, 660}, {})) {
                found += text.role == HudText::Role::Banner ? 1 : 0;
            }
            return found;
        };
        QCOMPARE(banners(-1), 0);
        QCOMPARE(banners(0), 1);
        QCOMPARE(banners(1.49), 1);
        QCOMPARE(banners(1.51), 0);
    }
    void aSandboxShowsNoGameReadings() {
        QVERIFY(hudLayout({Phase::Sandbox, {0, 0, 0, false, -1}, false}, {880, 660}, QFont()).empty());
        QVERIFY(!hudLayout({Phase::Sandbox, {0, 0, 0, false, -1}, true}, {880, 660}, QFont()).empty());
    }
    void pausedCoversNothingButTheLowerEdge() {
        const QSizeF size(880, 660);
        for (const Phase phase : {Phase::Sandbox, Phase::Flying, Phase::Crashed}) {
            bool said = false;
            for (const HudText& text : hudLayout({phase, {3, 0, 0, true, -1}, true}, size, QFont())) {
                const bool top = text.box.bottom() < 0.1 * size.height();
                QVERIFY2(top || text.box.top() > 0.93 * size.height(), qPrintable(text.text));
                said |= text.text.contains("Paused");
            }
            QVERIFY(said);
        }
    }
    void numbersHaveTheDecimalPointOfTheLanguage() {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        QString all;
        for (const HudText& text : hudLayout({Phase::Flying, {2, 1.5, 61.25, false, -1}, false}, {880, 660}, QFont())) {
            all += text.text + '\n';
        }
        QLocale::setDefault(before);
        QVERIFY2(all.contains("1,50 s"), qPrintable(all));
        QVERIFY2(all.contains("1:01,2"), qPrintable(all));
    }
    void paintingWritesLightTextWithADarkHalo() {
        QImage image(880, 660, QImage::Format_RGB32);
        image.fill(QColor(128, 128, 128));
        QPainter painter(&image);
        paintHud(painter, hudLayout({Phase::Won, {3, 0, 0, false, -1}, false}, image.size(), QFont()));
        painter.end();
        int light = 0, dark = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const int grey = qGray(image.pixel(x, y));
                light += grey > 200 ? 1 : 0;
                dark += grey < 60 ? 1 : 0;
            }
        }
        QVERIFY(light > 1000);
        QVERIFY(dark > 1000);
    }
};

SPACETOW_TEST(PlayHudTest)
#include "play_hud_test.moc"
