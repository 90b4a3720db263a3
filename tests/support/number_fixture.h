#pragma once
// A number field over one number or several, its label, and a second widget for the focus to go to.

#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/window/messages.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <functional>
#include <vector>

namespace spacetow::test {

struct NumberFixture {
    explicit NumberFixture(std::vector<double> numbers, NumberSpec spec = {}) : values(std::move(numbers)) {
        auto* column = new QVBoxLayout(&window);
        field = new NumberField(&window);
        label = new ScrubLabel("Length", *field, &window);
        other = new QLineEdit(&window);
        column->addWidget(label);
        column->addWidget(field);
        column->addWidget(other);
        field->setSpec(spec);
        field->words = [](const Error& error) { return sentence(error); };
        field->enter = [this](const NumberEntry& entry) {
            ++entries;
            last = entry;
            if (entry.phase == NumberEntry::Phase::Cancelled) {
                values = before;
            } else if (entry.change) {
                if (entry.phase == NumberEntry::Phase::Preview && before.empty()) {
                    before = values;
                }
                for (std::size_t i = 0; i < values.size(); ++i) {
                    const std::vector<double>& from = before.empty() ? values : before;
                    values[i] = applied(*entry.change, from[i]);
                }
            }
            if (entry.phase != NumberEntry::Phase::Preview) {
                before.clear();
            }
            show();
            return objection;
        };
        show();
        window.resize(300, 120);
        window.show();
        window.activateWindow();
        QApplication::processEvents();
        other->setFocus();
    }
    void show() {
        const bool mixed = std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end();
        if (mixed) {
            field->setMixed();
        } else {
            field->setValue(values.front());
        }
    }
    void type(const QString& text) {
        field->setFocus();
        field->selectAll();
        for (const QChar letter : text) { // of any script, which keyClicks() is not for
            QTest::sendKeyEvent(QTest::Click, field, Qt::Key_unknown, letter, Qt::NoModifier);
        }
    }
    void enter(const QString& text) {
        type(text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void wheel(int delta) {
        QWheelEvent event(QPointF(5, 5), field->mapToGlobal(QPointF(5, 5)), QPoint(), QPoint(0, delta), Qt::NoButton,
                          {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(field, &event);
    }
    void drag(QWidget& from, const std::vector<int>& to, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint start = from.rect().center();
        QTest::mousePress(&from, Qt::LeftButton, {}, start);
        // Where a drag begins does not count.
        const int threshold = QApplication::startDragDistance();
        move(from, start + QPoint(threshold, 0), modifiers);
        for (const int x : to) {
            move(from, start + QPoint(threshold + x, 0), modifiers);
        }
        end = start + QPoint(threshold + (to.empty() ? 0 : to.back()), 0);
    }
    void move(QWidget& over, const QPoint& at, Qt::KeyboardModifiers modifiers) {
        QMouseEvent event(QEvent::MouseMove, at, over.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&over, &event);
    }
    void drop(QWidget& from) { QTest::mouseRelease(&from, Qt::LeftButton, {}, end); }

    std::vector<double> values;
    std::vector<double> before; // of a drag
    QWidget window;
    NumberField* field;
    ScrubLabel* label;
    QLineEdit* other;
    int entries = 0;
    NumberEntry last;
    QString objection;
    QPoint end;
};

inline NumberSpec metres() {
    NumberSpec spec;
    spec.unit = "m";
    spec.min = -1000;
    spec.max = 1000;
    return spec;
}

} // namespace spacetow::test
