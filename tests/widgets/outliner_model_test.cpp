#include "editor/panels/outliner_model.h"

#include "core/base/random.h"
#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "core/level/groups.h"
#include "editor/editing/outline_verbs.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Listed {
    explicit Listed(Level level) : document(std::move(level)), toolbox(document, 1), model(document, toolbox) {
        model.refresh();
    }
    Document document;
    Toolbox toolbox;
    OutlinerModel model;

    void become(Level level) {
        document.commit({"change", 1}, {std::make_shared<const Level>(std::move(level)), document.selection()});
        model.refresh();
    }
};

/// All that a view could show, row by row.
QStringList written(const OutlinerModel& model, const QModelIndex& parent = {}, int depth = 0) {
    QStringList rows;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, OutlinerModel::Name, parent);
        const auto accessible = [&](int column) {
            return index.siblingAtColumn(column).data(Qt::AccessibleTextRole).toString();
        };
        rows << QString(depth, QLatin1Char('.')) + QString::number(OutlinerModel::keyOf(index)) + QLatin1Char(' ') +
                    index.data().toString() + QLatin1Char(' ') + accessible(OutlinerModel::Eye) + QLatin1Char(' ') +
                    accessible(OutlinerModel::Lock);
        rows << written(model, index, depth + 1);
    }
    return rows;
}

/// Keys of the rows, with brackets round what is in a group.
QString keysIn(const OutlinerModel& model, const QModelIndex& parent = {}) {
    QStringList keys;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        const QString inside = keysIn(model, index);
        keys << QString::number(OutlinerModel::keyOf(index)) +
                    (inside.isEmpty() ? QString() : QStringLiteral("(%1)").arg(inside));
    }
    return keys.join(QLatin1Char(' '));
}

Object listedBall(Key key, Key parent = 0, std::string name = {}) {
    return {key, std::move(name), BodyObject{.shapes = {Circle{{0, 0}, 1}}}, {}, parent};
}

/// A layer (1) with a ball (2) and a group (3) of two balls (4, 5); a ball (6) at the top.
Level layered() {
    Level level;
    level.objects.append({1, "front", GroupObject{true, {}}, {}});
    level.objects.append(listedBall(2, 1));
    level.objects.append({3, "pair", GroupObject{}, {}, 1});
    level.objects.append(listedBall(4, 3, "left"));
    level.objects.append(listedBall(5, 3, "right"));
    level.objects.append(listedBall(6));
    return level;
}

