#include "editor/panels/problem_list.h"

#include "core/level/fixes.h"
#include "core/level/lint.h"
#include "editor/panels/names.h"

#include <QFont>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

namespace spacetow {

namespace {

/// Problems whose sentences speak of the object as "it".
constexpr std::array<std::string_view, 4> sayingIt{"hidden-in-play", "parent-missing", "parent-no-group",
                                                   "parent-circle"};

} // namespace

void ProblemList::setProblems(std::shared_ptr<const Level> level,
                              std::shared_ptr<const std::vector<Problem>> problems) {
    beginResetModel();
    m_level = std::move(level);
    m_problems = std::move(problems);
    fill();
    endResetModel();
}

void ProblemList::setLevel(std::shared_ptr<const Level> level) {
    if (m_level != nullptr && level->hiddenProblems != m_level->hiddenProblems) {
        beginResetModel();
        m_level = std::move(level);
        fill();
        endResetModel();
        return;
    }
    m_level = std::move(level);
    if (!m_rows.empty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DisplayRole, Qt::ToolTipRole});
    }
}

void ProblemList::setFilter(const ProblemFilter& filter) {
    if (!(filter == m_filter)) {
        beginResetModel();
        m_filter = filter;
        fill();
        endResetModel();
    }
}

void ProblemList::fill() {
    m_hidden = m_level == nullptr ? std::vector<bool>(m_problems->size()) : hiddenAmong(*m_level, *m_problems);
    m_rows.clear();
    for (std::size_t i = 0; i < m_problems->size(); ++i) {
        const auto severity = static_cast<std::size_t>((*m_problems)[i].severity);
        if (m_filter.severities[severity] && (m_filter.hidden || !m_hidden[i])) {
            m_rows.push_back(static_cast<int>(i));
        }
    }
    // The worst first; what is equally bad, in the order of the level.
    std::ranges::stable_sort(m_rows, std::ranges::greater(),
                             [this](int i) { return (*m_problems)[static_cast<std::size_t>(i)].severity; });
}

int ProblemList::problemAt(int row) const {
    return row >= 0 && row < rowCount() ? m_rows[static_cast<std::size_t>(row)] : -1;
}

int ProblemList::count(Severity severity) const {
    int count = 0;
    for (std::size_t i = 0; i < m_problems->size(); ++i) {
        count += !m_hidden[i] && (*m_problems)[i].severity == severity ? 1 : 0;
    }
    return count;
}

int ProblemList::hiddenCount() const {
    return static_cast<int>(std::ranges::count(m_hidden, true));
}

QString ProblemList::fixText(const Problem& problem) const {
    const Fix* const fix = fixFor(problem);
    if (fix == nullptr) {
        return {};
    }
    const Label label{fix->label, 1};
    return m_words ? m_words(label) : QString::fromUtf8(label.code.text());
}

void ProblemList::setMarks(const std::array<QIcon, 3>& bySeverity, const QColor& faded) {
    m_marks = bySeverity;
    m_faded = faded;
    if (!m_rows.empty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole, Qt::ForegroundRole});
    }
}

int ProblemList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant ProblemList::data(const QModelIndex& index, int role) const {
    const int place = index.isValid() ? problemAt(index.row()) : -1;
    if (place < 0) {
        return {};
    }
    const Problem& problem = (*m_problems)[static_cast<std::size_t>(place)];
    const bool isHidden = m_hidden[static_cast<std::size_t>(place)];
    switch (role) {
    case Qt::DisplayRole:
        return text(problem);
    case Qt::ToolTipRole:
        return plainToolTip(text(problem));
    case Qt::DecorationRole:
        return m_marks[static_cast<std::size_t>(problem.severity)];
    case Qt::FontRole:
        if (isHidden) {
            QFont font;
            font.setStrikeOut(true);
            return font;
        }
        return {};
    case Qt::ForegroundRole:
        return isHidden ? QVariant(m_faded) : QVariant();
    case fixRole:
        return isHidden ? QString() : fixText(problem);
    default:
        return {};
    }
}

QString ProblemList::text(const Problem& problem) const {
    const Object* object = problem.object != 0 ? m_level->objects.find(problem.object) : nullptr;
    const QString sentence = m_sentence(problem);
    if (object == nullptr) {
        return sentence;
    }
    // There is but one ship, payload and finish, and most sentences name them; of the others one must say which.
    const bool oneOfMany =
        std::holds_alternative<BodyObject>(object->data) || std::holds_alternative<ConnectorObject>(object->data);
    const bool saysIt = std::ranges::find(sayingIt, problem.code.text()) != sayingIt.end();
    const bool isGroup = std::holds_alternative<GroupObject>(object->data);
    return oneOfMany || (saysIt && isGroup) ? tr("%1: %2").arg(listedName(*m_level, *object), sentence)
           : saysIt                         ? tr("%1: %2").arg(kindName(*object), sentence)
                                            : sentence;
}

} // namespace spacetow
