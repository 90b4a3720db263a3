#pragma once
// How well colours are told apart: contrast of luminance (WCAG 2) and distance in CIE L*a*b*, for full colour vision
// and the three kinds of missing cones (Machado, Oliveira and Fernandes 2009, severity 1).

#include <QColor>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow::test {

using Triple = std::array<double, 3>;

inline Triple linear(const QColor& color) {
    const auto channel = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return {channel(color.redF()), channel(color.greenF()), channel(color.blueF())};
}

inline Triple times(const std::array<double, 9>& matrix, const Triple& v) {
    Triple result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
            result[row] += matrix[3 * row + i] * v[i];
        }
    }
    return result;
}

/// From 1 (equal) to 21 (black on white).
inline double contrast(const QColor& a, const QColor& b) {
    const auto luminance = [](const QColor& color) {
        const Triple l = linear(color);
        return 0.2126 * l[0] + 0.7152 * l[1] + 0.0722 * l[2];
    };
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

/// What is seen of a colour that is partly transparent.
inline QColor over(const QColor& ground, const QColor& color) {
    const double share = color.alphaF();
    const auto channel = [share](double below, double above) { return below + (above - below) * share; };
    return QColor::fromRgbF(static_cast<float>(channel(ground.redF(), color.redF())),
                            static_cast<float>(channel(ground.greenF(), color.greenF())),
                            static_cast<float>(channel(ground.blueF(), color.blueF())));
}

inline Triple lab(const Triple& rgb) {
    constexpr std::array<double, 9> toXyz{0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522,
                                          0.0721750, 0.0193339, 0.1191920, 0.9503041};
    const Triple xyz = times(toXyz, rgb);
    const Triple white{0.95047, 1, 1.08883};
    Triple f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

inline constexpr std::array<std::array<double, 9>, 4> visions{{
    {1, 0, 0, 0, 1, 0, 0, 0, 1},
    {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}, // no red cones
    {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},  // no green ones
    {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}, // no blue ones
}};

/// ΔE (1976) as it is for whom the two colours are most alike.
inline double difference(const QColor& a, const QColor& b) {
    double least = 1000;
    for (const std::array<double, 9>& vision : visions) {
        const auto seen = [&vision](const QColor& color) {
            Triple rgb = times(vision, linear(color));
            for (double& channel : rgb) {
                channel = std::clamp(channel, 0.0, 1.0);
            }
            return lab(rgb);
        };
        const Triple one = seen(a);
        const Triple other = seen(b);
        least = std::min(least, std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]));
    }
    return least;
}

} // namespace spacetow::test
