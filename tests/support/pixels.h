#pragma once
// What there is on a picture.

#include <QColor>
#include <QImage>

#include <cstdlib>

namespace spacetow::test {

/// How many pixels differ from the colour by less than that, all channels together.
inline int pixelsLike(const QImage& image, const QColor& color, int tolerance) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor at = image.pixelColor(x, y);
            const int off = std::abs(at.red() - color.red()) + std::abs(at.green() - color.green()) +
                            std::abs(at.blue() - color.blue());
            count += off < tolerance ? 1 : 0;
        }
    }
    return count;
}

} // namespace spacetow::test
