#include "tests/support/test_main.h"

#ifndef Q_MOC_RUN // moc 6.4 trips over <compare>
#include "core/base/handles.h"
#endif

using namespace spacetow;

using AppleId = Id<struct ApplesTag>;
using PearId = Id<struct PearsTag>;

class HandlesTest : public QObject {
    Q_OBJECT

  private slots:
    void aDefaultHandleRefersToNothing();
    void aPlaceUsedAgainIsAnotherThing();
    void handlesToDifferentThingsDoNotMix();
};

void HandlesTest::aDefaultHandleRefersToNothing() {
    QVERIFY(!AppleId{});
    QVERIFY(bool(AppleId{0, 0}));
}

void HandlesTest::aPlaceUsedAgainIsAnotherThing() {
    const AppleId before{4, 1};
    const AppleId after{4, 2};
    QVERIFY(before != after);
    QVERIFY(before < after);
    QVERIFY((AppleId{3, 9} < before)); // by index first
    QVERIFY((before == AppleId{4, 1}));
}

void HandlesTest::handlesToDifferentThingsDoNotMix() {
    QVERIFY((!std::is_convertible_v<AppleId, PearId>));
    QVERIFY((!std::is_convertible_v<AppleId, bool>));
}

SPACETOW_TEST(HandlesTest)
#include "handles_test.moc"
