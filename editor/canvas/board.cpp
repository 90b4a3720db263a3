#include "editor/canvas/board.h"

#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spacetow {

namespace {

constexpr int affordable = 250;       // segments that may be painted while the user waits for the frame; 2 to 5 ms
constexpr int affordableFirst = 2000; // the same where there is nothing else to show
constexpr int ahead = 4; // of the shorter side of the view, the part that is painted beyond it on each side

Frame2D withMargin(const Frame2D& frame) {
    const QSize size = frame.deviceSize();
    return frame.grown(std::min(size.width(), size.height()) / ahead);
}

/// Where in a frame objects are painted that do not stand still.
class PlacesOfOthers {
  public:
    explicit PlacesOfOthers(const Frame2D& frame) : m_frame(frame) {}

    void add(const Level& level, int place) {
        const Object& object = level.objects[place];
        const auto* body = std::get_if<BodyObject>(&object.data);
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        if (connector != nullptr) {
            addLine(endsOf(*connector, level.objects));
        } else if (body == nullptr ? !std::holds_alternative<GroupObject>(object.data)
                                   : body->kind != BodyKind::Static) {
            addBox(levelIndex(level).boundsOf(place), pens);
        }
        if (body != nullptr && body->kind == BodyKind::Kinematic) { // whose mark is where it turns
            addBox({body->position, body->position}, 2 * pens);
        }
    }
    const std::vector<QRect>& rects() const { return m_rects; }

  private:
    static constexpr double pens = 8; // px

    void addBox(const Aabb& world, double around) {
        const Aabb box = m_frame.view.transform().toView(world).grown(around);
        const Vec2 min = box.min.cwiseMax(Vec2(0, 0)) * m_frame.pixelRatio;
        const Vec2 max = box.max.cwiseMin(m_frame.view.size) * m_frame.pixelRatio;
        if (min.x() < max.x() && min.y() < max.y()) {
            m_rects.emplace_back(QPoint(static_cast<int>(min.x()), static_cast<int>(min.y())),
                                 QPoint(static_cast<int>(max.x()) + 1, static_cast<int>(max.y()) + 1));
        }
    }
    void addLine(const std::optional<std::array<Vec2, 2>>& ends) {
        constexpr double most = 1000; // squares; longer ones have gaps
        if (!ends) {
            return;
        }
        const Vec2 way = ends->back() - ends->front();
        const auto squares = static_cast<int>(std::clamp(way.norm() * m_frame.view.scale / pens, 1.0, most));
        for (int i = 0; i <= squares; ++i) {
            const Vec2 at = ends->front() + way * (static_cast<double>(i) / squares);
            addBox({at, at}, pens);
        }
    }

    const Frame2D& m_frame;
    std::vector<QRect> m_rects;
};

} // namespace

Board::Board(std::function<void()> refined) : m_refined(std::move(refined)) {}

void Board::prepare(const BoardRequest& request) {
    if (m_complete && request == m_wanted) {
        return;
    }
    m_wanted = request;
    m_complete = false;
    const bool free = !m_task.isRunning();
    if (!free && !request.live && !m_picture.isEmpty()) {
        return; // what is being painted comes first
    }
    const BoardPicture::Plan plan = m_picture.planFor(request);
    if (m_picture.isEmpty() ? plan.work <= affordableFirst : free && plan.work <= affordable) {
        bring(plan);
        if (free && m_picture.isNearBorder(request.frame)) {
            paintBeside(request);
        }
        return;
    }
    if (!m_picture.isEmpty() && m_picture.follow(plan)) {
        changeStill({});
    }
    if (free) {
        paintBeside(request);
    }
}

void Board::bring(const BoardPicture::Plan& plan) {
    changeStill(m_picture.stillTouchedBy(plan, plan.request.frame));
    m_picture.bring(plan);
    m_flat.discard();
    m_complete = true;
}

void Board::changeStill(const std::optional<QRegion>& where) {
    if (where && where->isEmpty()) {
        return;
    }
    ++m_stillRevision;
    if (where && m_stillChanges) {
        *m_stillChanges += *where;
    } else {
        m_stillChanges.reset();
    }
}

void Board::drawStill(QPainter& painter) {
    if (m_picture.isEmpty()) {
        return;
    }
    if (!isScaled()) {
        m_picture.drawStill(painter, m_wanted.frame);
        return;
    }
    if (!m_flat.isValid()) {
        m_flat = m_picture.flattened(*m_wanted.theme, BoardLayer::Rock, BoardLayer::Hover);
    }
    m_flat.draw(painter, m_wanted.frame);
}

void Board::drawRest(QPainter& painter) const {
    if (!isScaled()) {
        m_picture.drawRest(painter, m_wanted.frame);
    }
}

PictureLayer Board::groundPicture(bool onRock) const {
    constexpr std::size_t many = 5000;
    if (m_picture.isEmpty()) {
        return {};
    }
    PlacesOfOthers others(m_picture.frame());
    for (int place = 0; place < m_wanted.level->objects.size() && others.rects().size() <= many; ++place) {
        others.add(*m_wanted.level, place);
    }
    if (others.rects().size() > many) {
        return {};
    }
    PictureLayer picture =
        m_picture.flattened(*m_wanted.theme, onRock ? BoardLayer::Rock : BoardLayer::Objects, BoardLayer::Objects);
    for (const QRect& place : others.rects()) {
        picture.cut(place);
    }
    return picture;
}

void Board::paintBeside(const BoardRequest& request) {
    BoardRequest wanted = request;
    wanted.frame = withMargin(request.frame);
    // Pictures share their pixels until one of them is painted on.
    const auto picture = std::make_shared<BoardPicture>(m_picture);
    m_task.start([this, wanted, picture, generation = m_generation](const std::stop_token&) -> BackgroundTask::Then {
        picture->bring(picture->planFor(wanted));
        return [this, picture, generation] {
            if (generation == m_generation) {
                m_picture = std::move(*picture);
                m_flat.discard();
                changeStill({});
                m_complete = false;
            }
            m_refined();
        };
    });
}

void Board::forget() {
    ++m_generation;
    changeStill({});
    m_picture = {};
    m_flat.discard();
    m_complete = false;
}

void Board::finish() {
    while (m_task.isRunning()) {
        m_task.finish();
        prepare(BoardRequest(m_wanted));
    }
}

} // namespace spacetow
