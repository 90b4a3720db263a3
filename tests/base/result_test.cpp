#include "core/base/result.h"

#include "core/base/codes.h"
#include "tests/support/test_main.h"

#include <memory>

using namespace spacetow;

namespace {

Result<std::string> nameOf(int number) {
    if (number == 1) {
        return std::string("one");
    }
    return Error{BaseCode("expression-unknown"), {std::to_string(number)}};
}

} // namespace

class ResultTest : public QObject {
    Q_OBJECT

  private slots:
    void aResultIsAValueOrAnError();
    void theValueCanBeMovedOut();
    void anErrorMayBeTheValue();
};

void ResultTest::aResultIsAValueOrAnError() {
    const Result<std::string> good = nameOf(1);
    QVERIFY(bool(good));
    QCOMPARE(good.value(), std::string("one"));
    const Result<std::string> bad = nameOf(7);
    QVERIFY(!bad);
    QVERIFY((bad.error() == Error{BaseCode("expression-unknown"), {"7"}}));
    QVERIFY((bad.error() != Error{BaseCode("expression-unknown"), {"8"}}));
}

void ResultTest::theValueCanBeMovedOut() {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
    const std::unique_ptr<int> value = std::move(result).value();
    QCOMPARE(*value, 5);
}

void ResultTest::anErrorMayBeTheValue() {
    // The two alternatives are told apart by place, not by type.
    const Result<std::vector<Error>> result(std::vector<Error>(2));
    QVERIFY(bool(result));
    QCOMPARE(result.value().size(), std::size_t{2});
}

SPACETOW_TEST(ResultTest)
#include "result_test.moc"
