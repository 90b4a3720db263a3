#include "editor/panels/tag_grid.h"

#include "editor/panels/names.h"
#include "editor/panels/tag_names.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QToolTip>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int gap = 5; // px
TagChip::State stateOf(bool all, bool some) {
    return all ? TagChip::State::On : some ? TagChip::State::Mixed : TagChip::State::Off;
}

} // namespace

TagGrid::TagGrid(bool everything, QWidget* parent) : QWidget(parent), m_add(this), m_name(this) {
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    if (everything) {
        m_everything = std::make_unique<TagChip>(this);
        m_everything->setTag(tr("everything"), QColor(0xd2, 0xd6, 0xe0));
        connect(m_everything.get(), &TagChip::clicked, this,
                [this] { Q_EMIT everythingSwitched(m_shown.count == 0 || !(m_shown.every == TagMask::all())); });
    }
    m_add.setTag(tr("New tag"), palette().color(QPalette::PlaceholderText));
    m_add.setToolTip(tr("Name another of the 32 tags"));
    connect(&m_add, &TagChip::clicked, this, [this] {
        if (const std::optional<int> index = freeIndex()) {
            edit(*index);
        }
    });
    m_name.hide();
    m_name.setMaxLength(40);
    m_name.installEventFilter(this);
    connect(&m_name, &QLineEdit::returnPressed, this, [this] { endEdit(true); });
}

TagGrid::~TagGrid() {
    m_name.removeEventFilter(this);
}

std::optional<int> TagGrid::freeIndex() const {
    for (int i = 0; i < TagTable::size; ++i) {
        if (m_table[i].name.empty()) {
            return i;
        }
    }
    return {};
}

TagChip* TagGrid::chip(int index) const {
    const auto found = std::ranges::find(m_entries, index, &Entry::index);
    return found == m_entries.end() ? nullptr : found->chip.get();
}

void TagGrid::setTags(const TagTable& table, const TagsShown& shown) {
    m_table = table;
    m_shown = shown;
    const bool isException = m_everything != nullptr && shown.count > 0 && shown.exceptions == shown.count;
    // Tags without a name are shown by number, but only where somebody has written them down.
    const std::uint32_t written = isException ? ~shown.every.bits : shown.exceptions == 0 ? shown.any.bits : 0U;
    const TagMask chips = table.named() | TagMask{written};
    TagMask present;
    for (const Entry& entry : m_entries) {
        present = present | TagMask::bit(entry.index);
    }
    if (!(chips == present)) {
        rebuild(chips);
    }
    for (const Entry& entry : m_entries) {
        const TagInfo& info = table[entry.index];
        const QString name = tagText(table, entry.index);
        entry.chip->setTag(name, QColor::fromRgb(info.color));
        entry.chip->setToolTip(plainToolTip(tr("%1 – double-click or F2 to rename, right-click for more").arg(name)));
        entry.chip->setState(
            stateOf(shown.count > 0 && shown.every.contains(entry.index), shown.any.contains(entry.index)));
        entry.chip->setExcepting(isException);
    }
    if (m_everything) {
        showEverything(isException);
    }
    m_add.setVisible(freeIndex().has_value());
    arrange(width(), true);
    updateGeometry();
}

void TagGrid::showEverything(bool isException) {
    const bool isAll = m_shown.every == TagMask::all();
    m_everything->setTag(isException && !isAll ? tr("everything except") : tr("everything"), m_everything->color());
    m_everything->setState(stateOf(isException, m_shown.exceptions > 0));
    m_everything->setToolTip(
        isException && !isAll ? tr("Touches whatever has a tag, also tags that are made later, but for those crossed "
                                   "out; click for everything")
        : isException         ? tr("Touches whatever has a tag, also tags that are made later; click for "
                                           "nothing, click a tag to leave it out")
                              : tr("Touches the marked tags only; click for everything"));
}

