#include "editor/canvas/disc_stamps.h"

#include "editor/canvas/scene_painter.h"
#include "tests/support/test_main.h"

#include <QImage>

#include <cmath>

using namespace spacetow;

namespace {

/// 200 × 200 pixels about the origin.
QImage paintedCrowd(const Snapshot& crowd, double scale, DiscStamps* stamps) {
    Viewport view;
    view.scale = scale;
    view.size = Vec2(200, 200);
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(canvasTheme().background);
    QPainter painter(&image);
    paintMoving(Stage{painter, view, canvasTheme()}, crowd, stamps);
    return image;
}

/// Of the lightness of a pixel, of 255.
double meanDifference(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            sum += std::abs(a.pixelColor(x, y).lightness() - b.pixelColor(x, y).lightness());
        }
    }
    return sum / (a.width() * a.height());
}

/// Balls of two sizes, of all kinds that move; at 20 pixels a metre in all quarters of a pixel.
Snapshot crowdOfDiscs(int count) {
    constexpr int perRow = 20;
    Snapshot crowd;
    for (int i = 0; i < count; ++i) {
        const auto look =
            std::make_shared<const BodyLook>(BodyLook{.id = static_cast<std::uint64_t>(i) + 1,
                                                      .key = static_cast<Key>(i + 1),
                                                      .role = BodyRole::Object,
                                                      .kind = i % 5 == 0 ? BodyKind::Kinematic : BodyKind::Dynamic,
                                                      .tangible = i % 7 != 0,
                                                      .tags = 0,
                                                      .shapes = {Circle{{0, 0}, i % 3 == 0 ? 0.1375 : 0.2}}});
        const int row = i / perRow;
        const Vec2 place(-4.5 + 0.4625 * (i % perRow), -4.5 + 0.4375 * row);
        crowd.moving.push_back({look, {place, Rot::fromAngle(0.1 * i)}, {0, 0}, 0});
    }
    return crowd;
}

} // namespace

class DiscStampsTest : public QObject {
    Q_OBJECT

  private slots:
    void stampedDiscsAreThoseThatArePainted() {
        const Snapshot crowd = crowdOfDiscs(400);
        DiscStamps stamps;
        const double difference = meanDifference(paintedCrowd(crowd, 20, nullptr), paintedCrowd(crowd, 20, &stamps));
        QVERIFY2(difference < 0.5, qPrintable(QString::number(difference)));
        QVERIFY(stamps.size() > 10);
    }
    void betweenQuartersOfAPixelTheyStandOffByLessThanAnEighth() {
        const Snapshot crowd = crowdOfDiscs(400);
        DiscStamps stamps;
        const double difference = meanDifference(paintedCrowd(crowd, 37, nullptr), paintedCrowd(crowd, 37, &stamps));
        QVERIFY2(difference < 8, qPrintable(QString::number(difference)));
    }
    void eachIsMadeOnce() {
        const Snapshot crowd = crowdOfDiscs(400);
        DiscStamps stamps;
        const QImage first = paintedCrowd(crowd, 20, &stamps);
        const std::size_t made = stamps.size();
        QCOMPARE(paintedCrowd(crowd, 20, &stamps), first);
        QCOMPARE(stamps.size(), made);
    }
    void aFewDiscsArePaintedEach() {
        const Snapshot few = crowdOfDiscs(40);
        DiscStamps stamps;
        QCOMPARE(paintedCrowd(few, 20, &stamps), paintedCrowd(few, 20, nullptr));
        QCOMPARE(stamps.size(), std::size_t(0));
    }
    void largeDiscsArePaintedEach() {
        const Snapshot crowd = crowdOfDiscs(400);
        DiscStamps stamps;
        paintedCrowd(crowd, 2 * DiscStamps::largest / 0.1375, &stamps);
        QCOMPARE(stamps.size(), std::size_t(0));
    }
};

SPACETOW_TEST(DiscStampsTest)
#include "disc_stamps_test.moc"
