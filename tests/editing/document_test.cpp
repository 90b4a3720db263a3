#include "editor/editing/document.h"

#include "core/base/random.h"
#include "core/level/edits.h"
#include "tests/support/drive.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;
using namespace std::chrono_literals;

namespace {

Level twoBalls() {
    Level level;
    level.objects.append(bodyWith(1, Circle{}, {0, 0}));
    level.objects.append(bodyWith(2, Circle{}, {5, 0}));
    return level;
}

Edit edited(const Document& document, Level level) {
    return {std::make_shared<const Level>(std::move(level)), document.selection()};
}

Edit movedBy(const Document& document, Key key, double dx) {
    return edited(document, moved(document.level(), std::vector<Key>{key}, {dx, 0}));
}

double xOf(const Document& document, Key key) {
    return std::get<BodyObject>(document.level().objects.find(key)->data).position.x();
}

struct TestClock {
    std::chrono::steady_clock::time_point now{};
};

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

  private slots:
    void undoAndRedoBringBackIdenticalValues();
    void anyPlaceInTheHistoryCanBeReached();
    void aPreviewThatIsDroppedLeavesNoTrace();
    void committingEndsThePreview();
    void undoEndsThePreview();
    void anEditThatChangesNothingAddsNoEntry();
    void undoBringsBackTheSelectionOfTheTime();
    void selectionNeverNamesWhatIsNotThere();
    void commitsMergeWithinASecond_data();
    void commitsMergeWithinASecond();
    void somethingInBetweenKeepsCommitsApart_data();
    void somethingInBetweenKeepsCommitsApart();
    void mergedCommitsThatChangeNothingDisappear();
    void modifiedMeansDifferentInValue();
    void listenersHearWhatWasShownBefore();
    void nothingIsHeardWhenNothingChanges();
    void aNewEditForgetsWhatWasUndone();
    void theHistoryIsBounded();
    void theHistoryOfALargeLevelSharesItsPieces();
    void resetStartsOver();
};

void DocumentTest::undoAndRedoBringBackIdenticalValues() {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        Document document(twoBalls());
        std::vector<Level> values{document.level()}; // after each entry
        std::size_t position = 0;
        for (int i = 0; i < 80; ++i) {
            const auto action = random.below(4);
            if (action == 0) {
                document.undo();
                position -= position > 0 ? 1 : 0;
            } else if (action == 1) {
                document.redo();
                position += position + 1 < values.size() ? 1 : 0;
            } else {
                Level level = moved(document.level(), std::vector<Key>{1 + random.below(2)}, {random.uniform(1, 2), 0});
                level.name = std::to_string(i);
                document.commit({"move", 1}, edited(document, level));
                values.resize(++position);
                values.push_back(level);
            }
            QVERIFY2(document.level() == values[position], seedText(seed));
            QVERIFY2(document.canUndo() == (position > 0), seedText(seed));
            QVERIFY2(document.canRedo() == (position + 1 < values.size()), seedText(seed));
            QVERIFY2(document.history().size() == values.size() - 1, seedText(seed));
            QVERIFY2(document.isModified() == !(values[position] == values[0]), seedText(seed));
        }
    }
}

void DocumentTest::anyPlaceInTheHistoryCanBeReached() {
    Document document(twoBalls());
    for (int i = 1; i <= 5; ++i) {
        document.commit({"move", i}, movedBy(document, 1, 1));
    }
    QCOMPARE(document.history().front(), (Label{"move", 1}));
    for (const int position : {0, 5, 2, 4, 3}) {
        document.goTo(position);
        QCOMPARE(document.position(), position);
        QCOMPARE(xOf(document, 1), double(position));
    }
    QCOMPARE(document.undoLabel(), (Label{"move", 3}));
    QCOMPARE(document.redoLabel(), (Label{"move", 4}));
}

void DocumentTest::aPreviewThatIsDroppedLeavesNoTrace() {
    Document document(twoBalls());
    document.select(Selection({2}));
    const Edit before = document.shown();
    document.preview(movedBy(document, 1, 3));
    QVERIFY(document.hasPreview());
    QCOMPARE(xOf(document, 1), 3.0);
    QVERIFY(document.current().level == before.level);
    document.dropPreview();
    QVERIFY(!document.hasPreview());
    QVERIFY(document.shown().level == before.level);
    QVERIFY(document.selection() == before.selection);
    QVERIFY(document.history().empty());
    QVERIFY(!document.isModified());
}

