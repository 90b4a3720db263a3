#include "editor/canvas/icons.h"

#include "editor/window/actions.h"
#include "tests/support/color_vision.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>

using namespace spacetow;
using namespace spacetow::test;

namespace {

QStringList allIcons() {
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")})) {
        names << file.chopped(4);
    }
    names.removeAll(QStringLiteral("spacetow")); // the picture of the program, in colours of its own
    return names;
}

QByteArray sourceOf(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPalette paletteOf(const QColor& panel, const QColor& text) {
    QPalette palette(panel);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(128, 128, 128));
    return palette;
}

/// The colour of the least transparent pixel.
QColor strongest(const QImage& image) {
    QRgb best = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            best = qAlpha(image.pixel(x, y)) > qAlpha(best) ? image.pixel(x, y) : best;
        }
    }
    return QColor(best);
}

int inkedPixels(const QImage& image, const QRect& where) {
    int count = 0;
    for (int y = where.top(); y <= where.bottom(); ++y) {
        for (int x = where.left(); x <= where.right(); ++x) {
            count += qAlpha(image.pixel(x, y)) > 8 ? 1 : 0;
        }
    }
    return count;
}

} // namespace

class IconsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyActionThatNamesAnIconHasIt() {
        int named = 0;
        for (const ActionRow& row : actionRows()) {
            if (*row.icon != '\0') {
                ++named;
                QVERIFY2(!sourceOf(QString::fromLatin1(row.icon)).isEmpty(), row.icon);
            }
        }
        QVERIFY(named > 30);
    }

    void everyIconIsSharpOnLightAndOnDark_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<bool>("dark");
        for (const double ratio : {1.0, 1.5, 2.0}) {
            QTest::addRow("light, at %g", ratio) << ratio << false;
            QTest::addRow("dark, at %g", ratio) << ratio << true;
        }
    }
    void everyIconIsSharpOnLightAndOnDark() {
        QFETCH(double, ratio);
        QFETCH(bool, dark);
        const QColor text = dark ? QColor(230, 232, 240) : QColor(30, 36, 48);
        const QPalette palette = paletteOf(dark ? Qt::black : Qt::white, text);
        QVERIFY(allIcons().size() > 100);
        for (const QString& name : allIcons()) {
            const QPixmap pixmap = icon(name, palette).pixmap(QSize(20, 20), ratio);
            QCOMPARE(pixmap.size(), QSize(20, 20) * ratio); // drawn for this display, not scaled for it
            const QImage image = pixmap.toImage();
            QVERIFY2(inkedPixels(image, image.rect()) > 20 * ratio * ratio, qPrintable(name));
            QVERIFY2(difference(strongest(image), text) < 8, qPrintable(name));
        }
    }

    void everyIconStaysWithinItsBox() {
        constexpr int scale = 4;
        constexpr int margin = 24; // drawn around the box, in which nothing may be
        for (const QString& name : allIcons()) {
            QSvgRenderer renderer(sourceOf(name));
            QVERIFY2(renderer.isValid(), qPrintable(name));
            QCOMPARE(renderer.viewBoxF(), QRectF(0, 0, 24, 24));
            renderer.setViewBox(QRectF(-6, -6, 36, 36));
            QImage image(36 * scale, 36 * scale, QImage::Format_ARGB32);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            renderer.render(&painter, QRectF(image.rect()));
            painter.end();
            const QRect box = image.rect().adjusted(margin, margin, -margin, -margin);
            const int inside = inkedPixels(image, box);
            QVERIFY2(inside > 0, qPrintable(name));
            QVERIFY2(inkedPixels(image, image.rect()) == inside, qPrintable(name));
        }
    }

    void allIconsAreOneFamily() {
        // One grid, one width of line, round ends, the colour of the text.
        const QRegularExpression other(QStringLiteral("stroke-width=\"(?!1\\.75\")|#[0-9a-fA-F]{3}|rgb\\("));
        for (const QString& name : allIcons()) {
            const QByteArray svg = sourceOf(name);
            QVERIFY2(svg.contains("stroke-width=\"1.75\"") && svg.contains("stroke-linecap=\"round\""),
                     qPrintable(name));
            QVERIFY2(svg.contains("currentColor"), qPrintable(name));
            QVERIFY2(!QString::fromLatin1(svg).contains(other), qPrintable(name));
        }
    }

    void whatIsDisabledIsPaler() {
        const QPalette palette = paletteOf(Qt::white, Qt::black);
        const QIcon made = icon(QStringLiteral("save"), palette);
        const QImage normal = made.pixmap(QSize(20, 20), 1, QIcon::Normal).toImage();
        const QImage disabled = made.pixmap(QSize(20, 20), 1, QIcon::Disabled).toImage();
        QVERIFY(normal != disabled);
        QVERIFY(difference(strongest(disabled), QColor(128, 128, 128)) < 3);
    }

    void aLivingIconFollowsTheApplication() {
        const QPalette before = QGuiApplication::palette();
        const QIcon made = livingIcon(QStringLiteral("close"));
        for (const QColor& text : {QColor(230, 232, 240), QColor(30, 36, 48)}) {
            QGuiApplication::setPalette(paletteOf(Qt::gray, text));
            QVERIFY(difference(strongest(made.pixmap(QSize(32, 32)).toImage()), text) < 3);
        }
        QGuiApplication::setPalette(before);
    }

    void anIconOfNoNameIsEmpty() {
        QVERIFY(icon(QStringLiteral("no-such-icon"), QPalette()).isNull());
        QVERIFY(icon(QStringLiteral("no-such-icon"), QColor(Qt::red)).isNull());
    }
};

SPACETOW_TEST(IconsTest)
#include "icons_test.moc"
