#include "editor/panels/tag_matrix_view.h"

#include "editor/canvas/palette.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"
#include "editor/panels/tag_names.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int matrixMargin = 8;  // px
constexpr int tagDot = 10;       // px
constexpr int nameGap = 6;       // px between tagDot and name
constexpr int widestName = 150;  // px, of a name
constexpr int smallestCell = 22; // px, of a cell
constexpr double touchDot = 3.5; // px, its radius

} // namespace

TagMatrixView::TagMatrixView(QWidget* parent) : QWidget(parent), m_tags(TagTable::empty()) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Tag matrix"));
    measure();
}

void TagMatrixView::setMatrix(const TagMatrix& matrix, const TagTable& tags) {
    if (matrix == m_matrix && tags == m_tags) {
        return;
    }
    m_matrix = matrix;
    m_tags = tags;
    m_hovered.reset();
    measure();
    setCurrent(std::min(m_row, std::max(0, count() - 1)), m_column);
    updateGeometry();
    update();
}

void TagMatrixView::setTouches(const TagTouches& touches) {
    if (!(touches == m_touches)) {
        m_touches = touches;
        update();
    }
}

void TagMatrixView::measure() {
    m_cell = std::max(smallestCell, fontMetrics().height() + 6);
    int names = 0;
    for (const int tag : m_matrix.tags) {
        names = std::max(names, fontMetrics().horizontalAdvance(tagText(m_tags, tag)));
    }
    m_names = std::min(widestName, names) + tagDot + 2 * nameGap;
    resize(sizeHint());
}

QSize TagMatrixView::sizeHint() const {
    const int side = m_names + count() * m_cell + 2 * matrixMargin;
    return {side, side};
}

/// Columns run backwards, so that every row begins at its name and no cell stands for a pair twice.
QRect TagMatrixView::cell(int row, int column) const {
    return {matrixMargin + m_names + column * m_cell, matrixMargin + m_names + row * m_cell, m_cell, m_cell};
}

int TagMatrixView::position(int tag) const {
    return static_cast<int>(std::ranges::find(m_matrix.tags, tag) - m_matrix.tags.begin());
}

QRect TagMatrixView::cellOf(int a, int b) const {
    const auto [row, other] = std::minmax({position(a), position(b)});
    return cell(row, count() - 1 - other);
}

std::optional<TagMatrixView::Pair> TagMatrixView::pairAt(const QPoint& at) const {
    const QPoint inside = at - QPoint(matrixMargin + m_names, matrixMargin + m_names);
    if (inside.x() < 0 || inside.y() < 0) {
        return {};
    }
    const int row = inside.y() / m_cell;
    const int column = inside.x() / m_cell;
    if (row + column >= count()) {
        return {};
    }
    return Pair{tag(row), tag(count() - 1 - column)};
}

std::optional<int> TagMatrixView::nameAt(const QPoint& at) const {
    const int row = (at.y() - matrixMargin - m_names) / m_cell;
    const int column = (at.x() - matrixMargin - m_names) / m_cell;
    if (at.x() < matrixMargin + m_names && at.y() >= matrixMargin + m_names && row < count()) {
        return tag(row);
    }
    if (at.y() < matrixMargin + m_names && at.x() >= matrixMargin + m_names && column < count()) {
        return tag(count() - 1 - column);
    }
    return {};
}

QString TagMatrixView::textFor(const Pair& pair) const {
    const TagMatrix::Cell& cell = m_matrix.cell(pair.a, pair.b);
    const QString what = cell.meeting == TagMeeting::Nobody ? tr("No object is “%1” or “%2”.")
                         : cell.meeting == TagMeeting::None ? tr("“%1” and “%2” pass through each other.")
                         : cell.meeting == TagMeeting::All  ? tr("“%1” and “%2” touch each other.")
                                                           : tr("Some that are “%1” and “%2” touch each other.");
    QString text = what.arg(tagText(m_tags, pair.a), tagText(m_tags, pair.b));
    if (cell.isFixed) {
        text += QLatin1Char(' ') + tr("The rules of the game say so.");
    }
    if (m_touches.haveTouched(pair.a, pair.b)) {
        text += QLatin1Char(' ') + tr("They did touch in the last run.");
    }
    if (m_touches.havePassed(pair.a, pair.b)) {
        text += QLatin1Char(' ') + tr("They met in the last run, and passed through each other.");
    }
    return text;
}

