#include "editor/window/finder.h"

#include "editor/canvas/palette.h"
#include "editor/window/finder_delegate.h"
#include "editor/window/main_window.h"
#include "editor/window/style_draw.h"

#include <QKeyEvent>
#include <QMenuBar>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int widest = 680;  // px
constexpr int besides = 40;  // px, of the window
constexpr int mostRows = 14; // in sight
constexpr QSize mark(16, 16);

} // namespace

Finder::Finder(MainWindow& window) : QFrame(&window), m_window(window), m_column(this) {
    setObjectName(QStringLiteral("finder"));
    m_field.setAccessibleName(tr("Find actions, levels, objects and problems"));
    m_field.setPlaceholderText(m_field.accessibleName());
    m_field.setClearButtonEnabled(true);
    m_field.installEventFilter(this);
    m_list.setModel(&m_model);
    m_list.setItemDelegate(new FinderDelegate(m_model, &m_list)); // owned by it
    m_list.setUniformItemSizes(true);
    m_list.setIconSize(mark);
    m_list.setFocusPolicy(Qt::NoFocus); // the field keeps the keyboard
    m_list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list.setAccessibleName(tr("Found"));
    m_hint.setWordWrap(true);
    m_hint.setForegroundRole(QPalette::PlaceholderText);
    m_column.setContentsMargins(8, 8, 8, 6);
    m_column.setSpacing(6);
    m_column.addWidget(&m_field);
    m_column.addWidget(&m_list, 1);
    m_column.addWidget(&m_hint);
    connect(&m_field, &QLineEdit::textEdited, &m_model, &FinderModel::search);
    connect(&m_field, &QLineEdit::textChanged, &m_model, [this](const QString& text) {
        if (text.isEmpty() && isVisible()) {
            m_model.search(text); // by the button that clears
        }
    });
    connect(&m_model, &FinderModel::searched, this, &Finder::showFound);
    connect(&m_list, &QListView::clicked, this, &Finder::take);
    window.installEventFilter(this);
    hide();
}

/// A line that stands out from whatever lies below.
void Finder::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QColor ground = palette().color(QPalette::Window);
    plate(painter, QRectF(rect()), ground, mixed(ground, palette().color(QPalette::WindowText), 0.4));
}

void Finder::open(const QString& typed) {
    if (!isVisible()) {
        m_before = m_window.focusWidget();
        m_window.liveRun().setWaiting(true);
        show();
        raise();
        m_field.setFocus(Qt::ShortcutFocusReason); // what was being typed elsewhere is entered
        m_model.begin(std::make_unique<FinderRows>(m_window), m_window.files().preferences.recentlyFound());
    }
    m_field.setFocus(Qt::ShortcutFocusReason);
    m_field.setText(typed);
    m_model.search(typed);
    place();
}

void Finder::close() {
    if (!isVisible()) {
        return;
    }
    const bool hasKeyboard = m_field.hasFocus();
    hide();
    m_model.end();
    m_field.clear();
    if (hasKeyboard && m_before && m_before->isVisible()) {
        m_before->setFocus(Qt::OtherFocusReason);
    } else if (hasKeyboard) {
        m_window.canvas().setFocus(Qt::OtherFocusReason);
    }
    m_window.liveRun().setWaiting(false);
}

bool Finder::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window) {
        if (event->type() == QEvent::Resize && isVisible()) {
            place();
        }
        return false;
    }
    switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
        auto& stroke = static_cast<QKeyEvent&>(*event);
        if (!isKeyOfList(stroke.key()) || (stroke.modifiers() & ~Qt::KeypadModifier & ~Qt::ShiftModifier) != 0) {
            return false;
        }
        event->accept();
        if (event->type() == QEvent::KeyPress) {
            move(stroke.key());
        }
        return true;
    }
    case QEvent::FocusOut: {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) {
            QMetaObject::invokeMethod(
                this,
                [this] {
                    if (!m_field.hasFocus()) {
                        close();
                    }
                },
                Qt::QueuedConnection);
        }
        return false;
    }
    default:
        return false;
    }
}

bool Finder::isKeyOfList(int key) const {
    switch (key) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Escape:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return true;
    default:
        return false;
    }
}

/// Up and down go round and round, as in a menu; pages end at the ends.
void Finder::move(int key) {
    const int count = m_model.rowCount();
    const int row = m_list.currentIndex().row();
    if (key == Qt::Key_Escape) {
        close();
        return;
    }
    if (count == 0) {
        return;
    }
    const int page = std::max(1, m_list.viewport()->height() / std::max(1, m_list.sizeHintForRow(0)) - 1);
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        take(m_list.currentIndex());
        return;
    case Qt::Key_Up:
    case Qt::Key_Backtab:
        m_list.setCurrentIndex(m_model.index((row + count - 1) % count, 0));
        return;
    case Qt::Key_PageUp:
        m_list.setCurrentIndex(m_model.index(std::max(0, row - page), 0));
        return;
    case Qt::Key_PageDown:
        m_list.setCurrentIndex(m_model.index(std::min(count - 1, row + page), 0));
        return;
    default:
        m_list.setCurrentIndex(m_model.index((row + 1) % count, 0));
    }
}

void Finder::take(const QModelIndex& index) {
    if (!index.isValid()) {
        return;
    }
    const FinderRow row = m_model.found(index.row());
    if (!row.isPossible) {
        return; // the row says why
    }
    if (!row.code.isEmpty()) {
        m_window.files().preferences.addRecentlyFound(row.code);
    }
    close();
    row.run();
}

void Finder::showFound() {
    const int count = m_model.rowCount();
    if (count > 0) {
        m_list.setCurrentIndex(m_model.index(0, 0));
        m_list.scrollToTop();
    }
    m_list.setVisible(count > 0);
    const QString signs = tr("> actions · / levels · @ objects · ! problems · Enter: take · Esc: close");
    m_hint.setText(count > 0 || m_model.isSearching() ? signs
                                                      : tr("Nothing is called that.") + QLatin1Char('\n') + signs);
    if (isVisible()) {
        place();
    }
}

/// At the top of the window, in the middle, no higher than what was found.
void Finder::place() {
    const int width = std::min(widest, m_window.width() - besides);
    const int top = m_window.menuBar()->height() + 4;
    const int rows = std::min(m_model.rowCount(), mostRows);
    const int listHeight = rows == 0 ? 0 : rows * m_list.sizeHintForRow(0) + 2 * m_list.frameWidth();
    m_list.setFixedHeight(std::max(0, std::min(listHeight, m_window.height() - top - 140)));
    m_column.activate();
    const int height = m_column.hasHeightForWidth() ? m_column.heightForWidth(width) : m_column.sizeHint().height();
    setGeometry((m_window.width() - width) / 2, top, width, height);
}

} // namespace spacetow
