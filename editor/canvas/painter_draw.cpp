#include "editor/canvas/painter_draw.h"

#include "editor/canvas/round_stamps.h"

#include <algorithm>
#include <array>
#include <optional>

namespace spacetow {

namespace {

constexpr double boxWidth = 1;    // px
constexpr double lineWidth = 1.5; // px
constexpr double arrowHead = 6;   // px
constexpr double spare = 8;       // px, for pens and arrow heads

QPointF toPoint(const Vec2& point) {
    return {point.x(), point.y()};
}

QRectF toRect(const Aabb& box) {
    return {toPoint(box.min), toPoint(box.max)};
}

/// The view in small squares, some of which are taken.
class TakenSquares {
  public:
    explicit TakenSquares(const Aabb& view)
        : m_view(toRect(view)), m_columns(squares(m_view.width())), m_rows(squares(m_view.height())),
          m_taken(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows)) {}

    bool isFree(const QRectF& rect) const {
        bool free = true;
        visit(rect, [&](std::size_t square) { free = free && !m_taken[square]; });
        return free;
    }
    void take(const QRectF& rect) {
        visit(rect, [&](std::size_t square) { m_taken[square] = true; });
    }

  private:
    static constexpr double side = 4; // px

    static int squares(double length) { return static_cast<int>(length / side) + 1; }
    template <class Visit>
    void visit(const QRectF& rect, Visit visit) const {
        const QRectF seen = (rect & m_view).translated(-m_view.topLeft());
        if (seen.isEmpty()) {
            return;
        }
        for (int row = static_cast<int>(seen.top() / side); row <= static_cast<int>(seen.bottom() / side); ++row) {
            for (int column = static_cast<int>(seen.left() / side); column <= static_cast<int>(seen.right() / side);
                 ++column) {
                visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
                      static_cast<std::size_t>(column));
            }
        }
    }

    QRectF m_view;
    int m_columns, m_rows;
    std::vector<bool> m_taken;
};

QPolygonF toPolygon(std::span<const Vec2> outline) {
    QPolygonF points;
    points.reserve(static_cast<qsizetype>(outline.size()));
    for (const Vec2& point : outline) {
        points << toPoint(point);
    }
    return points;
}

QRectF around(const Vec2& center, double radius) {
    return {center.x() - radius, center.y() - radius, 2 * radius, 2 * radius};
}

Aabb boxOf(std::span<const Vec2> points) {
    Aabb box;
    for (const Vec2& point : points) {
        box.include(point);
    }
    return box;
}

Aabb boxOf(const Vec2& a, const Vec2& b) {
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

/// The part of a line that can be seen: painters take long over lines that are millions of pixels long.
std::optional<QLineF> seenPart(const Vec2& a, const Vec2& b, const Aabb& visible) {
    double from = 0;
    double to = 1;
    const Vec2 way = b - a;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) {
            continue; // its box overlaps what is visible, so it is within
        }
        const double low = (visible.min[axis] - a[axis]) / way[axis];
        const double high = (visible.max[axis] - a[axis]) / way[axis];
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
    }
    return from <= to ? std::optional(QLineF(toPoint(a + from * way), toPoint(a + to * way))) : std::nullopt;
}

} // namespace

Color toColor(const QColor& color) {
    const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
    return {channel(color.red()), channel(color.green()), channel(color.blue()), channel(color.alpha())};
}

QColor toQColor(const Color& color) {
    return {color.red, color.green, color.blue, color.alpha};
}

PainterDraw::PainterDraw(const Vec2& size) : m_visible(Aabb{Vec2(0, 0), size}.grown(spare)) {}

PainterDraw::Batch& PainterDraw::batch(const Color& color) {
    ++m_marks;
    if (m_last < m_batches.size() && m_batches[m_last].color == color) {
        return m_batches[m_last];
    }
    const auto found = std::ranges::find(m_batches, color, &Batch::color);
    m_last = static_cast<std::size_t>(found - m_batches.begin());
    if (found == m_batches.end()) {
        m_batches.push_back({.color = color});
    }
    return m_batches[m_last];
}

void PainterDraw::circle(const Vec2& center, double radius, const Color& color) {
    if (sees(Aabb{center, center}.grown(radius))) {
        batch(color).circles.push_back(around(center, radius));
    }
}

void PainterDraw::filledCircle(const Vec2& center, double radius, const Color& color) {
    if (sees(Aabb{center, center}.grown(radius))) {
        batch(color).discs.push_back(around(center, radius));
    }
}

void PainterDraw::polygon(std::span<const Vec2> outline, const Color& color) {
    if (sees(boxOf(outline))) {
        batch(color).outlines.push_back(toPolygon(outline));
    }
}

void PainterDraw::filledPolygon(std::span<const Vec2> outline, const Color& color) {
    if (sees(boxOf(outline))) {
        batch(color).areas.push_back(toPolygon(outline));
    }
}

void PainterDraw::line(const Vec2& a, const Vec2& b, const Color& color) {
    if (!sees(boxOf(a, b))) {
        return;
    }
    if (const std::optional<QLineF> seen = seenPart(a, b, m_visible)) {
        batch(color).lines.push_back(*seen);
    }
}

void PainterDraw::rectangle(const Aabb& box, const Color& color) {
    if (sees(box)) {
        const Aabb seen{box.min.cwiseMax(m_visible.min), box.max.cwiseMin(m_visible.max)};
        batch(color).boxes.push_back(toRect(seen));
    }
}

void PainterDraw::filledRectangle(const Aabb& box, const Color& color) {
    if (sees(box)) {
        const Aabb seen{box.min.cwiseMax(m_visible.min), box.max.cwiseMin(m_visible.max)};
        batch(color).filledBoxes.push_back(toRect(seen));
    }
}

