#include "editor/panels/tag_grid.h"

#include "editor/panels/inspector.h"
#include "editor/panels/tag_names.h"
#include "tests/support/test_main.h"

#include <QLineEdit>

using namespace spacetow;

namespace {

Object body(Key key, TagMask tags, TagMask touches = TagMask::all()) {
    BodyObject made;
    made.shapes = {Circle{}};
    made.filter = {tags, touches};
    return {key, {}, made, {}};
}

struct TagGridFixture {
    explicit TagGridFixture(std::vector<Object> objects) : document(levelOf(objects)), inspector(document, {}) {
        std::vector<Key> keys;
        for (const Object& object : objects) {
            keys.push_back(object.key);
        }
        document.select(Selection(keys));
        inspector.resize(340, 1200);
        inspector.show();
    }
    static Level levelOf(const std::vector<Object>& objects) {
        Level level;
        for (const Object& object : objects) {
            level.objects.append(object);
        }
        return level;
    }
    TagGrid& grid(const char* id) { return *qobject_cast<TagGrid*>(inspector.form().editor(id)); }
    Filter filter(int index) { return std::get<BodyObject>(document.level().objects[index].data).filter; }

    Document document;
    Inspector inspector;
};

} // namespace

class TagGridTest : public QObject {
    Q_OBJECT

  private slots:
    void theButtonsSayTheNamesOfTheTags() {
        TagGridFixture test({body(1, TagMask::bit(wallTag))});
        for (int i = 0; i < TagTable::size; ++i) {
            const TagInfo& info = test.document.level().tags[i];
            const TagChip* chip = test.grid("tags").chip(i);
            QCOMPARE(chip != nullptr, !info.name.empty());
            if (chip != nullptr) {
                QCOMPARE(chip->text(), QString::fromStdString(info.name));
                QCOMPARE(chip->color().rgb() & 0xffffffU, info.color);
            }
        }
        QVERIFY(test.grid("tags").chip(wallTag)->state() == TagChip::State::On);
        QVERIFY(test.grid("tags").chip(shipTag)->state() == TagChip::State::Off);
        QVERIFY(test.grid("tags").everythingChip() == nullptr);
    }

    void tabGoesThroughTheTagsInTheOrderInWhichTheyStand() {
        TagGridFixture test({body(1, TagMask::bit(wallTag))});
        const QWidget* at = test.grid("touches").everythingChip();
        for (int i = 0; i < TagTable::size; ++i) {
            if (const TagChip* chip = test.grid("touches").chip(i)) {
                do {
                    at = at->nextInFocusChain();
                } while (!at->isVisible());
                QCOMPARE(at, chip);
            }
        }
    }

    void aClickOnAMixedTagSetsItForAll() {
        TagGridFixture test({body(1, TagMask::bit(wallTag)), body(2, TagMask{3})});
        TagChip* ship = test.grid("tags").chip(shipTag);
        QVERIFY(ship->state() == TagChip::State::Mixed);
        ship->click();
        QCOMPARE(test.filter(0).tags.bits, 3U);
        QCOMPARE(test.filter(1).tags.bits, 3U);
        QVERIFY(ship->state() == TagChip::State::On);
        ship->click();
        QCOMPARE(test.filter(0).tags.bits, 1U);
        QCOMPARE(test.filter(1).tags.bits, 1U);
        test.document.undo();
        QCOMPARE(test.filter(0).tags.bits, 3U);
        QCOMPARE(test.filter(1).tags.bits, 3U);
        test.document.undo();
        QCOMPARE(test.filter(0).tags.bits, 1U);
        QCOMPARE(test.filter(1).tags.bits, 3U);
        QVERIFY(!test.document.canUndo());
    }

    void everythingStandsForAllTagsToCome() {
        TagGridFixture test({body(1, TagMask{1}, TagMask{5})});
        TagChip* everything = test.grid("touches").everythingChip();
        QVERIFY(everything->state() == TagChip::State::Off);
        everything->click();
        QVERIFY(test.filter(0).touches == TagMask::all());
        QVERIFY(everything->state() == TagChip::State::On);
        QVERIFY(test.grid("touches").chip(debrisTag)->state() == TagChip::State::On);
    }

