#include "editor/exchange/import.h"

#include "core/base/overloaded.h"
#include "core/level/edits.h"
#include "core/level/fields.h"
#include "core/level/object_geometry.h"
#include "editor/exchange/codes.h"
#include "editor/exchange/import_tags.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

namespace {

constexpr std::size_t mostCircleVertices = 1; // what a circle counts for

std::vector<Vec2>* verticesIn(LevelShape& shape) {
    return std::visit(
        [](auto& one) -> std::vector<Vec2>* {
            if constexpr (requires { one.vertices; }) {
                return &one.vertices;
            } else {
                return nullptr;
            }
        },
        shape);
}

class ImportMaker {
  public:
    ImportMaker(const Drawing& drawing, const ImportOptions& options, const Watch& watch)
        : m_drawing(drawing), m_watch(watch), m_tags(drawing.tags, m_report) {
        m_options.scale = options.scale.value_or(drawing.metresPerUnit);
        m_options.tolerance = std::max(options.tolerance, leastTolerance);
        m_options.walls = options.walls;
        m_options.fillsAsWalls = options.fillsAsWalls;
    }

    Result<Import> made() {
        const std::vector<DrawnItem>& items = m_drawing.items;
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (m_watch.isStopped()) {
                return Error{ExchangeCode("import-stopped"), {}};
            }
            m_watch.tell(static_cast<int>(i * 100 / items.size()));
            add(items[i], static_cast<Key>(i + 1));
            if (m_error) {
                return *m_error;
            }
        }
        dropEmptyGroups();
        if (m_objects.empty()) {
            return Error{ExchangeCode("import-nothing"), {}};
        }
        Import import;
        import.notes = notes();
        import.foreign = {std::move(m_objects), m_tags.table()};
        import.vertices = static_cast<int>(m_vertices);
        import.scale = m_options.scale;
        return import;
    }
    std::vector<Error> notes() const {
        std::vector<Error> all = m_drawing.notes;
        std::ranges::move(m_report.notes(), std::back_inserter(all));
        return all;
    }

  private:
    void add(const DrawnItem& item, Key key) {
        Object object;
        object.key = key;
        object.name = item.name;
        object.parent = static_cast<Key>(item.parent + 1);
        object.visible = item.visible;
        object.locked = item.locked;
        const std::optional<ObjectData> data = std::visit(
            Overloaded{[&](const Figure& figure) { return bodyOf(item, figure); },
                       [](const Folder& folder) -> std::optional<ObjectData> {
                           return GroupObject{folder.layer, folder.color};
                       },
                       [&](const ReadyObject& ready) -> std::optional<ObjectData> { return scaled(ready.data); }},
            item.what);
        if (data) {
            object.data = *data;
            checkPlace(object.data);
            m_objects.push_back(std::move(object));
        }
    }

    std::optional<ObjectData> bodyOf(const DrawnItem& item, const Figure& figure) {
        BodyObject body;
        Result<std::vector<LevelShape>> made = shapesOf(item, figure, m_options, m_report);
        if (!made) {
            m_error = made.error();
            return {};
        }
        std::vector<LevelShape> shapes = std::move(made).value();
        if (shapes.empty()) {
            return {};
        }
        std::vector<Vec2>* const first = verticesIn(shapes.front());
        body.position = first != nullptr ? first->front() : std::get<Circle>(shapes.front()).center;
        for (LevelShape& shape : shapes) {
            countVertices(shape);
            std::vector<Vec2>* const vertices = verticesIn(shape);
            if (vertices == nullptr) {
                Vec2& center = std::get<Circle>(shape).center;
                center = tidied(Vec2(center - body.position));
                continue;
            }
            for (Vec2& vertex : *vertices) {
                vertex = tidied(Vec2(vertex - body.position));
            }
        }
        body.shapes = ShapeList(std::move(shapes));
        body.filter.tags = m_tags.maskOf(item, figure.tags);
        body.friction = figure.friction.value_or(body.friction);
        body.restitution = figure.restitution.value_or(body.restitution);
        body.density = figure.density.value_or(body.density);
        return body;
    }

