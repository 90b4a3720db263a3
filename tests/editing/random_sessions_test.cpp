// Long sessions of everything that can be done to a level, undone to the start and redone to the end.
#include "core/base/random.h"
#include "core/level/file.h"
#include "editor/editing/arrange_verbs.h"
#include "editor/editing/array_verb.h"
#include "editor/editing/node_verbs.h"
#include "editor/editing/outline_verbs.h"
#include "editor/editing/tools.h"
#include "editor/editing/verbs.h"
#include "tests/support/drive.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <array>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using SelectedVerb = std::optional<FinishedEdit> (*)(const ToolContext&);

constexpr SelectedVerb plainVerbs[]{
    removeSelected,  duplicateSelected, reverseSelected, groupSelected, ungroupSelected,  newLayer,     hideSelected,
    lockSelected,    isolateSelected,   showAll,         unlockAll,     duplicateInPlace, repeatLast,   removeNodes,
    insertMidpoints, removeSegments,    joinNodes,       joinBySegment, breakNodes,       reverseNodes, straightenNodes,
};

/// One user at one level, who does whatever comes to mind.
class RandomUser {
  public:
    RandomUser(std::uint64_t seed, Level level) : m_random(seed), m_drive(std::move(level)) {}

    Document& document() { return m_drive.document; }

    /// A step may make several entries of the history; a small one makes one at most.
    void doSomethingSmall() {
        m_drive.later(std::chrono::seconds(2));
        document().select(someObjects(3));
        finish(nudgeSelected(context(), somewhere()));
    }
    void doSomething() {
        m_drive.later(std::chrono::seconds(2)); // so that nothing merges
        m_drive.held = {m_random.below(5) == 0, m_random.below(5) == 0, m_random.below(5) == 0};
        // What grows without end shows nothing new and takes its time.
        constexpr int enough = 40;
        if (document().level().objects.size() > enough) {
            document().select(selectAll(document().current()));
            finish(unlockAll(context()));
            document().select(someObjects(3));
            finish(removeSelected(context()));
            return;
        }
        switch (m_random.below(6)) {
        case 0:
        case 1:
            useTool();
            break;
        case 2:
            chooseNodes();
            finish(plainVerbs[m_random.below(std::size(plainVerbs))](context()));
            break;
        case 3:
            document().select(someObjects(4));
            finish(plainVerbs[m_random.below(std::size(plainVerbs))](context()));
            break;
        default:
            document().select(someObjects(3));
            finish(changed());
        }
    }

  private:
    Vec2 somewhere() { return {m_random.uniform(-8, 8), m_random.uniform(-6, 6)}; }
    ToolContext context() { return m_drive.toolbox.context(); }
    void finish(const std::optional<FinishedEdit>& edit) { m_drive.toolbox.finish(edit); }
    Selection someObjects(unsigned share) {
        std::vector<Key> keys;
        for (const Object& object : document().level().objects) {
            if (m_random.below(share) == 0) {
                keys.push_back(object.key);
            }
        }
        return Selection(keys);
    }

    void useTool() {
        m_drive.toolbox.choose(toolRows()[m_random.below(static_cast<unsigned>(toolRows().size()))].id);
        if (m_random.below(2) == 0) {
            m_drive.drag(somewhere(), somewhere());
        } else {
            for (std::uint64_t points = 1 + m_random.below(5); points > 0; --points) {
                m_drive.click(somewhere());
            }
        }
        m_drive.key(m_random.below(4) == 0 ? ToolKey::Delete : ToolKey::Enter);
        m_drive.toolbox.cancel();
    }

    void chooseNodes() {
        document().select(someObjects(5));
        m_drive.toolbox.choose(ToolId::Nodes);
        const Selection all = selectAllNodes(document().current());
        document().select(m_random.below(2) == 0 ? all : nextNode(document().current(), 1));
    }

    std::optional<FinishedEdit> changed() {
        const std::vector<Key> keys = document().selection().keys();
        const double angle = m_random.uniform(-3, 3);
        switch (m_random.below(9)) {
        case 0:
            return nudgeSelected(context(), 0.2 * somewhere());
        case 1:
            return rotateSelected(context(), angle);
        case 2:
            return mapSelected(context(), "scale", Affine::scaling(somewhere(), {1.1, 0.9}));
        case 3:
            return flipSelected(context(), angle < 0 ? FlipAxis::Horizontal : FlipAxis::Vertical);
        case 4:
            return alignSelected(context(), static_cast<AlignTo>(m_random.below(6)));
        case 5:
            return distributeSelected(context(), static_cast<Spread>(m_random.below(3)), angle < 0);
        case 6:
            return orderSelected(context(), static_cast<OrderTo>(m_random.below(4)));
        case 7:
            return keys.empty() ? std::nullopt
                                : renameObject(document().current(), keys.front(), std::to_string(m_random.below(99)));
        default:
            return selectedToLayer(context(), angle < 0 ? -1 : 1);
        }
    }

    Random m_random;
    Drive m_drive;
};

} // namespace

class RandomSessionsTest : public QObject {
    Q_OBJECT

  private slots:
    void aThousandEditsAreUndoneAndRedoneByteForByte_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 10; ++seed) {
            QTest::addRow("seed %u", seed) << seed;
        }
    }
    void aThousandEditsAreUndoneAndRedoneByteForByte() {
        QFETCH(unsigned, seed);
        constexpr int edits = 1000;
        static_assert(edits <= Document::maxEntries);
        RandomUser user(seed, randomLevel(seed));
        Document& document = user.document();
        const std::string first = levelText(document.level());
        std::vector<std::string> milestones; // of every hundred
        for (int tries = 0; document.historySize() < edits && tries < 40 * edits; ++tries) {
            if (document.historySize() < edits - 10) {
                user.doSomething();
            } else {
                user.doSomethingSmall();
            }
            QVERIFY(!document.hasPreview());
            if (document.historySize() / 100 > std::ssize(milestones)) {
                milestones.push_back(levelText(document.level()));
                const LevelFile read = parseLevel(milestones.back(), Checks::FileOnly);
                QVERIFY(read.level.has_value());
                QVERIFY(levelText(*read.level) == milestones.back());
            }
        }
        QCOMPARE(document.historySize(), edits);
        QCOMPARE(document.forgotten(), 0);
        const std::string last = levelText(document.level());
        for (int i = 0; i < edits; ++i) {
            document.undo();
        }
        QVERIFY(!document.canUndo());
        QVERIFY(levelText(document.level()) == first);
        for (int i = 0; i < edits; ++i) {
            document.redo();
        }
        QVERIFY(!document.canRedo());
        QVERIFY(levelText(document.level()) == last);
    }
};

SPACETOW_TEST(RandomSessionsTest)
#include "random_sessions_test.moc"