    void untickingOneTagOfEverythingLeavesItOut() {
        TagGridFixture test({body(1, TagMask{1})});
        TagGrid& touches = test.grid("touches");
        const QList<TagChip*> before = touches.findChildren<TagChip*>();
        QCOMPARE(touches.everythingChip()->text(), QString("everything"));
        touches.chip(debrisTag)->click();
        QCOMPARE(test.filter(0).touches.bits, ~(1U << debrisTag));
        QCOMPARE(touches.findChildren<TagChip*>(), before); // no tag appears that nobody has named
        QCOMPARE(touches.everythingChip()->text(), QString("everything except"));
        QVERIFY(touches.everythingChip()->state() == TagChip::State::On);
        QVERIFY(touches.chip(debrisTag)->isCrossedOut());
        QVERIFY(!touches.chip(wallTag)->isCrossedOut());
        touches.chip(debrisTag)->click();
        QVERIFY(test.filter(0).touches == TagMask::all());
        QCOMPARE(touches.everythingChip()->text(), QString("everything"));
    }

    void everythingIsSwitchedOffToNameAFewOnly() {
        TagGridFixture test({body(1, TagMask{1})});
        TagGrid& touches = test.grid("touches");
        touches.chip(debrisTag)->click();
        touches.everythingChip()->click();
        QVERIFY(test.filter(0).touches == TagMask::all());
        touches.everythingChip()->click();
        QCOMPARE(test.filter(0).touches.bits, 0U);
        QVERIFY(touches.everythingChip()->state() == TagChip::State::Off);
        touches.chip(shipTag)->click();
        QCOMPARE(test.filter(0).touches, TagMask::bit(shipTag));
        QVERIFY(!touches.chip(wallTag)->isCrossedOut());
    }

    void exceptionsAndListsOfSeveralObjectsAreMixed() {
        TagGridFixture test({body(1, TagMask{1}, TagMask{~2U}), body(2, TagMask{1}, TagMask{2})});
        TagGrid& touches = test.grid("touches");
        QVERIFY(touches.everythingChip()->state() == TagChip::State::Mixed);
        QVERIFY(touches.chip(shipTag)->state() == TagChip::State::Mixed);
        QVERIFY(touches.chip(17) == nullptr);
        touches.chip(shipTag)->click();
        QVERIFY(test.filter(0).touches == TagMask::all());
        QCOMPARE(test.filter(1).touches.bits, 2U);
    }

    void aTagWithoutANameThatIsLeftOutIsShownByNumber() {
        TagGridFixture test({body(1, TagMask{1}, TagMask{~(1U << 20)})});
        QVERIFY(test.grid("touches").chip(20) != nullptr);
        QVERIFY(test.grid("touches").chip(20)->isCrossedOut());
        QVERIFY(test.grid("touches").chip(21) == nullptr);
    }

    void everythingThatHasATagIsSelected() {
        TagGridFixture test({body(1, TagMask{1}), body(2, TagMask{3}), body(3, TagMask{2})});
        test.document.select(Selection({1}));
        Q_EMIT test.grid("tags").selectionWanted(shipTag);
        QVERIFY(test.document.selection() == Selection({2, 3}));
    }