std::vector<Key> someKeys(const Level& level, Random& random) {
    std::vector<Key> keys;
    const unsigned share = 1 + random.below(6);
    for (const Object& object : level.objects) {
        if (random.below(share) == 0) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

Key oneOf(const Level& level, Random& random) {
    return level.objects.empty() || random.below(4) == 0
               ? 0
               : level.objects[static_cast<int>(random.below(static_cast<unsigned>(level.objects.size())))].key;
}

/// What a user could do to the tree, or undo.
Level editedAtRandom(Level level, Random& random) {
    const std::vector<Key> keys = someKeys(level, random);
    const std::uint64_t seed = random.next();
    std::vector<Key> copies;
    switch (random.below(12)) {
    case 0:
        return grouped(level, keys, {freshKey(level, seed), "group", GroupObject{}, {}});
    case 1:
        return ungrouped(std::move(level), keys);
    case 2:
        return removed(std::move(level), keys);
    case 3:
        return duplicated(std::move(level), keys, {{1, 1}, seed, 0, true}, copies);
    case 4:
        return reordered(std::move(level), keys, random.below(2) == 0 ? OrderTo::Front : OrderTo::Back);
    case 5:
        return withVisible(std::move(level), keys, random.below(2) == 0);
    case 6:
        return withLocked(std::move(level), keys, random.below(2) == 0);
    case 7:
        return renamed(std::move(level), oneOf(level, random), std::to_string(random.below(50)));
    case 8:
        return added(level, listedBall(freshKey(level, seed), oneOf(level, random)));
    case 9:
        return randomLevel(seed, 20);
    default:
        return regrouped(level, keys, {oneOf(level, random), oneOf(level, random)});
    }
}

} // namespace

class OutlinerModelTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsDrawnOnTopComesFirst() {
        const Listed listed(layered());
        QCOMPARE(keysIn(listed.model), QString("6 1(3(5 4) 2)"));
    }

    void membersWithoutAGroupAreAtTheTop() {
        Level level;
        level.objects.append(listedBall(1, 77));
        level.objects.append({2, "", GroupObject{}, {}, 3});
        level.objects.append({3, "", GroupObject{}, {}, 2});
        const Listed listed(level);
        QCOMPARE(keysIn(listed.model), QString("3 2 1"));
    }

    void afterRandomEditsItIsWhatAFreshOneWouldBe_data() {
        QTest::addColumn<QString>("filter");
        QTest::newRow("everything") << QString();
        QTest::newRow("by name") << QString("1");
        QTest::newRow("by kind") << QString("kind:group");
        QTest::newRow("hidden") << QString("is:hidden");
    }
    void afterRandomEditsItIsWhatAFreshOneWouldBe() {
        QFETCH(const QString, filter);
        const int runs = isFullRun() ? 200 : 12;
        for (int run = 0; run < runs; ++run) {
            const std::uint64_t seed = 1000 + static_cast<std::uint64_t>(run);
            Random random(seed);
            Listed listed(randomLevel(seed, 25));
            listed.model.setFilter(ObjectFilter(filter));
            const QAbstractItemModelTester tester(&listed.model, QAbstractItemModelTester::FailureReportingMode::Fatal);
            std::vector<QPersistentModelIndex> kept;
            for (int step = 0; step < 40; ++step) {
                if (random.below(5) == 0) {
                    listed.document.undo();
                    listed.model.refresh();
                } else {
                    listed.become(editedAtRandom(listed.document.level(), random));
                }
                Listed fresh(listed.document.level());
                fresh.model.setFilter(ObjectFilter(filter));
                QVERIFY2(written(listed.model) == written(fresh.model), seedText(seed));
                kept.emplace_back(listed.model.index(0, 0));
                for (const QPersistentModelIndex& index : kept) {
                    QVERIFY2(!index.isValid() ||
                                 listed.model.indexOf(OutlinerModel::keyOf(index)) == QModelIndex(index),
                             seedText(seed));
                }
            }
        }
    }

    void oneEditNeverBeginsAnew() {
        Level level = layered();
        for (Key key = 100; key < 5000; ++key) {
            level.objects.append(listedBall(key));
        }
        Listed listed(level);
        const QSignalSpy resets(&listed.model, &QAbstractItemModel::modelReset);
        const QSignalSpy inserted(&listed.model, &QAbstractItemModel::rowsInserted);
        const QSignalSpy removals(&listed.model, &QAbstractItemModel::rowsRemoved);
        const QSignalSpy changes(&listed.model, &QAbstractItemModel::dataChanged);
        listed.become(added(listed.document.level(), listedBall(9000)));
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(inserted.front().at(1).toInt(), 0);
        listed.become(renamed(listed.document.level(), 2500, "stone"));
        QCOMPARE(changes.count(), 1);
        QCOMPARE(changes.front().at(0).toModelIndex(), listed.model.indexOf(2500));
        listed.become(moved(listed.document.level(), std::vector<Key>{2501}, {1, 0}));
        QCOMPARE(changes.count(), 1); // where an object is does not show
        listed.become(removed(listed.document.level(), std::vector<Key>{2500, 2501, 2700}));
        QCOMPARE(removals.count(), 2);
        const QPersistentModelIndex kept = listed.model.indexOf(300);
        listed.become(regrouped(listed.document.level(), std::vector<Key>{300, 2600}, {3, 0}));
        QCOMPARE(QModelIndex(kept).parent(), listed.model.indexOf(3));
        listed.become(grouped(listed.document.level(), std::vector<Key>{400, 401}, {8000, "", GroupObject{}, {}}));
        listed.document.undo();
        listed.model.refresh();
        QCOMPARE(resets.count(), 0);
        QCOMPARE(inserted.count(), 2);
    }

    void hidingAGroupGreysItsMembers() {
        Listed listed(layered());
        const auto ink = [&listed](Key key) {
            return listed.model.indexOf(key).data(Qt::ForegroundRole).value<QColor>();
        };
        QPalette palette;
        palette.setColor(QPalette::Active, QPalette::Text, Qt::black);
        palette.setColor(QPalette::Disabled, QPalette::Text, Qt::gray);
        listed.model.setPalette(palette);
        const QSignalSpy changes(&listed.model, &QAbstractItemModel::dataChanged);
        listed.become(withVisible(layered(), std::vector<Key>{1}, false));
        QCOMPARE(ink(5), QColor(Qt::gray));
        QCOMPARE(ink(6), QColor(Qt::black));
        QVERIFY(std::ranges::any_of(changes, [&listed](const QList<QVariant>& change) {
            return change.at(0).toModelIndex().parent() == listed.model.indexOf(3);
        }));
    }

    void iconsAreReadOnASelectedRow_data() {
        QTest::addColumn<int>("column");
        QTest::newRow("kind") << int(OutlinerModel::Name);
        QTest::newRow("eye") << int(OutlinerModel::Eye);
        QTest::newRow("lock") << int(OutlinerModel::Lock);
    }
    void iconsAreReadOnASelectedRow() {
        QFETCH(int, column);
        Listed listed(layered());
        QPalette palette;
        palette.setColor(QPalette::Text, Qt::black);
        palette.setColor(QPalette::Base, Qt::white);
        palette.setColor(QPalette::Highlight, Qt::black);
        palette.setColor(QPalette::HighlightedText, Qt::white);
        listed.model.setPalette(palette);
        const auto drawn = [&](QIcon::Mode mode) {
            const auto icon = listed.model.indexOf(5, column).data(Qt::DecorationRole).value<QIcon>();
            return icon.pixmap(QSize(16, 16), mode).toImage();
        };
        const QImage plain = drawn(QIcon::Normal);
        QImage selected = drawn(QIcon::Selected);
        QVERIFY(plain != selected);
        selected.invertPixels(QImage::InvertRgb); // with black for white and white for black it would be the other
        for (int y = 0; y < plain.height(); ++y) {
            for (int x = 0; x < plain.width(); ++x) {
                const QColor one = plain.pixelColor(x, y);
                QVERIFY(one.alpha() < 255 || std::abs(one.lightness() - selected.pixelColor(x, y).lightness()) <= 2);
            }
        }
    }

    void aFilterShowsWhatItFindsWithItsGroups() {
        Listed listed(layered());
        listed.model.setFilter(ObjectFilter("LEFT"));
        QCOMPARE(keysIn(listed.model), QString("1(3(4))"));
        listed.become(renamed(listed.document.level(), 6, "the leftmost"));
        QCOMPARE(keysIn(listed.model), QString("6 1(3(4))"));
        listed.model.setFilter(ObjectFilter("kind:layer"));
        QCOMPARE(keysIn(listed.model), QString("1"));
        listed.model.setFilter({});
        QCOMPARE(keysIn(listed.model), QString("6 1(3(5 4) 2)"));
    }

    void renamingInTheTreeIsAnEntryOfTheHistory() {
        Listed listed(layered());
        QVERIFY(listed.model.setData(listed.model.indexOf(6), "stone"));
        QCOMPARE(listed.document.level().objects.find(6)->name, std::string("stone"));
        QCOMPARE(listed.document.undoLabel().code.text(), std::string("rename"));
        QVERIFY(!listed.model.setData(listed.model.indexOf(6), "stone"));
    }

    void dropsPutRowsWhereTheyAreDropped() {
        Listed listed(layered());
        const auto drag = [&listed](const std::vector<Key>& keys, Key parent, int row) {
            QModelIndexList indexes;
            for (const Key key : keys) {
                indexes << listed.model.indexOf(key);
            }
            const std::unique_ptr<QMimeData> data(listed.model.mimeData(indexes));
            const bool done =
                listed.model.dropMimeData(data.get(), Qt::MoveAction, row, 0, listed.model.indexOf(parent));
            listed.model.refresh();
            return done;
        };
        QVERIFY(drag({6}, 3, 1));
        QCOMPARE(keysIn(listed.model), QString("1(3(5 6 4) 2)"));
        QVERIFY(drag({2, 4}, 0, 0));
        QCOMPARE(keysIn(listed.model), QString("4 2 1(3(5 6))"));
        QVERIFY(drag({4}, 0, 3));
        QCOMPARE(keysIn(listed.model), QString("2 1(3(5 6)) 4"));
        QVERIFY(drag({2}, 3, -1));
        QCOMPARE(keysIn(listed.model), QString("1(3(2 5 6)) 4"));
        QVERIFY(!drag({3}, 3, 0));
        QVERIFY(!drag({1}, 3, 0));
        QVERIFY(!drag({3}, 1, 0)); // it is there
        QCOMPARE(listed.document.history().size(), std::size_t{4});
        for (int i = 0; i < 4; ++i) {
            listed.document.undo();
        }
        QCOMPARE(listed.document.level(), layered());
    }

    void whatWasDraggedElsewhereIsNotTaken() {
        Listed one(layered());
        Listed other(layered());
        const std::unique_ptr<QMimeData> data(one.model.mimeData({one.model.indexOf(6)}));
        QVERIFY(one.model.canDropMimeData(data.get(), Qt::MoveAction, -1, 0, one.model.indexOf(3)));
        QVERIFY(!other.model.canDropMimeData(data.get(), Qt::MoveAction, -1, 0, other.model.indexOf(3)));
        const QMimeData text;
        QVERIFY(!one.model.canDropMimeData(&text, Qt::MoveAction, -1, 0, {}));
    }

    void whatIsLockedIsNotDragged() {
        Listed listed(withLocked(layered(), std::vector<Key>{1}, true));
        QVERIFY(!(listed.model.flags(listed.model.indexOf(5)) & Qt::ItemIsDragEnabled));
        QVERIFY(listed.model.flags(listed.model.indexOf(6)) & Qt::ItemIsDragEnabled);
        const QSignalSpy refusals(&listed.model, &OutlinerModel::dropRefused);
        const std::unique_ptr<QMimeData> data(listed.model.mimeData({listed.model.indexOf(5)}));
        QVERIFY(!listed.model.dropMimeData(data.get(), Qt::MoveAction, 0, 0, {}));
        QCOMPARE(refusals.count(), 1);
    }
};

SPACETOW_TEST(OutlinerModelTest)
#include "outliner_model_test.moc"
