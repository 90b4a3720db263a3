#pragma once
// The problems of a level as a list model: a row says its sentence only when it is looked at, so that fifty thousand of
// them take no more memory than the problems themselves.

#include "core/level/problem.h"
#include "editor/editing/document.h"

#include <QAbstractListModel>
#include <QColor>
#include <QIcon>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace spacetow {

/// Which problems are rows.
struct ProblemFilter {
    std::array<bool, 3> severities{true, true, true}; // by Severity
    bool hidden = false;                              // also those that the author has hidden

    bool operator==(const ProblemFilter&) const = default;
};

class ProblemList : public QAbstractListModel {
    Q_OBJECT

  public:
    using Sentence = std::function<QString(const Problem&)>;
    using Words = std::function<QString(const Label&)>;
    static constexpr int fixRole = Qt::UserRole; // what the fix of the problem is called; empty where there is none

    explicit ProblemList(Sentence sentence, Words words = {}, QObject* parent = nullptr)
        : QAbstractListModel(parent), m_sentence(std::move(sentence)), m_words(std::move(words)) {}

    /// The level in which they were found names their objects, and says which are hidden.
    void setProblems(std::shared_ptr<const Level> level, std::shared_ptr<const std::vector<Problem>> problems);
    /// The same problems of a level whose objects may be elsewhere or have other names.
    void setLevel(std::shared_ptr<const Level> level);
    /// Hidden ones and those that are no rows among them.
    const std::vector<Problem>& problems() const { return *m_problems; }
    const std::vector<bool>& hidden() const { return m_hidden; }
    const ProblemFilter& filter() const { return m_filter; }
    void setFilter(const ProblemFilter& filter);

    /// The place of the row's problem among all; −1 for no row.
    int problemAt(int row) const;
    /// How many there are that are not hidden.
    int count(Severity severity) const;
    int hiddenCount() const;
    /// What the fix of this problem is called; empty when there is none.
    QString fixText(const Problem& problem) const;

    /// Marks in colours that are read on the palette; `faded` for what is hidden.
    void setMarks(const std::array<QIcon, 3>& bySeverity, const QColor& faded);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    QString text(const Problem& problem) const;
    void fill();

    Sentence m_sentence;
    Words m_words;
    std::shared_ptr<const Level> m_level;
    std::shared_ptr<const std::vector<Problem>> m_problems = std::make_shared<const std::vector<Problem>>();
    std::vector<bool> m_hidden; // of each problem
    std::vector<int> m_rows;    // places in m_problems
    ProblemFilter m_filter;
    std::array<QIcon, 3> m_marks;
    QColor m_faded;
};

} // namespace spacetow