    void aTagIsRenamedWhereItStands_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("becomes");
        QTest::newRow("new name") << "rock"
                                  << "rock";
        QTest::newRow("blanks around") << "  rock "
                                       << "rock";
        QTest::newRow("taken") << "ship"
                               << "wall";
        QTest::newRow("spelling of a tag without a name") << "#3"
                                                          << "wall";
        QTest::newRow("nothing") << " "
                                 << "wall";
        QTest::newRow("the same") << "wall"
                                  << "wall";
    }
    void aTagIsRenamedWhereItStands() {
        QFETCH(QString, name);
        QFETCH(QString, becomes);
        TagGridFixture test({body(1, TagMask{1})});
        Q_EMIT test.grid("tags").chip(wallTag)->editWanted();
        auto* line = test.grid("tags").findChild<QLineEdit*>();
        QVERIFY(line->isVisible());
        line->selectAll();
        QTest::keyClicks(line, name);
        QTest::keyClick(line, Qt::Key_Return);
        QCOMPARE(test.document.level().tags[wallTag].name, becomes.toStdString());
        QCOMPARE(test.grid("tags").chip(wallTag)->text(), becomes);
        QCOMPARE(test.document.canUndo(), becomes != "wall");
    }

    void aTagThatIsMadeIsThatOfTheObjectInOneStep() {
        TagGridFixture test({body(1, TagMask{1})});
        QList<TagChip*> chips = test.grid("tags").findChildren<TagChip*>();
        const auto add = std::ranges::find_if(chips, [](TagChip* chip) { return chip->text() == "New tag"; });
        QTest::mouseClick(*add, Qt::LeftButton);
        auto* line = test.grid("tags").findChild<QLineEdit*>();
        QTest::keyClicks(line, "ice");
        QTest::keyClick(line, Qt::Key_Return);
        const int ice = *test.document.level().tags.indexOf("ice");
        QVERIFY(test.filter(0).tags.contains(ice) && test.filter(0).tags.contains(wallTag));
        QCOMPARE(test.document.position(), 1);
        QVERIFY(test.grid("tags").chip(ice)->state() == TagChip::State::On);
        QCOMPARE(test.inspector.focusWidget(), test.grid("tags").chip(ice));
    }

    void theColorOfANewTagIsFarFromThoseInUse() {
        TagTable table;
        for (int made = 0; made < 12; ++made) {
            const int index = debrisTag + 1 + made;
            const QColor fresh = freshTagColor(table);
            for (int i = 0; i < TagTable::size; ++i) {
                const QColor other = QColor::fromRgb(table[i].color);
                const int apart = std::abs(fresh.red() - other.red()) + std::abs(fresh.green() - other.green()) +
                                  std::abs(fresh.blue() - other.blue());
                QVERIFY2(table[i].name.empty() || apart >= 70,
                         qPrintable(fresh.name() + " beside " + other.name() + " after " + QString::number(made)));
            }
            table.set(index, {"made " + std::to_string(made), fresh.rgb() & 0xffffffU});
        }
    }

    void escapeKeepsTheName() {
        TagGridFixture test({body(1, TagMask{1})});
        Q_EMIT test.grid("tags").chip(wallTag)->editWanted();
        auto* line = test.grid("tags").findChild<QLineEdit*>();
        QTest::keyClicks(line, "other");
        QTest::keyClick(line, Qt::Key_Escape);
        QVERIFY(line->isHidden());
        QCOMPARE(test.document.level().tags[wallTag].name, std::string("wall"));
    }

    void aDoubleClickRenamesAndLeavesTheTagAsItWas() {
        TagGridFixture test({body(1, TagMask{1})});
        TagChip* wall = test.grid("tags").chip(wallTag);
        QTest::mouseClick(wall, Qt::LeftButton);
        QTest::mouseDClick(wall, Qt::LeftButton);
        QVERIFY(test.grid("tags").findChild<QLineEdit*>()->isVisible());
        QCOMPARE(test.filter(0).tags.bits, 1U);
    }

    void aBitWithoutANameIsShownByNumberAndMayBeSwitchedOff() {
        TagGridFixture test({body(1, TagMask{1U | 1U << 17})});
        TagChip* nameless = test.grid("tags").chip(17);
        QVERIFY(nameless != nullptr);
        QCOMPARE(nameless->text(), QString("#17"));
        QTest::mouseClick(nameless, Qt::LeftButton);
        QCOMPARE(test.filter(0).tags.bits, 1U);
        QVERIFY(test.grid("tags").chip(17) == nullptr);
    }

    void noButtonIsCutOffOrHidesAnother_data() {
        QTest::addColumn<int>("width");
        for (const int width : {120, 200, 260, 400}) {
            QTest::addRow("%d", width) << width;
        }
    }
    void noButtonIsCutOffOrHidesAnother() {
        QFETCH(int, width);
        TagGrid grid(true);
        grid.setTags(TagTable(), {TagMask{1}, TagMask{1}, 1, 0});
        grid.resize(width, grid.heightForWidth(width));
        grid.show();
        const QList<TagChip*> chips = grid.findChildren<TagChip*>();
        for (const TagChip* a : chips) {
            QVERIFY2(grid.rect().contains(a->geometry()), qPrintable(a->text()));
            for (const TagChip* b : chips) {
                QVERIFY(a == b || !a->geometry().intersects(b->geometry()));
            }
        }
    }
};

SPACETOW_TEST(TagGridTest)
#include "tag_grid_test.moc"
