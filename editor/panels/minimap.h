#pragma once
// The minimap: all of the level, and in it the part that the canvas shows. A click or a drag goes there. The picture is
// painted by a thread beside, anew whenever the level has changed.

#include "editor/canvas/background_task.h"
#include "editor/canvas/canvas.h"
#include "editor/canvas/level_picture.h"

#include <QPixmap>
#include <QWidget>

#include <memory>

namespace spacetow {

class Minimap : public QWidget {
    Q_OBJECT

  public:
    /// Both must outlive the minimap.
    Minimap(Document& document, Canvas& canvas, QWidget* parent = nullptr);
    ~Minimap() override;

    /// What the canvas shows, in pixels of the minimap.
    QRectF shownPart() const;
    /// In pixels of the minimap; the middle before the first picture.
    QPointF at(const Vec2& world) const;
    const QPixmap& picture() const { return m_picture; }
    /// Waits until the picture is that of the level.
    void finish();

    QSize sizeHint() const override { return {240, 160}; }
    QSize minimumSizeHint() const override { return {80, 60}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    struct Painted {
        std::shared_ptr<const Level> level;
        PictureSize size;
        Shade shade = Shade::Dark;

        bool operator==(const Painted&) const = default;
    };

    Painted wanted() const;
    void paintBeside();
    void goTo(const QPointF& position);

    Document& m_document;
    Canvas& m_canvas;
    QPixmap m_picture;
    Painted m_painted;
    Viewport m_view; // of the picture
    int m_listener = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
