#include "editor/panels/tag_matrix_panel.h"

#include "core/level/edits.h"
#include "core/level/tag_edits.h"
#include "editor/editing/collisions.h"
#include "editor/panels/form_colors.h"
#include "editor/panels/tag_names.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QMenu>

namespace spacetow {

TagMatrixPanel::TagMatrixPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_column(this), m_page(this), m_view(nullptr) {
    m_column.setContentsMargins(6, 6, 6, 6);
    m_highlight.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_column.addWidget(&m_highlight);
    m_page.setWidget(&m_view);
    m_page.setFrameShape(QFrame::NoFrame);
    m_column.addWidget(&m_page, 1);
    m_note.setWordWrap(true);
    m_note.setTextFormat(Qt::PlainText);
    m_note.hide();
    m_column.addWidget(&m_note);
    m_name.setMaxLength(40);
    m_name.setPlaceholderText(tr("Name of the tag"));
    m_name.setAccessibleName(m_name.placeholderText());
    m_name.hide();
    m_name.installEventFilter(this);
    m_column.addWidget(&m_name);
    connect(&m_name, &QLineEdit::returnPressed, this, [this] { endRename(true); });
    connect(&m_view, &TagMatrixView::meetingWanted, this, [this](int a, int b, bool meet) {
        commit({"change-tags", 1}, withTagsMeeting(*m_document.current().level, a, b, meet));
    });
    connect(&m_view, &TagMatrixView::menuWanted, this, &TagMatrixPanel::openMenu);
    connect(&m_view, &TagMatrixView::selectionWanted, this, &TagMatrixPanel::selectTagged);
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
    refresh();
}

TagMatrixPanel::~TagMatrixPanel() {
    m_document.changed.disconnect(m_listener);
    m_name.removeEventFilter(this);
    m_page.takeWidget(); // a member of this
}

void TagMatrixPanel::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void TagMatrixPanel::refresh() {
    // No gesture changes tags, so a drag costs nothing here.
    const std::shared_ptr<const Level>& level = m_document.current().level;
    if (level == m_shown || (m_shown && !isVisible())) {
        return;
    }
    m_shown = level;
    m_view.setMatrix(tagMatrix(*level), level->tags);
}

void TagMatrixPanel::commit(const Label& label, Level level) {
    m_document.commit(label, {std::make_shared<const Level>(std::move(level)), m_document.current().selection});
}

void TagMatrixPanel::selectTagged(int tag) {
    m_document.select(Selection(keysTagged(*m_document.current().level, tag)));
}

void TagMatrixPanel::openMenu(int tag, const QPoint& global) {
    QMenu menu(this);
    connect(menu.addAction(tr("&Select All with This Tag")), &QAction::triggered, this,
            [this, tag] { selectTagged(tag); });
    menu.addSeparator();
    connect(menu.addAction(tr("&Rename")), &QAction::triggered, this, [this, tag] { rename(tag); });
    connect(menu.addAction(tr("&Color…")), &QAction::triggered, this, [this, tag] {
        TagInfo info = m_document.current().level->tags[tag];
        const QColor color = QColorDialog::getColor(
            QColor::fromRgb(info.color), this, tr("Color of “%1”").arg(tagText(m_document.current().level->tags, tag)));
        if (color.isValid()) {
            info.color = color.rgb() & 0xffffffU;
            commit({"change-tag", 1}, withTag(*m_document.current().level, tag, info));
        }
    });
    menu.exec(global);
}

void TagMatrixPanel::rename(int tag) {
    m_renamed = tag;
    m_name.setText(QString::fromStdString(m_document.current().level->tags[tag].name));
    m_name.show();
    m_name.setFocus();
    m_name.selectAll();
}

void TagMatrixPanel::endRename(bool keep) {
    if (m_renamed < 0) {
        return;
    }
    const TagTable& tags = m_document.current().level->tags;
    const QString name = m_name.text().trimmed();
    const QString objection = keep ? objectionToTagName(tags, name, m_renamed) : QString();
    QPalette colors = m_note.palette();
    colors.setColor(QPalette::WindowText, faultColor(palette()));
    m_note.setPalette(colors);
    m_note.setText(objection);
    m_note.setVisible(!objection.isEmpty());
    if (!objection.isEmpty()) {
        return;
    }
    const int tag = std::exchange(m_renamed, -1);
    m_name.hide();
    m_view.setFocus();
    TagInfo info = tags[tag];
    if (keep && !name.isEmpty() && name.toStdString() != info.name) {
        info.color = info.name.empty() ? freshTagColor(tags).rgb() & 0xffffffU : info.color;
        info.name = name.toStdString();
        commit({"change-tag", 1}, withTag(*m_document.current().level, tag, std::move(info)));
    }
}

bool TagMatrixPanel::eventFilter(QObject* watched, QEvent* event) {
    const bool isEscape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (watched == &m_name && isEscape) {
        endRename(false);
        return true;
    }
    if (watched == &m_name && event->type() == QEvent::FocusOut) {
        endRename(false);
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace spacetow