    ObjectData scaled(ObjectData data) {
        const double scale = m_options.scale;
        if (auto* connector = std::get_if<ConnectorObject>(&data)) {
            connector->anchorA *= scale;
            connector->anchorB *= scale;
            if (connector->length) {
                *connector->length = std::min(*connector->length * scale, limits::coordinate);
            }
        } else if (auto* payload = std::get_if<PayloadObject>(&data)) {
            payload->position *= scale; // its size is that of the game
        } else if (scale != 1) {
            transform(data, Affine::scaling({0, 0}, {scale, scale}));
        }
        if (auto* body = std::get_if<BodyObject>(&data)) {
            for (LevelShape& shape : body->shapes) {
                auto* const line = std::get_if<LineChain>(&shape);
                if (line != nullptr && m_options.walls == ImportedWalls::OneWay) {
                    shape = EdgeChain{std::move(line->vertices), line->closed, noBack};
                }
                countVertices(shape);
            }
        }
        return data;
    }

    void countVertices(LevelShape& shape) {
        const std::vector<Vec2>* const vertices = verticesIn(shape);
        m_vertices += vertices != nullptr ? vertices->size() : mostCircleVertices;
        if (m_vertices > limits::vertices) {
            m_error = Error{ExchangeCode("import-too-many-vertices"), {std::to_string(limits::vertices)}};
        }
    }

    void checkPlace(const ObjectData& data) {
        if (std::holds_alternative<GroupObject>(data) || std::holds_alternative<ConnectorObject>(data)) {
            return; // others place them
        }
        const Aabb box = ownBounds(data);
        if (!isWithinReach(box.min) || !isWithinReach(box.max)) {
            m_error = Error{ExchangeCode("import-too-far"), {std::to_string(static_cast<int>(farthestImport))}};
        }
    }

    void dropEmptyGroups() {
        std::vector<bool> used(m_drawing.items.size() + 1, false);
        for (auto object = m_objects.rbegin(); object != m_objects.rend(); ++object) {
            if (!std::holds_alternative<GroupObject>(object->data) || used[object->key]) {
                used[object->key] = true;
                used[object->parent] = true;
            }
        }
        std::erase_if(m_objects, [&used](const Object& object) { return !used[object.key]; });
    }

    const Drawing& m_drawing;
    ShapeOptions m_options;
    const Watch& m_watch;
    Report m_report;
    ImportTags m_tags;
    std::vector<Object> m_objects;
    std::size_t m_vertices = 0;
    std::optional<Error> m_error;
};

Vec2 shiftOf(const ForeignObjects& foreign, const ImportPlace& place) {
    Aabb box;
    for (const Object& object : foreign.objects) {
        box.include(ownBounds(object.data));
    }
    if (!place.middle || box.isEmpty()) {
        return {0, 0};
    }
    Vec2 shift = *place.middle - box.center();
    if (place.step > 0) {
        shift = place.step * Vec2((shift / place.step).array().round());
    }
    return tidied(shift);
}

} // namespace

Result<Import> importOf(const Drawing& drawing, const ImportOptions& options, const Watch& watch,
                        std::vector<Error>* leftOut) {
    ImportMaker maker(drawing, options, watch);
    Result<Import> import = maker.made();
    if (!import && leftOut != nullptr) {
        *leftOut = maker.notes();
    }
    return import;
}

Imported imported(Level level, ForeignObjects foreign, const ImportPlace& place) {
    const bool isTaken = std::ranges::any_of(foreign.objects, [&level](const Object& object) {
        return (std::holds_alternative<ShipObject>(object.data) && firstOf<ShipObject>(level) != nullptr) ||
               (std::holds_alternative<PayloadObject>(object.data) && firstOf<PayloadObject>(level) != nullptr) ||
               (std::holds_alternative<FinishObject>(object.data) && firstOf<FinishObject>(level) != nullptr);
    });
    CopyPlace copy;
    copy.delta = shiftOf(foreign, place);
    copy.seed = place.seed;
    if (place.layer) {
        Object layer;
        layer.key = copy.parent = freshKey(level, place.seed);
        layer.name = *place.layer;
        layer.data = GroupObject{true, {}};
        level.objects.append(std::move(layer));
        for (Object& object : foreign.objects) {
            if (auto* group = std::get_if<GroupObject>(&object.data)) {
                group->layer = false;
            }
        }
    }
    AdoptedObjects adopted = withTagsAdopted(std::move(level), std::move(foreign));
    Imported result;
    result.notes = std::move(adopted.notes);
    if (isTaken) {
        result.notes.push_back(Error{ExchangeCode("import-one-only"), {}});
    }
    result.level = pasted(std::move(adopted.level), adopted.objects, copy, result.keys);
    return result;
}

} // namespace spacetow
