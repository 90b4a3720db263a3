#include "editor/panels/problem_list.h"

#include "editor/panels/names.h"

namespace spacetow {

void ProblemList::setProblems(std::shared_ptr<const Level> level, std::vector<Problem> problems) {
    beginResetModel();
    m_level = std::move(level);
    m_problems = std::move(problems);
    endResetModel();
}

void ProblemList::setLevel(std::shared_ptr<const Level> level) {
    m_level = std::move(level);
    if (!m_problems.empty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DisplayRole, Qt::ToolTipRole});
    }
}

void ProblemList::setMarks(const QIcon& error, const QIcon& warning) {
    m_error = error;
    m_warning = warning;
    if (!m_problems.empty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
    }
}

int ProblemList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

QVariant ProblemList::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const Problem& problem = m_problems[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return text(problem);
    case Qt::DecorationRole:
        return problem.severity == Severity::Error ? m_error : m_warning;
    default:
        return {};
    }
}

QString ProblemList::text(const Problem& problem) const {
    const Object* object = problem.object != 0 ? m_level->objects.find(problem.object) : nullptr;
    // There is but one ship, payload and finish; of the others one must say which.
    const bool oneOfMany = object != nullptr && (std::holds_alternative<BodyObject>(object->data) ||
                                                 std::holds_alternative<ConnectorObject>(object->data));
    const QString sentence = m_sentence(problem);
    return oneOfMany ? tr("%1: %2").arg(listedName(*m_level, *object), sentence) : sentence;
}

} // namespace spacetow