void TagMatrixView::toggle(const Pair& pair) {
    const TagMatrix::Cell& cell = m_matrix.cell(pair.a, pair.b);
    if (cell.meeting != TagMeeting::Nobody && !cell.isFixed) {
        Q_EMIT meetingWanted(pair.a, pair.b, cell.meeting != TagMeeting::All);
    }
}

void TagMatrixView::setCurrent(int row, int column) {
    m_row = std::clamp(row, 0, std::max(0, count() - 1));
    m_column = std::clamp(column, 0, std::max(0, count() - 1 - m_row));
    if (count() > 0) {
        setAccessibleDescription(textFor({tag(m_row), tag(count() - 1 - m_column)}));
    }
    update();
}

bool TagMatrixView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const std::optional<Pair> pair = pairAt(help->pos())) {
            QToolTip::showText(help->globalPos(), plainToolTip(textFor(*pair)), this, cellOf(pair->a, pair->b));
        } else if (const std::optional<int> name = nameAt(help->pos())) {
            const int objects = m_matrix.objects[static_cast<std::size_t>(*name)];
            const QString words =
                tr("%n objects are “%1”; double-click to select them, right-click for more", nullptr, objects);
            QToolTip::showText(help->globalPos(), plainToolTip(counted(words, objects).arg(tagText(m_tags, *name))),
                               this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void TagMatrixView::paintNames(QPainter& painter) const {
    for (int i = 0; i < count(); ++i) {
        const int tag = this->tag(i);
        const bool isHovered = m_hovered && (m_hovered->a == tag || m_hovered->b == tag);
        QFont font = this->font();
        font.setBold(isHovered);
        painter.setFont(font);
        const QString name =
            painter.fontMetrics().elidedText(tagText(m_tags, tag), Qt::ElideRight, m_names - tagDot - 2 * nameGap);
        const auto paint = [&](const QRect& box) {
            painter.setPen(palette().color(QPalette::Mid));
            painter.setBrush(QColor::fromRgb(m_tags[tag].color));
            const QRectF mark(box.right() - tagDot - nameGap / 2.0, box.center().y() - tagDot / 2.0, tagDot, tagDot);
            painter.drawEllipse(mark);
            painter.setPen(palette().color(QPalette::WindowText));
            painter.drawText(box.adjusted(0, 0, -tagDot - 2 * nameGap, 0), Qt::AlignRight | Qt::AlignVCenter, name);
        };
        paint({matrixMargin, matrixMargin + m_names + i * m_cell, m_names, m_cell});
        painter.save();
        painter.translate(matrixMargin + m_names + (count() - 1 - i) * m_cell, matrixMargin);
        painter.rotate(90);
        paint({0, -m_cell, m_names, m_cell});
        painter.restore();
    }
}

void TagMatrixView::paintCell(QPainter& painter, int row, int column) const {
    const Pair pair{tag(row), tag(count() - 1 - column)};
    const TagMatrix::Cell& state = m_matrix.cell(pair.a, pair.b);
    const QRectF box = QRectF(cell(row, column)).adjusted(3.5, 3.5, -3.5, -3.5);
    const bool isQuiet = state.meeting == TagMeeting::Nobody || state.isFixed;
    const QColor ink = palette().color(isQuiet ? QPalette::Disabled : QPalette::Active, QPalette::Text);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(isQuiet ? Qt::NoBrush : QBrush(palette().color(QPalette::Base)));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (state.meeting == TagMeeting::All) {
        const QPointF tick[] = {{box.left() + 0.22 * box.width(), box.center().y()},
                                {box.left() + 0.42 * box.width(), box.top() + 0.72 * box.height()},
                                {box.left() + 0.78 * box.width(), box.top() + 0.28 * box.height()}};
        painter.drawPolyline(tick, 3);
    } else if (state.meeting == TagMeeting::Some) {
        painter.drawLine(QPointF(box.left() + 0.25 * box.width(), box.center().y()),
                         QPointF(box.right() - 0.25 * box.width(), box.center().y()));
    }
    paintTouches(painter, pair, box);
    if (hasFocus() && row == m_row && column == m_column) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(-1.5, -1.5, 1.5, 1.5), 4, 4);
    }
}

