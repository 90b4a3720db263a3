#include "editor/window/card_grid.h"

#include <QKeyEvent>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int cardGap = 12; // pixels between cards

} // namespace

void CardGrid::setCards(std::vector<LevelCard*> cards) {
    for (LevelCard* card : m_cards) {
        delete card;
    }
    m_cards = std::move(cards);
    for (LevelCard* card : m_cards) {
        card->setParent(this);
        card->show();
    }
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    arrange();
    updateGeometry();
}

int CardGrid::columns(int width) const {
    return m_cards.empty() ? 1 : std::max(1, (width + cardGap) / (m_cards.front()->sizeHint().width() + cardGap));
}

int CardGrid::heightForWidth(int width) const {
    if (m_cards.empty()) {
        return 0;
    }
    const int inRow = columns(width);
    const int rows = (static_cast<int>(m_cards.size()) + inRow - 1) / inRow;
    return rows * (m_cards.front()->sizeHint().height() + cardGap) - cardGap;
}

QSize CardGrid::sizeHint() const {
    return {minimumSizeHint().width(), heightForWidth(width())};
}

QSize CardGrid::minimumSizeHint() const {
    return m_cards.empty() ? QSize() : m_cards.front()->sizeHint();
}

void CardGrid::arrange() {
    const int inRow = columns(width());
    int place = 0;
    for (LevelCard* card : m_cards) {
        const QSize size = card->sizeHint();
        card->setGeometry(
            QRect(QPoint(place % inRow * (size.width() + cardGap), place / inRow * (size.height() + cardGap)), size));
        ++place;
    }
}

void CardGrid::resizeEvent(QResizeEvent*) {
    arrange();
}

void CardGrid::keyPressEvent(QKeyEvent* event) {
    const auto focused = std::ranges::find_if(m_cards, [](const LevelCard* card) { return card->hasFocus(); });
    const int step = event->key() == Qt::Key_Left    ? -1
                     : event->key() == Qt::Key_Right ? 1
                     : event->key() == Qt::Key_Up    ? -columns(width())
                     : event->key() == Qt::Key_Down  ? columns(width())
                                                     : 0;
    const auto from = focused - m_cards.begin();
    if (step == 0 || focused == m_cards.end()) {
        event->ignore();
    } else if (from + step >= 0 && from + step < static_cast<std::ptrdiff_t>(m_cards.size())) {
        LevelCard* const next = m_cards[static_cast<std::size_t>(from + step)];
        next->setFocus(Qt::TabFocusReason);
        Q_EMIT cardReached(next);
    } else {
        focusNextPrevChild(step > 0); // on to what stands below or above
    }
}

} // namespace spacetow
