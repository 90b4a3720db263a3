#pragma once
// A triangle of cells, one for each pair of tags: who touches whom. A click or the space bar changes the cell, the
// arrow keys go from cell to cell; names at the sides open a menu.

#include "core/game/tag_touches.h"
#include "editor/editing/tag_matrix.h"

#include <QWidget>

#include <optional>

namespace spacetow {

class TagMatrixView : public QWidget {
    Q_OBJECT

  public:
    explicit TagMatrixView(QWidget* parent = nullptr);

    void setMatrix(const TagMatrix& matrix, const TagTable& tags);
    /// What really touched in the last run: a disc in the corner of the cell, or a ring where they met and passed.
    void setTouches(const TagTouches& touches);
    const TagTouches& touches() const { return m_touches; }
    QString textFor(int a, int b) const { return textFor(Pair{a, b}); }

    struct Pair {
        int a = 0;
        int b = 0;
    };
    /// The tags whose cell is there; nothing beside the triangle.
    std::optional<Pair> pairAt(const QPoint& at) const;
    QRect cellOf(int a, int b) const; // of two tags that are shown
    /// The tag whose name is there.
    std::optional<int> nameAt(const QPoint& at) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void meetingWanted(int a, int b, bool meet);
    void menuWanted(int tag, const QPoint& global);
    void selectionWanted(int tag);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    int count() const { return static_cast<int>(m_matrix.tags.size()); }
    int tag(int position) const { return m_matrix.tags[static_cast<std::size_t>(position)]; }
    int position(int tag) const;
    QRect cell(int row, int column) const;
    void measure();
    void toggle(const Pair& pair);
    QString textFor(const Pair& pair) const;
    void setCurrent(int row, int column);
    void paintNames(QPainter& painter) const;
    void paintCell(QPainter& painter, int row, int column) const;
    void paintTouches(QPainter& painter, const Pair& pair, const QRectF& box) const;

    TagMatrix m_matrix;
    TagTable m_tags;
    TagTouches m_touches;
    int m_cell = 0;  // px
    int m_names = 0; // px, the longest name with its colour
    std::optional<Pair> m_hovered;
    int m_row = 0; // of the cell that the keys are at
    int m_column = 0;
};

} // namespace spacetow
