#pragma once
// What was found, the best first. Many objects are searched some at a time, so that the first results come at once and
// the window goes on.

#include "editor/window/finder_rows.h"
#include "editor/window/fuzzy_query.h"

#include <QAbstractListModel>
#include <QStringList>
#include <QTimer>

#include <chrono>
#include <vector>

namespace spacetow {

/// A sign at the beginning of what is typed leaves only one kind: ">" actions and panels, "/" levels, "@" objects,
/// "!" problems.
struct FinderQuestion {
    explicit FinderQuestion(const QString& typed);
    bool asksFor(FindKind kind) const;

    QChar sign;
    QString words;
};

class FinderModel : public QAbstractListModel {
    Q_OBJECT

  public:
    explicit FinderModel(QObject* parent = nullptr);

    /// The codes of what was taken lately come first in `recent`.
    void begin(std::unique_ptr<FinderRows> rows, const QStringList& recent);
    void end();
    /// Shows what has been found in the first milliseconds, and what is found later when all is searched.
    void search(const QString& typed);
    bool isSearching() const { return m_next < last(); }
    /// Waits for what is left.
    void finish();

    FinderRow found(int row) const;
    /// Places of the letters in its name that were searched for.
    std::vector<int> marks(const QString& name) const { return m_query.places(name); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  Q_SIGNALS:
    /// Rows are other ones now.
    void searched();

  private:
    struct Hit {
        int score;
        int row; // of FinderRows
    };
    int last() const { return m_rows ? m_rows->size() : 0; }
    void goOn(std::chrono::milliseconds time);
    void test(int row);
    void listWithoutWords();
    void show();

    std::unique_ptr<FinderRows> m_rows;
    std::vector<int> m_recent; // rows, the latest first
    FinderQuestion m_question{QString()};
    FuzzyQuery m_query;
    std::vector<Hit> m_found;
    std::vector<Hit> m_shown;
    int m_next = 0; // row that is searched next
    QTimer m_later;
};

} // namespace spacetow
