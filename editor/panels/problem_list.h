#pragma once
// The problems of a level as a list model: a row says its sentence only when it is looked at, so that fifty thousand of
// them take no more memory than the problems themselves.

#include "core/level/problem.h"

#include <QAbstractListModel>
#include <QIcon>

#include <functional>
#include <memory>
#include <vector>

namespace spacetow {

class ProblemList : public QAbstractListModel {
    Q_OBJECT

  public:
    using Sentence = std::function<QString(const Problem&)>;

    explicit ProblemList(Sentence sentence, QObject* parent = nullptr)
        : QAbstractListModel(parent), m_sentence(std::move(sentence)) {}

    /// The level in which they were found names their objects.
    void setProblems(std::shared_ptr<const Level> level, std::vector<Problem> problems);
    /// The same problems of a level whose objects may be elsewhere or have other names.
    void setLevel(std::shared_ptr<const Level> level);
    const std::vector<Problem>& problems() const { return m_problems; }
    /// Marks in colours that are read on the palette.
    void setMarks(const QIcon& error, const QIcon& warning);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    QString text(const Problem& problem) const;

    Sentence m_sentence;
    std::shared_ptr<const Level> m_level;
    std::vector<Problem> m_problems;
    QIcon m_error, m_warning;
};

} // namespace spacetow
