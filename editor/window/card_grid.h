#pragma once
// Cards side by side, as many in a row as there is room for. The arrow keys go from card to card.

#include "editor/window/level_card.h"

#include <QWidget>

#include <vector>

namespace spacetow {

class CardGrid : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

    /// The grid owns the cards.
    void setCards(std::vector<LevelCard*> cards);
    const std::vector<LevelCard*>& cards() const { return m_cards; }

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    /// By an arrow key.
    void cardReached(QWidget* card);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    int columns(int width) const;
    void arrange();

    std::vector<LevelCard*> m_cards;
};

} // namespace spacetow