void TagGrid::rebuild(TagMask shown) {
    for (Entry& entry : m_entries) {
        // It may be its own click that makes it go.
        entry.chip->hide();
        entry.chip.release()->deleteLater();
    }
    m_entries.clear();
    for (int i = 0; i < TagTable::size; ++i) {
        if (!shown.contains(i)) {
            continue;
        }
        auto chip = std::make_unique<TagChip>(this);
        TagChip* const button = chip.get();
        connect(button, &TagChip::clicked, this,
                [this, i, button] { Q_EMIT tagSwitched(i, button->state() != TagChip::State::On); });
        connect(button, &TagChip::editWanted, this, [this, i] { edit(i); });
        button->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(button, &QWidget::customContextMenuRequested, this,
                [this, i, button](const QPoint& at) { openMenu(i, button->mapToGlobal(at)); });
        button->show();
        m_entries.push_back({i, std::move(chip)});
    }
    // New buttons come last of all in the window, far from the others.
    QWidget* before = &m_add;
    const auto follow = [&before](QWidget* next) {
        setTabOrder(before, next);
        before = next;
    };
    if (m_everything) {
        follow(m_everything.get());
    }
    for (const Entry& entry : m_entries) {
        follow(entry.chip.get());
    }
    if (before != &m_add) {
        follow(&m_add);
    }
}

int TagGrid::arrange(int width, bool move) const {
    int x = 0;
    int y = 0;
    int lineHeight = 0;
    const auto place = [&](TagChip* chip) {
        const QSize size = chip->sizeHint().boundedTo(QSize(std::max(width, 40), 1000));
        if (x > 0 && x + size.width() > width) {
            x = 0;
            y += lineHeight + gap;
        }
        if (move) {
            chip->setGeometry(x, y, size.width(), size.height());
        }
        x += size.width() + gap;
        lineHeight = size.height();
    };
    if (m_everything) {
        place(m_everything.get());
    }
    for (const Entry& entry : m_entries) {
        place(entry.chip.get());
    }
    if (freeIndex()) {
        place(const_cast<TagChip*>(&m_add));
    }
    return y + lineHeight;
}

QSize TagGrid::sizeHint() const {
    constexpr int usual = 260;
    return {usual, arrange(usual, false)};
}

QSize TagGrid::minimumSizeHint() const {
    return {80, m_add.sizeHint().height()};
}

void TagGrid::resizeEvent(QResizeEvent*) {
    arrange(width(), true);
}

void TagGrid::openMenu(int index, const QPoint& global) {
    QMenu menu(this);
    connect(menu.addAction(tr("&Rename")), &QAction::triggered, this, [this, index] { edit(index); });
    connect(menu.addAction(tr("&Color…")), &QAction::triggered, this, [this, index] { recolour(index); });
    menu.addSeparator();
    connect(menu.addAction(tr("&Select All with This Tag")), &QAction::triggered, this,
            [this, index] { Q_EMIT selectionWanted(index); });
    menu.exec(global);
}

void TagGrid::recolour(int index) {
    const QColor color = QColorDialog::getColor(QColor::fromRgb(m_table[index].color), this,
                                                tr("Color of “%1”").arg(QString::fromStdString(m_table[index].name)));
    if (color.isValid()) {
        Q_EMIT tagDefined(index, QString::fromStdString(m_table[index].name), color);
    }
}

void TagGrid::edit(int index) {
    const TagChip* at = chip(index) != nullptr ? chip(index) : &m_add;
    m_edited = index;
    m_name.setText(QString::fromStdString(m_table[index].name));
    m_name.setPlaceholderText(tr("Name"));
    const int wide = std::max(at->width() + 20, 110);
    m_name.setGeometry(std::clamp(at->x(), 0, std::max(0, width() - wide)), at->y(), wide, at->height());
    m_name.show();
    m_name.raise();
    m_name.setFocus();
    m_name.selectAll();
}

void TagGrid::endEdit(bool keep) {
    if (!m_edited) {
        return;
    }
    const int index = *m_edited;
    const QString name = m_name.text().trimmed();
    if (const QString objection = keep ? objectionToTagName(m_table, name, index) : QString(); !objection.isEmpty()) {
        QToolTip::showText(m_name.mapToGlobal(QPoint(0, m_name.height())), objection);
        return;
    }
    m_edited.reset();
    m_name.hide();
    const bool fresh = m_table[index].name.empty();
    if (keep && !name.isEmpty() && name.toStdString() != m_table[index].name) {
        if (fresh) {
            Q_EMIT tagMade(index, name, freshTagColor(m_table));
        } else {
            Q_EMIT tagDefined(index, name, QColor::fromRgb(m_table[index].color));
        }
    }
    if (TagChip* const named = keep ? chip(index) : nullptr) {
        named->setFocus(); // which went on with the field that is hidden now
    }
}

bool TagGrid::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_name && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        endEdit(false);
        return true;
    }
    if (watched == &m_name && event->type() == QEvent::FocusOut) {
        endEdit(false);
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace spacetow
