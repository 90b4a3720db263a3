#include "core/base/mailbox.h"

#include "tests/support/test_main.h"

#include <thread>

using namespace spacetow;

class MailboxTest : public QObject {
    Q_OBJECT

  private slots:
    void theNewestValueStaysInTheBox();
    void whatWasTakenStaysValid();
    void twoThreadsSeeWholeValuesInOrder();
};

void MailboxTest::theNewestValueStaysInTheBox() {
    Mailbox<int> box;
    QVERIFY(box.latest() == nullptr);
    box.post(std::make_shared<const int>(1));
    box.post(std::make_shared<const int>(2));
    QCOMPARE(*box.latest(), 2);
    QCOMPARE(*box.latest(), 2);
    box.post(nullptr);
    QVERIFY(box.latest() == nullptr);
}

void MailboxTest::whatWasTakenStaysValid() {
    Mailbox<int> box;
    box.post(std::make_shared<const int>(1));
    const std::shared_ptr<const int> taken = box.latest();
    box.post(std::make_shared<const int>(2));
    QCOMPARE(*taken, 1);
    QCOMPARE(taken.use_count(), 1L); // the box has let go of it
}

void MailboxTest::twoThreadsSeeWholeValuesInOrder() {
    struct Pair {
        int first, second;
    };
    Mailbox<Pair> box;
    std::jthread writer([&box] {
        for (int i = 1; i <= 20000; ++i) {
            box.post(std::make_shared<const Pair>(Pair{i, -i}));
        }
    });
    int last = 0;
    while (last < 20000) {
        const std::shared_ptr<const Pair> pair = box.latest();
        if (pair != nullptr) {
            QVERIFY(pair->first >= last);
            QCOMPARE(pair->second, -pair->first);
            last = pair->first;
        }
    }
}

SPACETOW_TEST(MailboxTest)
#include "mailbox_test.moc"
