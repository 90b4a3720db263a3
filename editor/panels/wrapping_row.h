#pragma once
// Controls side by side, in as many lines as the width asks for, so that a bar never makes its window wider. A field
// stays beside its label; what stands at the end, as buttons do, is at the right of the last line.

#include <QLayout>

#include <algorithm>
#include <memory>
#include <vector>

namespace spacetow {

class WrappingRow : public QLayout {
    Q_OBJECT

  public:
    WrappingRow() = default;
    ~WrappingRow() override;

    /// In the line of the one before, whatever the width.
    void addBeside(QWidget* widget);
    /// After all others.
    void addAtEnd(QWidget* widget);

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_places.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    void setGeometry(const QRect& rect) override;

  private:
    struct Place {
        std::unique_ptr<QLayoutItem> item;
        bool isBeside = false;
        bool isAtEnd = false;
    };
    /// Items that stay in one line.
    struct Group {
        std::vector<QLayoutItem*> items;
        int width = 0; // pixels
        int least = 0; // pixels, when it has a line for itself and that is short
        bool isAtEnd = false;
    };
    using Line = std::vector<Group>;

    int gap() const { return std::max(0, spacing()); }
    std::vector<Group> groups() const;
    std::vector<Line> lines(int width) const;
    static int heightOf(const Line& line);
    void place(const Line& line, const QRect& room) const;

    std::vector<Place> m_places;
};

} // namespace spacetow
