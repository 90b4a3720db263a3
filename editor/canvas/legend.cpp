#include "editor/canvas/legend.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "editor/canvas/swatch.h"
#include "editor/canvas/tag_text.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr int margin = 8;   // px, to the borders of the canvas
constexpr int columns = 27; // characters; longer explanations are wrapped

QString words(const char* text) {
    return QCoreApplication::translate("Legend", text);
}

QString titleOf(const OverlayRow& row) {
    QString title = QCoreApplication::translate("Actions", row.text);
    return title.remove(QLatin1Char('&'));
}

bool isAnyOn(const OverlayFlags& overlays) {
    return std::ranges::any_of(overlayRows(), [&](const OverlayRow& row) { return overlays.*row.flag; });
}

/// A button beside what it means; the words take as many lines as there is room for.
struct LegendLine {
    QWidget* all;
    QLabel* label;
};

LegendLine lineOf(QToolButton* button, const QString& words, int indent) {
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(indent, 0, 0, 0);
    layout->setSpacing(margin / 2);
    auto* label = new QLabel(words);
    label->setWordWrap(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(button, 0, Qt::AlignTop);
    layout->addWidget(label, 1);
    return {line, label};
}

} // namespace

Legend::Legend(QWidget& canvas) : QFrame(&canvas), m_canvas(canvas) {
    setObjectName(QStringLiteral("legend"));
    setAccessibleName(tr("Legend of the overlays"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAttribute(Qt::WA_NoMousePropagation);
    setCursor(Qt::ArrowCursor);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&m_scroll);
    m_scroll.setWidgetResizable(true);
    m_scroll.setFrameShape(QFrame::NoFrame);
    m_scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll.setFocusPolicy(Qt::NoFocus);
    canvas.installEventFilter(this);
    hide();
}

void Legend::showOverlays(const Explained& explained) {
    if (m_shown != explained) {
        m_shown = explained;
        fill();
    }
}

void Legend::fill() {
    m_filling = true;
    setVisible(isAnyOn(m_shown->overlays));
    auto* content = new QWidget;
    auto* list = new QVBoxLayout(content);
    list->setContentsMargins(margin, margin, margin, margin);
    list->setSpacing(2);
    auto* close = new QToolButton;
    close->setAutoRaise(true);
    close->setIcon(livingIcon(QStringLiteral("close")));
    close->setToolTip(tr("Hide the legend"));
    close->setAccessibleName(close->toolTip());
    close->setFocusPolicy(Qt::NoFocus);
    connect(close, &QToolButton::clicked, this, &Legend::closed);
    auto* head = new QHBoxLayout;
    auto* title = new QLabel(tr("Legend"));
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    head->addWidget(title, 1);
    head->addWidget(close);
    list->addLayout(head);
    for (std::size_t row = 0; row < overlayRows().size(); ++row) {
        if (m_shown->overlays.*overlayRows()[row].flag) {
            addOverlay(*list, static_cast<int>(row));
        }
    }
    if (m_shown->leftOut.dots) {
        addRemark(*list, tr("What is too small at this zoom is not drawn"));
    }
    if (m_shown->leftOut.names) {
        addRemark(*list, tr("Names that would lie on others are left out"));
    }
    list->addStretch(1);
    if (QWidget* old = m_scroll.takeWidget()) {
        old->deleteLater(); // a click on one of its buttons may have led here
    }
    m_scroll.setWidget(content);
    content->installEventFilter(this);
    m_filling = false;
    place();
}

void Legend::addRemark(QVBoxLayout& list, const QString& words) {
    auto* remark = new QLabel(words);
    remark->setWordWrap(true);
    remark->setForegroundRole(QPalette::PlaceholderText);
    remark->setContentsMargins(margin, margin / 2, 0, 0);
    list.addWidget(remark);
}

void Legend::addOverlay(QVBoxLayout& list, int index) {
    const OverlayRow& row = overlayRows()[static_cast<std::size_t>(index)];
    auto* button = new QToolButton;
    button->setIcon(livingIcon(QLatin1String(row.icon)));
    button->setToolTip(tr("Switch off"));
    button->setAccessibleName(titleOf(row));
    button->setProperty("overlay", QLatin1String(row.name));
    connect(button, &QToolButton::clicked, this, [this, index] { Q_EMIT switchedOff(index); });
    const LegendLine line = lineOf(button, titleOf(row), 0);
    line.label->setProperty("row", index);
    line.label->setCursor(Qt::PointingHandCursor);
    line.label->installEventFilter(this);
    list.addWidget(line.all);
    for (const OverlayInk& ink : row.inks) {
        addInk(list, ink);
    }
    if (row.flag == &OverlayFlags::islands) {
        auto* colors = new QToolButton;
        colors->setIcon(swatch(overlayColors(m_shown->palette, m_shown->ground).islands, 18));
        list.addWidget(lineOf(colors, words(row.remark), margin).all);
    } else if (row.flag == &OverlayFlags::tags) {
        addTags(list);
    }
}

void Legend::addInk(QVBoxLayout& list, const OverlayInk& ink) {
    auto* color = new QToolButton;
    color->setIcon(swatch(std::array{overlayColors(m_shown->palette, m_shown->ground).*ink.color}, 14));
    color->setToolTip(tr("Choose another color"));
    color->setAccessibleName(words(ink.meaning));
    color->setProperty("ink", QLatin1String(ink.name));
    const auto index = static_cast<int>(&ink - overlayInks().data());
    connect(color, &QToolButton::clicked, this, [this, index] { Q_EMIT colorWanted(index); });
    list.addWidget(lineOf(color, words(ink.meaning), margin).all);
}

/// The tags have their colours in the level, where the inspector changes them.
void Legend::addTags(QVBoxLayout& list) {
    for (int tag = 0; tag < TagTable::size; ++tag) {
        if (!m_shown->tags[tag].name.empty()) {
            auto* color = new QToolButton;
            color->setIcon(swatch(std::array{toColor(QColor::fromRgb(m_shown->tags[tag].color))}, 14));
            list.addWidget(lineOf(color, tagText(m_shown->tags, tag), margin).all);
        }
    }
}

void Legend::place() {
    if (!m_shown || !isAnyOn(m_shown->overlays) || m_scroll.widget() == nullptr) {
        return;
    }
    QWidget& content = *m_scroll.widget();
    const int told = columns * fontMetrics().averageCharWidth() + 4 * margin;
    int wide = std::max(told, content.minimumSizeHint().width());
    const int bar = m_scroll.verticalScrollBar()->sizeHint().width();
    const int edge = margin + m_shown->spare;
    const QSize room = m_canvas.size() - QSize(2 * margin, 2 * edge);
    wide = std::min(wide + 2 * (frameWidth() + 1) + bar, room.width());
    const int tall =
        std::max(content.layout()->heightForWidth(wide - 2 * (frameWidth() + 1) - bar), 1) + 2 * frameWidth();
    const QSize size(wide, std::min(tall, room.height()));
    setGeometry(margin, m_canvas.height() - edge - size.height(), size.width(), size.height());
    raise();
}

bool Legend::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease && watched->property("row").isValid()) {
        Q_EMIT switchedOff(watched->property("row").toInt());
        return true;
    }
    // Only what has been shown knows how large its texts are.
    const bool isContent = watched == m_scroll.widget() && event->type() == QEvent::LayoutRequest;
    if (isContent || (watched == &m_canvas && event->type() == QEvent::Resize)) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void Legend::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    const bool looksOther = event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
                            event->type() == QEvent::LanguageChange;
    if (looksOther && m_shown && !m_filling) {
        fill();
    }
}

} // namespace spacetow
