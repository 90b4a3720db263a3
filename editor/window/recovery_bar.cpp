#include "editor/window/recovery_bar.h"

#include "core/level/file.h"
#include "editor/canvas/icons.h"
#include "editor/canvas/level_picture.h"
#include "editor/canvas/palette.h"
#include "editor/window/compare_words.h"
#include "editor/window/message_bar.h"

#include <QEvent>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int highest = 270; // px, of the list: three rows

std::vector<FoundWork> foundIn(const std::filesystem::path& folder, const QSize& size, Shade shade) {
    std::vector<FoundWork> found;
    for (Orphan& orphan : orphans(folder)) {
        LevelFile file = parseLevel(orphan.entry.text, Checks::FileOnly);
        FoundWork work{std::move(orphan), nullptr, {}};
        if (file.level) {
            work.level = std::make_shared<const Level>(std::move(*file.level));
        }
        work.picture = levelPicture(work.level ? *work.level : Level(), {size}, shade);
        found.push_back(std::move(work));
    }
    return found;
}

} // namespace

RecoveryBar::RecoveryBar(std::filesystem::path folder, Restore restoreWork)
    : m_folder(std::move(folder)), m_restore(std::move(restoreWork)), m_column(this), m_list(new QWidget),
      m_rows(new QVBoxLayout(m_list)) {
    layOut();
    connect(&m_close, &QToolButton::clicked, this, [this] {
        hide();
        Q_EMIT closed();
    });
    hide();
}

void RecoveryBar::layOut() {
    m_title.setText(tr("The program ended with work that was not saved:"));
    m_title.setWordWrap(true);
    m_close.setAutoRaise(true);
    m_close.setToolTip(tr("Not now: it is kept, and offered again"));
    m_close.setAccessibleName(tr("Close"));
    m_header.setSpacing(8);
    m_header.addWidget(&m_icon, 0, Qt::AlignTop);
    m_header.addWidget(&m_title, 1);
    m_header.addWidget(&m_close, 0, Qt::AlignTop);
    m_column.setContentsMargins(10, 6, 6, 8);
    m_column.setSpacing(6);
    m_column.addLayout(&m_header);
    m_column.addWidget(&m_scroll);
    m_rows->setContentsMargins(26, 0, 4, 0);
    m_rows->setSpacing(10);
    m_scroll.setFrameShape(QFrame::NoFrame);
    m_scroll.setWidgetResizable(true);
    m_scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll.setWidget(m_list);
    m_list->setAutoFillBackground(false);
    m_scroll.viewport()->setAutoFillBackground(false);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void RecoveryBar::look(bool calledFor) {
    m_calledFor = calledFor;
    if (m_task.isRunning()) {
        return;
    }
    const QSize size = RecoveryRow::pictureSize(devicePixelRatioF());
    m_task.start(
        [this, size, folder = m_folder, shade = shadeOf(palette())](const std::stop_token&) -> BackgroundTask::Then {
            auto found = std::make_shared<std::vector<FoundWork>>(foundIn(folder, size, shade));
            return [this, found] { fill(std::move(*found)); };
        });
}

void RecoveryBar::fill(std::vector<FoundWork> found) {
    for (RecoveryRow* row : rows()) {
        delete row;
    }
    for (FoundWork& work : found) {
        auto* const row = new RecoveryRow(std::move(work));
        connect(&row->restore, &QToolButton::clicked, this, [this, row] { restore(*row); });
        connect(&row->compare, &QToolButton::clicked, this, [this, row] { compare(*row); });
        connect(&row->discard, &QToolButton::clicked, this, [this, row] { discard(*row); });
        connect(&row->undo, &QToolButton::clicked, this, [this, row] { bringBack(*row); });
        m_rows->addWidget(row);
    }
    dress();
    setVisible(!found.empty());
    fitHeight();
    if (found.empty()) {
        Q_EMIT nothingFound();
    } else if (m_calledFor) {
        rows().front()->restore.setFocus(Qt::ShortcutFocusReason);
    }
}

std::vector<RecoveryRow*> RecoveryBar::rows() const {
    std::vector<RecoveryRow*> rows;
    for (int i = 0; i < m_rows->count(); ++i) {
        rows.push_back(qobject_cast<RecoveryRow*>(m_rows->itemAt(i)->widget()));
    }
    return rows;
}

void RecoveryBar::remove(RecoveryRow& row) {
    m_rows->removeWidget(&row);
    row.hide();
    row.deleteLater(); // its own button was clicked
    if (m_rows->isEmpty()) {
        hide();
        Q_EMIT closed();
    }
    fitHeight();
}

void RecoveryBar::restore(RecoveryRow& row) {
    const auto slot = JournalSlot::takenOver(m_folder, row.found().orphan.id);
    if (!slot) {
        look(m_calledFor); // another window was quicker, or was only looking at that moment
        return;
    }
    const std::optional<JournalEntry> entry = slot->read();
    if (!entry) {
        remove(row); // another window has discarded it
        return;
    }
    if (m_restore(*entry)) {
        slot->erase();
        remove(row);
    }
}

void RecoveryBar::compare(RecoveryRow& row) {
    const JournalEntry& entry = row.found().orphan.entry;
    const Result<LevelFile> file = readLevel(entry.path, Checks::FileOnly);
    const bool readable = file && file.value().level;
    const QString words = differencesInWords(readable ? *file.value().level : Level(), *row.found().level);
    const QString beside = readable ? tr("Beside the file as it is now:") : tr("There is no file to compare it with:");
    row.explain(readable && words.isEmpty() ? tr("It is the same as the file.") : beside + QLatin1Char('\n') + words);
    fitHeight();
    if (m_show && !words.isEmpty()) {
        m_show(entry, row.found().level);
    }
}

void RecoveryBar::discard(RecoveryRow& row) {
    if (const auto slot = JournalSlot::takenOver(m_folder, row.found().orphan.id)) {
        slot->discard();
        row.setDiscarded(true);
        fitHeight();
    } else {
        look(m_calledFor);
    }
}

void RecoveryBar::bringBack(RecoveryRow& row) {
    if (const auto slot = JournalSlot::takenOver(m_folder, row.found().orphan.id)) {
        slot->bringBack();
        row.setDiscarded(false);
        fitHeight();
    } else {
        remove(row);
    }
}

void RecoveryBar::fitHeight() {
    m_list->layout()->activate();
    const int width = m_scroll.viewport()->width();
    const int wanted = m_rows->hasHeightForWidth() ? m_rows->heightForWidth(width) : m_rows->sizeHint().height();
    m_scroll.setFixedHeight(std::min(wanted, highest));
}

void RecoveryBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitHeight();
}

void RecoveryBar::dress() {
    const BarDress dress = barDress(MessageBar::Tone::Info, shadeOf(palette()));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, dress.ink);
    for (QLabel* label : findChildren<QLabel*>()) {
        label->setPalette(colors);
    }
    m_icon.setPixmap(icon(QStringLiteral("info"), dress.ink).pixmap(18, 18));
    m_close.setIcon(icon(QStringLiteral("close"), dress.ink));
    update();
}

void RecoveryBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), barDress(MessageBar::Tone::Info, shadeOf(palette())).plate);
}

void RecoveryBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        dress();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
