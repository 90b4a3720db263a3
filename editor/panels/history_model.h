#pragma once
// The history as a list: what was opened, then each edit by its name; the present state stands out, what redo would
// make again is grey, and the state that is in the file bears a mark.

#include "editor/editing/document.h"

#include <QAbstractListModel>
#include <QIcon>
#include <QPixmap>

#include <deque>
#include <functional>

namespace spacetow {

class HistoryModel : public QAbstractListModel {
    Q_OBJECT

  public:
    using Words = std::function<QString(const Label&)>;

    /// The document must outlive the model; `words` makes a sentence of a label.
    HistoryModel(const Document& document, Words words, QObject* parent = nullptr);

    /// Shows what the document has. The row of the state that is `n` edits old has the number `n`. Costs what has
    /// come, gone or changed its side of the present.
    void refresh();
    /// What the first row says.
    void setOrigin(const QString& text);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

  private:
    QString textOf(int row) const;
    void announce(int first, int last);
    QString stateOf(int row) const;

    const Document& m_document;
    Words m_words;
    QString m_origin;
    std::deque<std::uint64_t> m_numbers; // of the entries in the list
    int m_position = 0;
    int m_saved = -1; // row of the state that is in the file; −1: none
    QIcon m_mark;
    QPixmap m_noMark; // keeps the texts in line
};

} // namespace spacetow
