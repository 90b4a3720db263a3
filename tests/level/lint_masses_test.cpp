#include "core/level/build.h"
#include "core/level/lint.h"
#include "tests/support/cpu_time.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level withBody(double radius, std::optional<double> mass, double density = 1) {
    BodyObject body;
    body.kind = BodyKind::Dynamic;
    body.shapes = {Circle{{0, 0}, radius}};
    body.mass = mass;
    body.density = density;
    Level level;
    level.objects.append({1, {}, body, {}});
    return level;
}

/// "code (pointer)" of the errors.
std::string errorsIn(const Level& level) {
    std::string text;
    for (const Problem& problem : lint(level)) {
        text +=
            problem.severity == Severity::Error ? std::string(problem.code.text()) + " (" + problem.pointer + ")" : "";
    }
    return text;
}

} // namespace

class LintMassesTest : public QObject {
    Q_OBJECT

  private slots:
    void aBodyThatTheWorldWouldNotTakeIsAnError() {
        QCOMPARE(errorsIn(withBody(1, 5e-324)), std::string("mass-not-usable (/objects/0/mass)"));
        QCOMPARE(errorsIn(withBody(1e-100, {})), std::string("body-not-usable (/objects/0/shapes)"));
        QCOMPARE(errorsIn(withBody(1, {}, 1e-320)), std::string("body-not-usable (/objects/0/shapes)"));
        QCOMPARE(errorsIn(withBody(1e-100, 1)), std::string("body-not-usable (/objects/0/shapes)"));
        for (const double radius : {1e-3, 1e-6, 1.0, 1e6}) {
            QCOMPARE(errorsIn(withBody(radius, {})), std::string());
            QCOMPARE(errorsIn(withBody(radius, 1e-9)), std::string());
        }
    }

    void aPayloadThatTheGameWouldNotTakeIsAnError() {
        Level level;
        level.objects.append({1, {}, PayloadObject{{0, 0}, 0.2, 5e-324}, {}});
        QVERIFY(errorsIn(level).find("mass-not-usable (/objects/0/mass)") != std::string::npos);
        level.objects.replace(0, {1, {}, PayloadObject{{0, 0}, 1e-100, 1}, {}});
        QVERIFY(errorsIn(level).find("body-not-usable (/objects/0/radius)") != std::string::npos);
    }

    void whoeverPassesIsInTheWorld() {
        for (int power = -320; power <= 6; power += 2) {
            for (const std::optional<double> mass : {std::optional<double>(), std::optional(1.0)}) {
                const Level level = withBody(std::pow(10.0, power), mass);
                QCOMPARE(errorsIn(level).empty(), builtWorld(level).bodies.size() == 1);
                QCOMPARE(problemsLeftOut(level).empty(), errorsIn(level).empty());
            }
        }
    }

    void manyConnectorsOnABodyOfManyShapesAreCheckedInTime() {
        constexpr int count = 30'000;
        BodyObject body;
        body.kind = BodyKind::Dynamic;
        body.shapes = std::vector<LevelShape>(count, Circle{{0, 0}, 1});
        Level level;
        level.objects.append({1, {}, body, {}});
        level.objects.append({2, {}, body, {}});
        for (Key key = 3; key < 3 + count; ++key) {
            ConnectorObject connector;
            connector.a = 1;
            connector.b = 2;
            level.objects.append({key, {}, connector, {}});
        }
        const CpuTimer timer;
        lint(level);
        QVERIFY2(timer.seconds() < 2, qPrintable(QString::number(timer.seconds())));
    }
};

SPACETOW_TEST(LintMassesTest)
#include "lint_masses_test.moc"
