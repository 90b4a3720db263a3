#include "editor/window/status_line.h"

#include "tests/support/test_main.h"

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>

#include <algorithm>

using namespace spacetow;

namespace {

const QString hint = QStringLiteral("Click: select · drag: move · Delete: remove · Escape: select nothing");

} // namespace

class StatusLineTest : public QObject {
    Q_OBJECT

  private slots:
    void ofAHintThatIsTooLongWholeClausesAreLeftOut() {
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
            qsizetype last = -1;
            for (qsizetype i = 0; shown.size() > 1 && label->text() != hint && i + 1 < shown.size(); ++i) {
                QVERIFY2(clauses.indexOf(shown[i]) > last, qPrintable(label->text())); // in their order
                last = clauses.indexOf(shown[i]);
            }
            // No room is left over in which one more would have been seen.
            for (const QString& clause : clauses) {
                const QString longer = label->text() + clause + QStringLiteral(" · ");
                QVERIFY2(shown.size() < 2 || shown.contains(clause) ||
                             label->fontMetrics().horizontalAdvance(longer) > label->width() - 12,
                         qPrintable(label->text()));
            }
        }
        QVERIFY(label->text() != hint);
        QCOMPARE(label->toolTip(), hint);
    }

    void whatIsSaidForAMomentIsShortenedToo() {
        StatusLine line;
        line.setPace(QStringLiteral("60 fps"));
        line.resize(700, 28);
        line.show();
        const auto* pace = line.findChild<QLabel*>(QStringLiteral("pace"));
        line.showMessage(hint + QStringLiteral(" · ") + hint + QStringLiteral(" · ") + hint);
        QCoreApplication::processEvents();
        QVERIFY(pace != nullptr && pace->isVisible() && pace->x() > 100);
        const QImage image = line.grab().toImage();
        const auto isBare = [&](int left, int right) {
            const QRgb ground = image.pixel(left, line.height() / 2);
            for (int x = left; x < right; ++x) {
                for (int y = 6; y < line.height() - 6; ++y) {
                    if (image.pixel(x, y) != ground) {
                        return false;
                    }
                }
            }
            return true;
        };
        QVERIFY(!isBare(6, 100)); // it is said
        QVERIFY(isBare(pace->x() - 6, pace->x()));
    }

    void withoutABoardNothingIsSaidAboutOne() {
        StatusLine line;
        line.resize(2000, line.height());
        line.show();
        line.setSelection(2, Aabb{});
        const auto shown = [&] {
            return line.findChild<QToolButton*>("snap")->isVisible() && line.findChild<ZoomField*>()->isVisible();
        };
        QVERIFY(shown());
        line.setBoardShown(false);
        int visible = 0;
        for (const QWidget* part : line.findChildren<QWidget*>()) {
            visible += part->isVisible() && part->objectName() != "hint" && part->inherits("QToolButton") ? 1 : 0;
        }
        QCOMPARE(visible, 0);
        QVERIFY(!line.findChild<ZoomField*>()->isVisible());
        line.setBoardShown(true);
        QVERIFY(shown());
    }

    void aPercentageIsReadAsPeopleWriteIt_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("zoom"); // 0: none
        QTest::newRow("number") << "150" << 1.5;
        QTest::newRow("percent") << "150%" << 1.5;
        QTest::newRow("with a blank") << " 12.5 % " << 0.125;
        QTest::newRow("small") << "0.13 %" << 0.0013;
        QTest::newRow("words") << "large" << 0.0;
        QTest::newRow("nothing") << "" << 0.0;
        QTest::newRow("negative") << "-50" << 0.0;
        QTest::newRow("zero") << "0" << 0.0;
        QTest::newRow("no number") << "nan" << 0.0;
        QTest::newRow("endless") << "inf" << 0.0;
    }
    void aPercentageIsReadAsPeopleWriteIt() {
        QFETCH(QString, text);
        QFETCH(double, zoom);
        QCOMPARE(ZoomField::zoomIn(text).value_or(0), zoom);
    }

    void aDecimalCommaIsReadWhereItIsWritten() {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        QCOMPARE(ZoomField::zoomIn("12,5 %").value_or(0), 0.125);
        QCOMPARE(ZoomField::zoomIn("12.5").value_or(0), 0.125);
        QCOMPARE(ZoomField::zoomIn(ZoomField::textFor(0.015)).value_or(0), 0.015);
        QLocale::setDefault(before);
    }

    void aZoomIsTypedAndEntered() {
        StatusLine line;
        line.show();
        auto* field = line.findChild<ZoomField*>();
        QSignalSpy chosen(&line, &StatusLine::zoomChosen);
        QSignalSpy left(&line, &StatusLine::left);
        line.setZoom(1);
        QCOMPARE(field->currentText(), QString("100 %"));
        field->setFocus();
        field->lineEdit()->selectAll();
        QTest::keyClicks(field, "250");
        line.setZoom(2); // meanwhile the view moves
        QCOMPARE(field->currentText(), QString("250"));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen[0][0].toDouble(), 2.5);
        QCOMPARE(left.count(), 1);
        field->lineEdit()->selectAll();
        QTest::keyClicks(field, "rubbish");
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->currentText(), QString("200 %"));
        QCOMPARE(chosen.count(), 1);
    }

    void rubbishIsNoZoom() {
        StatusLine line;
        line.show();
        auto* field = line.findChild<ZoomField*>();
        QSignalSpy chosen(&line, &StatusLine::zoomChosen);
        line.setZoom(0.5);
        field->lineEdit()->selectAll();
        QTest::keyClicks(field, "many");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(chosen.count(), 0);
        QCOMPARE(field->currentText(), QString("50 %"));
    }

    void whereThereIsNoRoomTheLeastImportantGoesFirst() {
        StatusLine line;
        line.show();
        line.setHint(hint);
        line.setPointer(-10, 20);
        line.setSelection(12, Aabb{Vec2(0, 0), Vec2(3, 4)});
        line.setSnap({});
        line.setZoom(1);
        const auto shows = [&line](const QString& part) {
            const QList<QWidget*> parts = line.findChildren<QWidget*>();
            return std::ranges::any_of(parts, [&part](const QWidget* widget) {
                const auto* words = qobject_cast<const QLabel*>(widget);
                const auto* button = qobject_cast<const QToolButton*>(widget);
                const auto* field = qobject_cast<const QLineEdit*>(widget);
                const QString text = words != nullptr    ? words->text()
                                     : button != nullptr ? button->text()
                                     : field != nullptr  ? field->text()
                                                         : QString();
                return widget->isVisible() && text.contains(part);
            });
        };
        const QStringList byImportance{"No problems", "100 %", "12 selected", "Snap 0.25 m", "x -10.00"};
        for (int width = 2000; width >= 300; width -= 10) {
            line.resize(width, line.height());
            QCoreApplication::processEvents();
            bool before = true;
            for (const QString& part : byImportance) {
                QVERIFY2(before || !shows(part), qPrintable(QStringLiteral("%1 at %2").arg(part).arg(width)));
                before = shows(part);
            }
            QVERIFY(shows("No problems"));
            QVERIFY(line.minimumSizeHint().width() <= std::max(width, 400));
            QVERIFY(line.findChild<QLabel*>(QStringLiteral("hint"))->width() >= width / 3);
        }
        QVERIFY(!shows("x -10.00"));
        line.resize(2000, line.height());
        QCoreApplication::processEvents();
        QVERIFY(shows("12 selected, 3.00 × 4.00 m") && shows("x -10.00"));
    }
};

SPACETOW_TEST(StatusLineTest)
#include "status_line_test.moc"
