#include "editor/panels/history_panel.h"

#include "editor/panels/list_keys.h"

namespace spacetow {

HistoryPanel::HistoryPanel(Document& document, Toolbox& toolbox, HistoryModel::Words words, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_model(document, std::move(words)), m_column(this) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.addWidget(&m_list);
    m_list.setModel(&m_model);
    m_list.setFrameShape(QFrame::NoFrame);
    m_list.setUniformItemSizes(true);
    m_list.setIconSize(QSize(16, 16));
    m_list.setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list.setAccessibleName(tr("History"));
    m_list.setToolTip(tr("Click to go back, or forward again, to the state after an edit"));
    m_list.installEventFilter(this);
    connect(&m_list, &QListView::clicked, this, &HistoryPanel::jump);
    m_listener = m_document.historyChanged.connect([this] { refresh(); });
}

HistoryPanel::~HistoryPanel() {
    m_document.historyChanged.disconnect(m_listener);
}

void HistoryPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

bool HistoryPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_list && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const bool isJump = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Space;
        if (keepsListKey(*event)) {
            return true;
        }
        if (event->type() == QEvent::KeyPress && isForLists(key) && isJump) {
            jump(m_list.currentIndex());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void HistoryPanel::refresh() {
    if (!isVisible()) {
        return;
    }
    m_model.refresh();
    const QModelIndex present = m_model.index(m_document.position());
    if (m_list.currentIndex() != present) {
        m_list.setCurrentIndex(present);
    }
}

void HistoryPanel::jump(const QModelIndex& index) {
    if (index.isValid() && index.row() != m_document.position()) {
        m_toolbox.cancel();
        m_document.goTo(index.row());
    }
}

} // namespace spacetow
