#pragma once
// An inspector over a level of a few objects.

#include "editor/panels/inspector.h"
#include "editor/window/messages.h"

#include <QApplication>
#include <QCheckBox>
#include <QTest>

#include <vector>

namespace spacetow::test {

inline Object circleObject(Key key, double x, double radius) {
    BodyObject body;
    body.shapes = {Circle{Vec2(0, 0), radius}};
    body.position = Vec2(x, 0);
    return {key, {}, body, {}};
}

inline Object twoCircles(Key key, double first, double second) {
    BodyObject body;
    body.shapes = {Circle{Vec2(0, 0), first}, Circle{Vec2(1, 0), second}};
    return {key, {}, body, {}};
}

inline Object wallObject(Key key, double depth) {
    BodyObject body;
    body.shapes = {EdgeChain{{Vec2(0, 0), Vec2(1, 0)}, false, depth}};
    return {key, {}, body, {}};
}

inline Level levelOfObjects(std::vector<Object> objects) {
    Level level;
    for (Object& object : objects) {
        level.objects.append(std::move(object));
    }
    return level;
}

/// An inspector in sight, with these objects selected.
struct InspectorFixture {
    InspectorFixture(std::vector<Object> objects, std::vector<Key> selected)
        : document(levelOfObjects(std::move(objects))),
          inspector(document, [](const Error& error) { return sentence(error); }) {
        document.select(Selection(std::move(selected)));
        inspector.resize(340, 900);
        inspector.show();
        inspector.activateWindow();
        QApplication::processEvents();
    }
    NumberField& number(const char* id) { return *qobject_cast<NumberField*>(inspector.form().editor(id)); }
    QCheckBox& box(const char* id) { return *qobject_cast<QCheckBox*>(inspector.form().editor(id)); }
    bool isSeen(const char* id) { return inspector.form().editor(id)->isVisible(); }
    void type(const char* id, const QString& text) {
        NumberField& field = number(id);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text.isEmpty() ? QString() : text);
        if (text.isEmpty()) {
            QTest::keyClick(&field, Qt::Key_Delete);
        }
        QTest::keyClick(&field, Qt::Key_Return);
    }
    double radius(int object, std::size_t shape) { return std::get<Circle>(body(object).shapes[shape]).radius; }
    const BodyObject& body(int index) { return std::get<BodyObject>(document.level().objects[index].data); }

    Document document;
    Inspector inspector;
};

} // namespace spacetow::test
