#pragma once
// Pictures of the drawing board without a window.

#include "editor/canvas/board.h"

namespace spacetow::test {

inline BoardRequest boardRequest(std::shared_ptr<const Level> level, const Viewport& view, double pixelRatio = 1) {
    BoardRequest request;
    request.frame = {view, pixelRatio};
    request.theme = &editingTheme();
    request.level = std::move(level);
    request.base = request.level;
    return request;
}

/// What the board shows at once, on the colour of the background.
inline QImage shownBy(Board& board, BoardRequest request) {
    request.frame.view = alignedToPixels(request.frame.view, request.frame.pixelRatio);
    QImage image(request.frame.deviceSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(request.frame.pixelRatio);
    image.fill(request.theme->background);
    QPainter painter(&image);
    board.prepare(request);
    board.drawStill(painter);
    board.drawRest(painter);
    return image;
}

/// What it shows in the end.
inline QImage finishedBy(Board& board, const BoardRequest& request) {
    shownBy(board, request);
    board.finish();
    return shownBy(board, request);
}

inline QImage fromScratch(const BoardRequest& request) {
    Board board([] {});
    return finishedBy(board, request);
}

} // namespace spacetow::test
