#include "editor/canvas/force_painter.h"

#include "editor/canvas/figure_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr double longestArrow = 110;        // px
constexpr double shortestArrow = 14;        // px
constexpr double leastShare = 0.01;         // of the strongest: less is not shown
constexpr double forceArrowHead = 9;        // px
constexpr double leastForce = 1e-9;         // N
constexpr std::size_t mostForceLabels = 12; // of many contacts only the strongest have words

constexpr std::array<const char*, 5> forceNames{
    QT_TRANSLATE_NOOP("Forces", "Gravity"), QT_TRANSLATE_NOOP("Forces", "Applied"),
    QT_TRANSLATE_NOOP("Forces", "Connectors"), QT_TRANSLATE_NOOP("Forces", "Contact"),
    QT_TRANSLATE_NOOP("Forces", "Damping")};

void paintArrow(const Stage& stage, const QPointF& from, const QPointF& to) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / length;
    const QPointF aside(-along.y(), along.x());
    const QPointF neck = to - forceArrowHead * along;
    stage.painter.drawLine(from, neck);
    const QPointF head[] = {to, neck + 0.5 * forceArrowHead * aside, neck - 0.5 * forceArrowHead * aside};
    stage.painter.drawPolygon(head, 3);
}

} // namespace

std::vector<ForceArrow> forceArrows(const World& world, BodyId body) {
    const BodyForces forces = explained(world, body).forces;
    const Vec2 center = world.body(body).massCenter;
    using Source = ForceArrow::Source;
    std::vector<ForceArrow> arrows{{Source::Gravity, center, forces.gravity.force},
                                   {Source::Applied, center, forces.applied.force},
                                   {Source::Connectors, center, forces.connectors.force},
                                   {Source::Damping, center, forces.damping.force}};
    if (world.body(body).kind == BodyKind::Dynamic) {
        for (const ContactReading& contact : contactsOf(world, body)) {
            const double toForce = (contact.a == body ? -1 : 1) / world.parameters().seconds;
            arrows.push_back({Source::Contact, contact.point, toForce * contact.impulse});
        }
    }
    double strongest = leastForce;
    for (const ForceArrow& arrow : arrows) {
        strongest = std::max(strongest, arrow.force.norm());
    }
    std::erase_if(arrows, [&](const ForceArrow& a) { return !(a.force.norm() >= leastShare * strongest); });
    return arrows;
}

QString forceName(ForceArrow::Source source) {
    return QCoreApplication::translate("Forces", forceNames[static_cast<std::size_t>(source)]);
}

QColor forceColor(ForceArrow::Source source, Shade shade) {
    static constexpr std::array<QRgb, 5> onDark{0xff56b4e9, 0xffe69f00, 0xff00c08d, 0xffff7a3c, 0xffd0d0d0};
    static constexpr std::array<QRgb, 5> onLight{0xff0072b2, 0xff9a6700, 0xff00714f, 0xffb84600, 0xff505050};
    return QColor::fromRgb((shade == Shade::Dark ? onDark : onLight)[static_cast<std::size_t>(source)]);
}

void paintForces(const Stage& stage, const std::vector<ForceArrow>& arrows, LabelPainter& labels) {
    double strongest = leastForce;
    for (const ForceArrow& arrow : arrows) {
        strongest = std::max(strongest, arrow.force.norm());
    }
    const SavedPainter saved(stage.painter);
    std::vector<ForceArrow> byStrength = arrows;
    std::ranges::stable_sort(byStrength, std::ranges::greater{}, [](const ForceArrow& a) { return a.force.norm(); });
    std::vector<std::pair<Vec2, QString>> words;
    for (const ForceArrow& arrow : byStrength) {
        const double size = arrow.force.norm();
        const double length = std::max(shortestArrow, longestArrow * size / strongest);
        const Vec2 tip = arrow.at + length * stage.view.pixel() * arrow.force / size;
        const QColor color = forceColor(arrow.source, stage.theme.shade);
        for (const auto& [ink, width] : {std::pair(stage.theme.halo, 5.0), std::pair(color, 2.4)}) {
            stage.painter.setPen(stroke(ink, width));
            stage.painter.setBrush(ink);
            paintArrow(stage, stage.at(arrow.at), stage.at(tip));
        }
        if (words.size() < mostForceLabels) {
            words.emplace_back(tip, QStringLiteral("%1 %2 N").arg(forceName(arrow.source), figureText(size)));
        }
    }
    for (const auto& [at, text] : words) {
        labels.paint(at, text);
    }
}

} // namespace spacetow