void TagMatrixView::paintTouches(QPainter& painter, const Pair& pair, const QRectF& box) const {
    const MarkColors colors = markColors(shadeOf(palette()));
    if (m_touches.haveTouched(pair.a, pair.b)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.good);
        painter.drawEllipse(box.topRight() + QPointF(-touchDot, touchDot), touchDot, touchDot);
    }
    if (m_touches.havePassed(pair.a, pair.b)) {
        painter.setPen(QPen(colors.warning, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(box.bottomRight() + QPointF(-touchDot, -touchDot), touchDot - 0.5, touchDot - 0.5);
    }
}

void TagMatrixView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_hovered) {
        const QRect at = cellOf(m_hovered->a, m_hovered->b);
        painter.fillRect(QRect(matrixMargin, at.top(), at.right() - matrixMargin, m_cell),
                         palette().color(QPalette::Midlight));
        painter.fillRect(QRect(at.left(), matrixMargin, m_cell, at.bottom() - matrixMargin),
                         palette().color(QPalette::Midlight));
    }
    paintNames(painter);
    for (int row = 0; row < count(); ++row) {
        for (int column = 0; row + column < count(); ++column) {
            paintCell(painter, row, column);
        }
    }
}

void TagMatrixView::mousePressEvent(QMouseEvent* event) {
    const std::optional<Pair> pair = event->button() == Qt::LeftButton ? pairAt(event->pos()) : std::nullopt;
    if (pair) {
        const auto [row, other] = std::minmax({position(pair->a), position(pair->b)});
        setCurrent(row, count() - 1 - other);
        toggle(*pair);
    }
}

void TagMatrixView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const std::optional<int> name = nameAt(event->pos())) {
        Q_EMIT selectionWanted(*name);
    } else {
        mousePressEvent(event); // a quick click is a click
    }
}

void TagMatrixView::mouseMoveEvent(QMouseEvent* event) {
    m_hovered = pairAt(event->pos());
    update();
}

void TagMatrixView::leaveEvent(QEvent*) {
    m_hovered.reset();
    update();
}

void TagMatrixView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        setCurrent(m_row, m_column - 1);
        break;
    case Qt::Key_Right:
        setCurrent(m_row, m_column + 1);
        break;
    case Qt::Key_Up:
        setCurrent(m_row - 1, m_column);
        break;
    case Qt::Key_Down:
        setCurrent(m_row + 1, m_column);
        break;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (count() > 0) {
            toggle({tag(m_row), tag(count() - 1 - m_column)});
        }
        break;
    case Qt::Key_F2:
    case Qt::Key_Menu:
        if (count() > 0) {
            Q_EMIT menuWanted(tag(m_row), mapToGlobal(cell(m_row, m_column).bottomLeft()));
        }
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void TagMatrixView::contextMenuEvent(QContextMenuEvent* event) {
    const std::optional<int> name = nameAt(event->pos());
    const std::optional<Pair> pair = pairAt(event->pos());
    if (name || pair) {
        Q_EMIT menuWanted(name ? *name : pair->a, event->globalPos());
    }
}

void TagMatrixView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    setCurrent(m_row, m_column);
}

void TagMatrixView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        measure();
        updateGeometry();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
