#include "editor/window/finder_model.h"

#include "editor/panels/names.h"

#include <algorithm>

namespace spacetow {

namespace {

using namespace std::chrono_literals;

constexpr auto atOnce = 15ms;   // before the first results are shown
constexpr auto perTurn = 8ms;   // of a frame, afterwards
constexpr int rowsPerLook = 64; // at the clock
constexpr int ofName = 10;      // points for what is found in the name itself
constexpr int lately = 12;      // for what was taken lately
constexpr int notNow = 10;      // that an action loses which is not possible

/// What people look for rather than for others.
int pointsOf(FindKind kind) {
    switch (kind) {
    case FindKind::Action:
        return 8;
    case FindKind::Panel:
    case FindKind::Level:
        return 6;
    case FindKind::Problem:
    case FindKind::Object:
        break;
    }
    return 0;
}

} // namespace

FinderQuestion::FinderQuestion(const QString& typed) {
    const QString text = typed.trimmed();
    if (!text.isEmpty() && QStringLiteral(">/@!").contains(text.front())) {
        sign = text.front();
    }
    words = sign.isNull() ? text : text.mid(1).trimmed();
}

bool FinderQuestion::asksFor(FindKind kind) const {
    switch (sign.unicode()) {
    case u'>':
        return kind == FindKind::Action || kind == FindKind::Panel;
    case u'/':
        return kind == FindKind::Level;
    case u'@':
        return kind == FindKind::Object;
    case u'!':
        return kind == FindKind::Problem;
    default:
        return true;
    }
}

FinderModel::FinderModel(QObject* parent) : QAbstractListModel(parent) {
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, [this] { goOn(perTurn); });
}

void FinderModel::begin(std::unique_ptr<FinderRows> rows, const QStringList& recent) {
    m_rows = std::move(rows);
    m_recent.clear();
    for (const QString& code : recent) {
        if (const std::optional<int> row = m_rows->withCode(code)) {
            m_recent.push_back(*row);
        }
    }
    search(QString());
}

void FinderModel::end() {
    m_later.stop();
    m_found.clear();
    show();
    m_rows.reset();
    m_next = 0;
}

void FinderModel::search(const QString& typed) {
    m_later.stop();
    m_question = FinderQuestion(typed);
    m_query = FuzzyQuery(m_question.words);
    m_found.clear();
    m_next = 0;
    if (m_query.isEmpty()) {
        listWithoutWords();
        m_next = last();
        show();
    } else {
        goOn(atOnce);
    }
}

/// What was taken lately, then everything in its order; of objects and problems only when they are asked for.
void FinderModel::listWithoutWords() {
    for (const int row : m_recent) {
        if (m_question.asksFor(m_rows->kind(row))) {
            m_found.push_back({0, row});
        }
    }
    const int all = m_question.sign.isNull() ? m_rows->few() : last();
    for (int row = 0; row < all; ++row) {
        if (m_question.asksFor(m_rows->kind(row)) && std::ranges::find(m_recent, row) == m_recent.end()) {
            m_found.push_back({0, row});
        }
    }
}

void FinderModel::goOn(std::chrono::milliseconds time) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const bool isFirst = m_next == 0;
    while (m_next < last() && Clock::now() - start < time) {
        for (const int stop = std::min(m_next + rowsPerLook, last()); m_next < stop; ++m_next) {
            test(m_next);
        }
    }
    if (m_next < last()) {
        m_later.start(0);
    }
    if (isFirst || m_next == last()) {
        show();
    }
}

void FinderModel::test(int row) {
    const FindKind kind = m_rows->kind(row);
    if (!m_question.asksFor(kind)) {
        return;
    }
    std::optional<int> score = m_query.score(m_rows->text(row));
    if (!score) {
        return;
    }
    if (row < m_rows->few()) { // in the name itself it counts for more than in the menu's
        const FinderRow found = m_rows->row(row);
        const std::optional<int> inName = m_query.score(found.name);
        score = inName ? std::max(*inName + ofName, *score) : *score;
        score = *score + (std::ranges::find(m_recent, row) != m_recent.end() ? lately : 0) -
                (found.isPossible ? 0 : notNow);
    }
    m_found.push_back({*score + pointsOf(kind), row});
}

void FinderModel::finish() {
    m_later.stop();
    if (isSearching()) {
        goOn(1h);
    }
}

void FinderModel::show() {
    beginResetModel();
    m_shown = m_found;
    std::ranges::stable_sort(m_shown, std::ranges::greater(), &Hit::score);
    endResetModel();
    Q_EMIT searched();
}

FinderRow FinderModel::found(int row) const {
    return m_rows->row(m_shown[static_cast<std::size_t>(row)].row);
}

int FinderModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

QVariant FinderModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !m_rows) {
        return {};
    }
    if (role == Qt::DisplayRole) {
        return found(index.row()).name;
    }
    if (role == Qt::ToolTipRole) {
        return plainToolTip(found(index.row()).tip);
    }
    if (role == Qt::AccessibleDescriptionRole) {
        const FinderRow row = found(index.row());
        return row.isPossible ? row.place : row.whyNot;
    }
    return {};
}

} // namespace spacetow
