#include "editor/panels/history_model.h"

#include "editor/canvas/icons.h"
#include "editor/panels/number_text.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace spacetow {

HistoryModel::HistoryModel(const Document& document, Words words, QObject* parent)
    : QAbstractListModel(parent), m_document(document), m_words(std::move(words)),
      m_mark(livingIcon(QStringLiteral("save"))), m_noMark(16, 16) {
    m_noMark.fill(Qt::transparent);
    refresh();
}

void HistoryModel::refresh() {
    const int size = m_document.historySize();
    int gone = 0; // of the oldest
    while (gone < static_cast<int>(m_numbers.size()) &&
           (size == 0 || m_numbers[static_cast<std::size_t>(gone)] < m_document.entryNumber(0))) {
        ++gone;
    }
    if (gone > 0) {
        beginRemoveRows({}, 1, gone);
        m_numbers.erase(m_numbers.begin(), m_numbers.begin() + gone);
        endRemoveRows();
        announce(0, 0);
    }
    const int count = static_cast<int>(m_numbers.size());
    int same = count; // of the oldest that are left
    while (same > 0 &&
           (same > size || m_numbers[static_cast<std::size_t>(same - 1)] != m_document.entryNumber(same - 1))) {
        --same;
    }
    if (same < count) {
        beginRemoveRows({}, same + 1, count);
        m_numbers.resize(static_cast<std::size_t>(same));
        endRemoveRows();
    }
    const int before = std::exchange(m_position, m_document.position());
    if (same < size) {
        beginInsertRows({}, same + 1, size);
        for (int entry = same; entry < size; ++entry) {
            m_numbers.push_back(m_document.entryNumber(entry));
        }
        endInsertRows();
    }
    // An edit that was merged with the one before has given it its name.
    announce(std::min({before, m_position, size}), std::min(std::max(before, m_position), size));
    const int saved = std::exchange(m_saved, m_document.savedPosition().value_or(-1));
    if (saved != m_saved) {
        announce(saved, saved);
        announce(m_saved, m_saved);
    }
}

void HistoryModel::setOrigin(const QString& text) {
    m_origin = text;
    announce(0, 0);
}

void HistoryModel::announce(int first, int last) {
    if (first >= 0 && last < rowCount()) {
        Q_EMIT dataChanged(index(first), index(last));
    }
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_numbers.size()) + 1;
}

QString HistoryModel::textOf(int row) const {
    if (row > 0) {
        return m_words(m_document.label(row - 1));
    }
    const int forgotten = m_document.forgotten();
    return forgotten == 0 ? m_origin
                          : counted(tr("%n older changes that can no longer be undone", nullptr, forgotten), forgotten);
}

QString HistoryModel::stateOf(int row) const {
    QStringList states;
    if (row >= m_position) {
        states << (row == m_position ? tr("present state") : tr("undone"));
    }
    if (row == m_saved) {
        states << tr("saved");
    }
    return states.join(QStringLiteral(", "));
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
        return textOf(index.row());
    case Qt::FontRole: {
        QFont font;
        font.setBold(index.row() == m_position);
        return font;
    }
    case Qt::ForegroundRole:
        return index.row() > m_position ? QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text))
                                        : QVariant();
    case Qt::DecorationRole:
        return index.row() == m_saved ? QVariant(m_mark) : QVariant(m_noMark);
    case Qt::ToolTipRole:
        return index.row() == m_saved ? QVariant(tr("Saved: the file holds this state")) : QVariant();
    case Qt::AccessibleDescriptionRole:
        return stateOf(index.row());
    default:
        return {};
    }
}

} // namespace spacetow
