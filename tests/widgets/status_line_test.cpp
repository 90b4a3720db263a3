#include "editor/window/status_line.h"

#include "tests/support/test_main.h"

#include <QLabel>

using namespace spacetow;

namespace {

const QString hint = QStringLiteral("Click: select · drag: move · Delete: remove · Escape: select nothing");

} // namespace

class StatusLineTest : public QObject {
    Q_OBJECT

  private slots:
    void aHintThatIsTooLongLosesWholeClausesFromItsEnd() {
        StatusLine line;
        line.show();
        auto* label = line.findChild<QLabel*>(QStringLiteral("hint"));
        QVERIFY(label != nullptr);
        line.setHint(hint);
        line.resize(3000, line.height());
        QCoreApplication::processEvents();
        QCOMPARE(label->text(), hint);
        const QStringList clauses = hint.split(QStringLiteral(" · "));
        for (int width = 3000; width > 200; width -= 20) {
            line.resize(width, line.height());
            QCoreApplication::processEvents();
            QVERIFY(label->text() == hint || label->text().endsWith(QChar(0x2026)));
            QVERIFY(label->fontMetrics().horizontalAdvance(label->text()) <= std::max(label->width(), 20));
            const QStringList shown = label->text().split(QStringLiteral(" · "));
            for (qsizetype i = 0; shown.size() > 1 && label->text() != hint && i + 1 < shown.size(); ++i) {
                QCOMPARE(shown[i], clauses[i]);
            }
        }
        QVERIFY(label->text() != hint);
        QCOMPARE(label->toolTip(), hint);
    }
};

SPACETOW_TEST(StatusLineTest)
#include "status_line_test.moc"