void DocumentTest::committingEndsThePreview() {
    Document document(twoBalls());
    document.preview(movedBy(document, 1, 3));
    const Level level = moved(*document.current().level, std::vector<Key>{1}, {4, 0});
    document.commit({"move", 1}, edited(document, level));
    QVERIFY(!document.hasPreview());
    QCOMPARE(xOf(document, 1), 4.0);
    document.undo();
    QCOMPARE(xOf(document, 1), 0.0);
}

void DocumentTest::undoEndsThePreview() {
    Document document(twoBalls());
    document.commit({"move", 1}, movedBy(document, 1, 1));
    document.preview(movedBy(document, 1, 7));
    document.undo();
    QVERIFY(!document.hasPreview());
    QCOMPARE(xOf(document, 1), 0.0);
    document.preview(movedBy(document, 1, 7));
    document.undo(); // nothing left to undo
    QVERIFY(!document.hasPreview());
    QCOMPARE(xOf(document, 1), 0.0);
}

void DocumentTest::anEditThatChangesNothingAddsNoEntry() {
    Document document(twoBalls());
    Edit same = edited(document, document.level());
    same.selection = Selection({1});
    document.commit({"move", 1}, same);
    QVERIFY(document.history().empty());
    QVERIFY(document.selection() == Selection({1}));
}

void DocumentTest::undoBringsBackTheSelectionOfTheTime() {
    Document document(twoBalls());
    document.select(Selection({1}));
    document.commit({"delete", 1}, {std::make_shared<const Level>(removed(document.level(), std::vector<Key>{1})), {}});
    document.select(Selection({2}));
    document.undo();
    QVERIFY(document.selection() == Selection({1}));
    document.redo();
    QVERIFY(document.selection().empty());
}

void DocumentTest::selectionNeverNamesWhatIsNotThere() {
    Document document(twoBalls());
    document.select(Selection({1, 77}));
    QVERIFY(document.selection() == Selection({1}));
    Edit edit = movedBy(document, 1, 1);
    edit.selection = Selection({2, 78});
    document.commit({"move", 1}, edit);
    QVERIFY(document.selection() == Selection({2}));
}

void DocumentTest::commitsMergeWithinASecond_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<int>("milliseconds");
    QTest::addColumn<int>("entries");

    QTest::newRow("same key") << "nudge"
                              << "nudge" << 1000 << 1;
    QTest::newRow("too late") << "nudge"
                              << "nudge" << 1001 << 2;
    QTest::newRow("other key") << "nudge"
                               << "rotate" << 0 << 2;
    QTest::newRow("no key") << ""
                            << "" << 0 << 2;
}

void DocumentTest::commitsMergeWithinASecond() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(int, milliseconds);
    QFETCH(int, entries);
    TestClock clock;
    Document document(twoBalls(), [&clock] { return clock.now; });
    document.commit({"move", 1}, movedBy(document, 1, 1), first.toStdString());
    clock.now += std::chrono::milliseconds(milliseconds);
    document.commit({"move", 1}, movedBy(document, 1, 1), second.toStdString());
    QCOMPARE(static_cast<int>(document.history().size()), entries);
    QCOMPARE(xOf(document, 1), 2.0);
    document.undo();
    QCOMPARE(xOf(document, 1), entries == 1 ? 0.0 : 1.0);
}

void DocumentTest::somethingInBetweenKeepsCommitsApart_data() {
    QTest::addColumn<int>("what");

    QTest::newRow("another selection") << 0;
    QTest::newRow("undo and redo") << 1;
    QTest::newRow("saving") << 2;
}

void DocumentTest::somethingInBetweenKeepsCommitsApart() {
    QFETCH(int, what);
    Document document(twoBalls(), [] { return std::chrono::steady_clock::time_point(); });
    document.commit({"move", 1}, movedBy(document, 1, 1), "nudge");
    if (what == 0) {
        document.select(Selection({2}));
    } else if (what == 1) {
        document.undo();
        document.redo();
    } else {
        document.markSaved();
    }
    document.commit({"move", 1}, movedBy(document, 2, 1), "nudge");
    QCOMPARE(document.history().size(), std::size_t{2});
}

void DocumentTest::mergedCommitsThatChangeNothingDisappear() {
    Document document(twoBalls(), [] { return std::chrono::steady_clock::time_point(); });
    document.commit({"rotate", 1}, movedBy(document, 2, 1));
    document.commit({"move", 1}, movedBy(document, 1, 1), "nudge");
    document.commit({"move", 1}, movedBy(document, 1, -1), "nudge");
    QCOMPARE(document.history(), (std::vector<Label>{{"rotate", 1}}));
    QCOMPARE(document.position(), 1);
    QCOMPARE(xOf(document, 1), 0.0);
}

