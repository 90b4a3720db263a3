#include "tests/support/contact_scenes.h"
#include "tests/support/odd_numbers.h"

#include <csignal>
#include <functional>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Mistake = std::function<void(World&, BodyId)>;

const std::pair<const char*, Mistake> mistakes[] = {
    {"a place that is not a number",
     [](World& w, BodyId id) {
         w.setPose(id, {notANumber, 0}, 0);
     }},
    {"a place infinitely far",
     [](World& w, BodyId id) {
         w.setPose(id, {0, infinite}, 0);
     }},
    {"an angle that is not a number",
     [](World& w, BodyId id) {
         w.setPose(id, {0, 0}, notANumber);
     }},
    {"a velocity that is not a number",
     [](World& w, BodyId id) {
         w.setVelocity(id, {0, notANumber}, 0);
     }},
    {"an infinite spin",
     [](World& w, BodyId id) {
         w.setVelocity(id, {0, 0}, infinite);
     }},
    {"gravity that is not a number",
     [](World& w, BodyId) {
         w.setParameters({.gravity = {0, notANumber}});
     }},
    {"an update without end", [](World& w, BodyId) { w.update({.seconds = infinite}); }},
    {"an update without time", [](World& w, BodyId) { w.setParameters({.seconds = 0}); }},
    {"an update without iterations", [](World& w, BodyId) { w.setParameters({.iterations = 0}); }},
    {"an update without sub-steps", [](World& w, BodyId) { w.setParameters({.substeps = 0}); }},
    {"a body that is not there", [](World& w, BodyId) { w.body(BodyId{}); }},
    {"removing what is not there", [](World& w, BodyId) { w.removeBody(BodyId{}); }},
};

struct Ending {
    QByteArray said; // on standard error
    bool aborted = false;
};

/// Makes the mistake in a process of its own.
Ending endingOf(const Mistake& mistake) {
    World world;
    const BodyId id = add(world, ball({0, 0}, 0.2));
    int ends[2];
    if (::pipe(ends) != 0) {
        return {};
    }
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        ::dup2(ends[1], STDERR_FILENO);
        mistake(world, id);
        ::_exit(0);
    }
    ::close(ends[1]);
    Ending ending;
    char buffer[1024];
    for (ssize_t size = ::read(ends[0], buffer, sizeof buffer); size > 0;
         size = ::read(ends[0], buffer, sizeof buffer)) {
        ending.said.append(buffer, static_cast<qsizetype>(size));
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    ending.aborted = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
    return ending;
}

} // namespace

class ContractsTest : public QObject {
    Q_OBJECT

  private slots:
    void aProgrammersMistakeIsNamedAndStopsTheProgram_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(std::size(mistakes)); ++i) {
            QTest::newRow(mistakes[i].first) << i;
        }
    }
    void aProgrammersMistakeIsNamedAndStopsTheProgram() {
        QFETCH(int, index);
        const Ending ending = endingOf(mistakes[index].second);
        QVERIFY2(ending.aborted, ending.said);
        QVERIFY2(ending.said.contains("contract broken"), ending.said);
        QVERIFY(!endingOf([](World& w, BodyId id) { w.setPose(id, {1, 2}, 3); }).aborted);
    }
};

SPACETOW_TEST(ContractsTest)
#include "contracts_test.moc"
