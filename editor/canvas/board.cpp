#include "editor/canvas/board.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace spacetow {

namespace {

constexpr int affordable = 250; // segments that may be painted while the user waits for the frame; 2 to 5 ms
constexpr int ahead = 4;        // of the shorter side of the view, the part that is painted beyond it on each side

Frame2D withMargin(const Frame2D& frame) {
    const QSize size = frame.deviceSize();
    return frame.grown(std::min(size.width(), size.height()) / ahead);
}

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
    if (m_picture.isEmpty() || (free && plan.work <= affordable)) {
        bring(plan);
        if (free && m_picture.isNearBorder(request.frame)) {
            paintBeside(request);
        }
        return;
    }
    if (m_picture.follow(plan)) {
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
