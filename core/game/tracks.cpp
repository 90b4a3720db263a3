#include "core/game/tracks.h"

#include "core/game/thinned_path.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace spacetow {
namespace {

bool moves(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr && body->kind != BodyKind::Static;
}

void addPath(std::vector<TracedPath>& paths, Key object, const std::vector<Vec2>& points) {
    if (points.size() < 2) {
        return;
    }
    TracedPath path{object, thinned(points, Tracks::tolerance)};
    if (path.points.size() > 2 || (path.points.back() - path.points.front()).norm() > Tracks::tolerance) {
        paths.push_back(std::move(path));
    }
}

} // namespace

void Tracks::setFocus(Key object) {
    m_focus = object;
    m_level = nullptr; // bodies are chosen anew
}

void Tracks::add(const Session& session) {
    if (session.sharedLevel() != m_level) {
        choose(session);
    }
    if (session.updates() % m_stride != 0) {
        return;
    }
    constexpr double away = std::numeric_limits<double>::quiet_NaN();
    for (Track& track : m_tracks) {
        const std::optional<BodyId> body = session.bodyOf(track.object);
        if (track.points.empty()) {
            track.first = session.updates();
        }
        track.points.push_back(body ? session.world().body(*body).massCenter : Vec2(away, away));
    }
    if (std::ranges::any_of(m_tracks, [](const Track& track) { return track.points.size() > mostPoints; })) {
        doubleStride();
    }
}

void Tracks::doubleStride() {
    m_stride *= 2;
    for (Track& track : m_tracks) {
        std::deque<Vec2> left;
        const std::int64_t odd = track.first % m_stride == 0 ? 0 : 1;
        for (auto i = static_cast<std::size_t>(odd); i < track.points.size(); i += 2) {
            left.push_back(track.points[i]);
        }
        track.first += odd * m_stride / 2;
        track.points = std::move(left);
    }
}

void Tracks::choose(const Session& session) {
    const std::shared_ptr<const Level> before = std::exchange(m_level, session.sharedLevel());
    const auto isGone = [this](const Track& track) { return m_level->objects.find(track.object) == nullptr; };
    std::erase_if(m_tracks, [&](const Track& track) {
        return isGone(track) && std::ranges::none_of(track.points, [](const Vec2& point) { return isFinite(point); });
    });
    const Object* ship = firstOf<ShipObject>(*m_level);
    const Object* payload = firstOf<PayloadObject>(*m_level);
    for (const Object* object : {ship, payload}) {
        if (object != nullptr) {
            follow(object->key, session.updates());
        }
    }
    if (ship != nullptr) {
        return;
    }
    if (const auto* focus = m_level->objects.find(m_focus); focus != nullptr && moves(*focus)) {
        follow(m_focus, session.updates());
    }
    const auto gone = static_cast<std::size_t>(std::ranges::count_if(m_tracks, isGone));
    for (const Object& object : m_level->objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        const bool isNew = before != nullptr && before->objects.find(object.key) == nullptr; // somebody looks at it
        if (m_tracks.size() - gone < (isNew ? 2 : 1) * mostBodies && body != nullptr &&
            body->kind != BodyKind::Static) {
            follow(object.key, session.updates());
        }
    }
}

void Tracks::follow(Key object, std::int64_t update) {
    if (std::ranges::find(m_tracks, object, &Track::object) == m_tracks.end()) {
        m_tracks.push_back({object, update, {}});
    }
}

void Tracks::forgetBefore(std::int64_t update) {
    for (Track& track : m_tracks) {
        while (!track.points.empty() && track.first < update) {
            track.points.pop_front();
            track.first += m_stride;
        }
    }
}

void Tracks::forgetAfter(std::int64_t update) {
    std::erase_if(m_tracks, [update](const Track& track) { return track.first > update; });
    for (Track& track : m_tracks) {
        const auto left = static_cast<std::size_t>((update - track.first) / m_stride + 1);
        track.points.resize(std::min(track.points.size(), left));
    }
    m_level = nullptr;
}

std::vector<TracedPath> Tracks::pathsFrom(std::int64_t update) const {
    std::vector<TracedPath> paths;
    for (const Track& track : m_tracks) {
        std::vector<Vec2> points;
        const std::int64_t skipped = std::max<std::int64_t>(0, (update - track.first + m_stride - 1) / m_stride);
        for (auto i = static_cast<std::size_t>(skipped); i < track.points.size(); ++i) {
            if (isFinite(track.points[i])) {
                points.push_back(track.points[i]);
            } else {
                addPath(paths, track.object, points);
                points.clear();
            }
        }
        addPath(paths, track.object, points);
    }
    return paths;
}

std::size_t Tracks::bytes() const {
    std::size_t sum = 0;
    for (const Track& track : m_tracks) {
        sum += track.points.size() * sizeof(Vec2);
    }
    return sum;
}

} // namespace spacetow
