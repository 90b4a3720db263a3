#include "editor/panels/wrapping_row.h"

#include <QWidget>

#include <algorithm>

namespace spacetow {

WrappingRow::~WrappingRow() = default;

void WrappingRow::addBeside(QWidget* widget) {
    addWidget(widget);
    m_places.back().isBeside = true;
}

void WrappingRow::addAtEnd(QWidget* widget) {
    addWidget(widget);
    Place& place = m_places.back();
    place.isAtEnd = true;
    place.isBeside = m_places.size() > 1 && m_places[m_places.size() - 2].isAtEnd;
}

void WrappingRow::addItem(QLayoutItem* item) {
    m_places.push_back({std::unique_ptr<QLayoutItem>(item)});
    invalidate();
}

QLayoutItem* WrappingRow::itemAt(int index) const {
    return index >= 0 && index < count() ? m_places[static_cast<std::size_t>(index)].item.get() : nullptr;
}

QLayoutItem* WrappingRow::takeAt(int index) {
    if (itemAt(index) == nullptr) {
        return nullptr;
    }
    QLayoutItem* const item = m_places[static_cast<std::size_t>(index)].item.release();
    m_places.erase(m_places.begin() + index);
    invalidate();
    return item;
}

std::vector<WrappingRow::Group> WrappingRow::groups() const {
    std::vector<Group> all;
    for (const Place& place : m_places) {
        if (place.item->isEmpty()) {
            continue; // hidden
        }
        if (!place.isBeside || all.empty()) {
            all.emplace_back().isAtEnd = place.isAtEnd;
        }
        Group& group = all.back();
        const int before = group.items.empty() ? 0 : gap();
        group.width += before + place.item->sizeHint().width();
        group.least += before + place.item->minimumSize().width();
        group.items.push_back(place.item.get());
    }
    return all;
}

std::vector<WrappingRow::Line> WrappingRow::lines(int width) const {
    std::vector<Line> all;
    int taken = 0;
    for (Group& group : groups()) {
        if (all.empty() || taken + gap() + group.width > width) {
            all.emplace_back();
            taken = -gap();
        }
        taken += gap() + group.width;
        all.back().push_back(std::move(group));
    }
    return all;
}

int WrappingRow::heightOf(const Line& line) {
    int height = 0;
    for (const Group& group : line) {
        for (const QLayoutItem* item : group.items) {
            height = std::max(height, item->sizeHint().height());
        }
    }
    return height;
}

QSize WrappingRow::sizeHint() const {
    int width = 0;
    int height = 0;
    for (const Group& group : groups()) {
        width += group.width + gap();
        height = std::max(height, heightOf({group}));
    }
    return {width, height};
}

QSize WrappingRow::minimumSize() const {
    int width = 0;
    for (const Group& group : groups()) {
        width = std::max(width, group.least);
    }
    return {width, sizeHint().height()};
}

int WrappingRow::heightForWidth(int width) const {
    int height = -gap();
    for (const Line& line : lines(width)) {
        height += gap() + heightOf(line);
    }
    return std::max(height, 0);
}

void WrappingRow::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    int y = rect.y();
    for (const Line& line : lines(rect.width())) {
        const int height = heightOf(line);
        place(line, QRect(rect.x(), y, rect.width(), height));
        y += height + gap();
    }
}

void WrappingRow::place(const Line& line, const QRect& room) const {
    int free = room.width() + gap();
    for (const Group& group : line) {
        free -= gap() + group.width;
    }
    int x = room.x();
    for (const Group& group : line) {
        x += group.isAtEnd ? std::max(free, 0) : 0;
        int lacking = std::max(-free, 0); // in a line of one group only
        for (QLayoutItem* const item : group.items) {
            const QSize size = item->sizeHint();
            const int given = std::min(lacking, std::max(0, size.width() - item->minimumSize().width()));
            lacking -= given;
            const int width = size.width() - given;
            item->setGeometry(QRect(x, room.y() + (room.height() - size.height()) / 2, width, size.height()));
            x += width + gap();
        }
    }
}

} // namespace spacetow