void DocumentTest::modifiedMeansDifferentInValue() {
    Document document(twoBalls());
    document.commit({"move", 1}, movedBy(document, 1, 1));
    QVERIFY(document.isModified());
    document.markSaved();
    QVERIFY(!document.isModified());
    document.undo();
    QVERIFY(document.isModified());
    document.redo();
    QVERIFY(!document.isModified());
    document.commit({"move", 1}, movedBy(document, 1, 1));
    document.commit({"move", 1}, movedBy(document, 1, -1));
    QVERIFY(!document.isModified());
    document.preview(movedBy(document, 1, 1));
    QVERIFY(!document.isModified());
}

void DocumentTest::listenersHearWhatWasShownBefore() {
    Document document(twoBalls());
    std::vector<std::pair<double, double>> heard;
    document.changed.connect([&heard](const Change& change) {
        const auto x = [](const Edit& edit) {
            return std::get<BodyObject>(edit.level->objects.find(1)->data).position.x();
        };
        heard.emplace_back(x(change.before), x(change.after));
    });
    const Edit one = movedBy(document, 1, 1);
    const Edit two = movedBy(document, 1, 2);
    document.preview(one);
    document.preview(two);
    document.dropPreview();
    document.preview(one);
    document.commit({"move", 1}, two);
    document.undo();
    using Steps = std::vector<std::pair<double, double>>;
    QVERIFY((heard == Steps{{0, 1}, {1, 2}, {2, 0}, {0, 1}, {1, 2}, {2, 0}}));
}

void DocumentTest::nothingIsHeardWhenNothingChanges() {
    Document document(twoBalls());
    int changes = 0;
    int histories = 0;
    document.changed.connect([&changes](const Change&) { ++changes; });
    document.historyChanged.connect([&histories] { ++histories; });
    document.select({});
    document.dropPreview();
    document.undo();
    document.redo();
    document.preview(document.shown());
    document.commit({"move", 1}, document.shown());
    QCOMPARE(changes, 0);
    QCOMPARE(histories, 0);
}

void DocumentTest::aNewEditForgetsWhatWasUndone() {
    Document document(twoBalls());
    document.commit({"move", 1}, movedBy(document, 1, 1));
    document.commit({"rotate", 1}, movedBy(document, 1, 1));
    document.undo();
    document.commit({"scale", 1}, movedBy(document, 2, 1));
    QVERIFY(!document.canRedo());
    QCOMPARE(document.history(), (std::vector<Label>{{"move", 1}, {"scale", 1}}));
}

void DocumentTest::theHistoryIsBounded() {
    Document document(twoBalls());
    const int commits = static_cast<int>(Document::maxEntries) + 10;
    for (int i = 0; i < commits; ++i) {
        document.commit({"move", i}, movedBy(document, 1, 1));
    }
    QCOMPARE(document.history().size(), Document::maxEntries);
    QCOMPARE(document.history().front().count, 10);
    while (document.canUndo()) {
        document.undo();
    }
    QCOMPARE(xOf(document, 1), 10.0);
}

void DocumentTest::theHistoryOfALargeLevelSharesItsPieces() {
    constexpr Key objects = 5000;
    constexpr int edits = 100;
    Level level;
    for (Key key = 1; key <= objects; ++key) {
        level.objects.append(bodyWith(key, Circle{}, {double(key), 0}));
    }
    Document document(std::move(level));
    for (int i = 0; i < edits; ++i) {
        document.commit({"move", 1}, movedBy(document, Key(1 + i), 1));
    }
    std::size_t copies = 0;
    while (document.canUndo()) {
        const Level after = document.level();
        document.undo();
        for (int i = 0; i < after.objects.size(); ++i) {
            copies += after.objects.sharesPiece(i, document.level().objects) ? 0 : 1;
        }
    }
    QCOMPARE(copies, std::size_t{edits});
}

void DocumentTest::resetStartsOver() {
    Document document(twoBalls());
    document.select(Selection({1}));
    document.commit({"move", 1}, movedBy(document, 1, 1));
    Level other;
    other.name = "other";
    document.preview(movedBy(document, 1, 1));
    document.reset(other);
    QVERIFY(document.level() == other);
    QVERIFY(document.selection().empty());
    QVERIFY(!document.hasPreview() && !document.canUndo() && !document.canRedo() && !document.isModified());
}

SPACETOW_TEST(DocumentTest)
#include "document_test.moc"