void PainterDraw::text(const Vec2& at, std::string_view text, const Color& color) {
    constexpr std::size_t most = 300; // nobody reads more
    if (m_visible.contains(at) && m_texts.size() < most) {
        const QString shown = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
        m_texts.push_back({toPoint(at), shown, color});
    }
}

void PainterDraw::name(const Vec2& at, std::string_view name, const Color& color, std::uint64_t user) {
    if (m_visible.contains(at)) {
        const QString shown = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        m_names.push_back({toPoint(at), shown, color, user});
    }
}

void PainterDraw::placeNames(const QFontMetricsF& metrics, const std::function<int(std::uint64_t user)>& rank) {
    constexpr double across = 12, down = 6; // px, between names, so that the bodies below are seen
    constexpr int ranks = 3;
    std::array<std::vector<Name>, ranks> waiting;
    for (Name& one : m_names) {
        waiting[static_cast<std::size_t>(std::clamp(rank(one.user), 0, ranks - 1))].push_back(std::move(one));
    }
    m_names.clear();
    TakenSquares taken(m_visible);
    for (const std::vector<Name>& alike : waiting) {
        for (const Name& one : alike) {
            const QRectF start(one.at.x(), one.at.y() - metrics.ascent(), 1, metrics.height());
            if (!taken.isFree(start)) { // most of a crowd are, and measuring takes longer than looking
                m_leavesOutNames = true;
                continue;
            }
            QRectF place = start;
            place.setWidth(metrics.horizontalAdvance(one.text));
            if (!taken.isFree(place)) {
                m_leavesOutNames = true;
                continue;
            }
            taken.take(place.adjusted(-across, -down, across, down));
            m_texts.push_back({one.at, one.text, one.color});
            m_named.push_back(one.user);
        }
    }
    std::ranges::sort(m_named);
}

void PainterDraw::arrow(const Vec2& from, const Vec2& to, const Color& color) {
    line(from, to, color);
    const Vec2 way = to - from;
    const double length = way.norm();
    if (length > 2 * arrowHead && sees(boxOf(to, to))) {
        const Vec2 along = way * (arrowHead / length);
        const Vec2 across = 0.5 * leftOf(along);
        line(to, to - along + across, color);
        line(to, to - along - across, color);
    }
}

void PainterDraw::leftOut(const Vec2& at) {
    constexpr double side = 64; // px, of a square
    if (!m_visible.contains(at)) {
        return;
    }
    const auto squares = [](double length) { return static_cast<std::size_t>(length / side); };
    const Vec2 size = m_visible.size();
    const Vec2 from = at - m_visible.min;
    const std::size_t columns = squares(size.x()) + 1;
    m_dotted.resize(columns * (squares(size.y()) + 1));
    const std::size_t square = squares(from.y()) * columns + squares(from.x());
    if (!m_dotted[square]) {
        m_dotted[square] = true;
        m_dots.push_back(at);
    }
}

void PainterDraw::paint(const Stage& stage) const {
    for (const Batch& one : m_batches) {
        paintFillings(stage.painter, one);
    }
    for (const Batch& one : m_batches) {
        paintLines(stage.painter, one);
    }
    paintTexts(stage);
}

void PainterDraw::paintFillings(QPainter& painter, const Batch& batch) const {
    const bool wasSmooth = painter.testRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::Antialiasing, wasSmooth && !isCrowd());
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(batch.color));
    for (const QRectF& box : batch.filledBoxes) {
        painter.fillRect(box, toQColor(batch.color));
    }
    for (const QPolygonF& area : batch.areas) {
        painter.drawPolygon(area);
    }
    paintDiscs(painter, batch);
    painter.setRenderHint(QPainter::Antialiasing, wasSmooth);
}

/// With the brush that is set. Those of a crowd that are hardly more than a point are squares.
void PainterDraw::paintDiscs(QPainter& painter, const Batch& batch) const {
    constexpr double tiny = 3.5; // px, of a radius
    if (!isCrowd()) {
        for (const QRectF& disc : batch.discs) {
            painter.drawEllipse(disc);
        }
        return;
    }
    std::vector<QRectF> round;
    for (const QRectF& disc : batch.discs) {
        if (disc.width() < 2 * tiny) {
            painter.fillRect(disc, toQColor(batch.color));
        } else {
            round.push_back(disc);
        }
    }
    stampEllipses(painter, round);
}

void PainterDraw::paintLines(QPainter& painter, const Batch& batch) const {
    const bool wasSmooth = painter.testRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::Antialiasing, wasSmooth && !isCrowd());
    const auto pen = [&](double width) { return stroke(toQColor(batch.color), isCrowd() ? 1 : width); };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen(boxWidth));
    painter.drawRects(batch.boxes.data(), static_cast<int>(batch.boxes.size()));
    painter.setPen(pen(lineWidth));
    for (const QPolygonF& outline : batch.outlines) {
        painter.drawPolygon(outline);
    }
    if (isCrowd()) {
        stampEllipses(painter, batch.circles);
    } else {
        for (const QRectF& circle : batch.circles) {
            painter.drawEllipse(circle);
        }
    }
    painter.drawLines(batch.lines.data(), static_cast<int>(batch.lines.size()));
    painter.setRenderHint(QPainter::Antialiasing, wasSmooth);
}

/// With a halo, as they may lie on anything.
void PainterDraw::paintTexts(const Stage& stage) const {
    for (const Text& one : m_texts) {
        stage.painter.setPen(stage.theme.halo);
        for (const QPointF& beside : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
            stage.painter.drawText(one.at + beside, one.text);
        }
        stage.painter.setPen(toQColor(one.color));
        stage.painter.drawText(one.at, one.text);
    }
}

} // namespace spacetow
