#include "core/game/plot_history.h"

#include "core/physics/query/explain.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace spacetow {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool differs(double a, double b) {
    return !std::isnan(a) && !std::isnan(b) && a != b;
}

bool isDrift(PlotQuantity quantity) {
    return quantity == PlotQuantity::EnergyDrift || quantity == PlotQuantity::MomentumDrift;
}

void appendNumber(std::string& text, double number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text.append(digits.data(), end);
}

/// In quotation marks where it has to be.
std::string cellText(const std::string& name) {
    if (name.find_first_of(",\"\n\r") == std::string::npos) {
        return name;
    }
    std::string text = "\"";
    for (const char c : name) {
        text += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return text + "\"";
}

} // namespace

void PlotHistory::watch(std::vector<PlotSource> sources) {
    std::vector<std::vector<double>> columns;
    for (const PlotSource& source : sources) {
        const auto known = std::find(m_sources.begin(), m_sources.end(), source);
        columns.push_back(known == m_sources.end() ? std::vector<double>(m_seconds.size(), unknown)
                                                   : m_columns[static_cast<std::size_t>(known - m_sources.begin())]);
    }
    m_sources = std::move(sources);
    m_columns = std::move(columns);
}

void PlotHistory::clear() {
    eraseFrom(0);
    m_reference.reset();
    m_shown = 0;
}

void PlotHistory::forgetAfter(std::int64_t update) {
    eraseFrom(static_cast<std::size_t>(std::ranges::upper_bound(m_updates, update) - m_updates.begin()));
}

std::optional<double> PlotHistory::energyChange() const {
    return m_reference ? std::optional(m_energy - m_reference->energy) : std::nullopt;
}

double PlotHistory::drift(PlotQuantity quantity) const {
    const std::optional<double> share = quantity == PlotQuantity::EnergyDrift ? energyDrift() : momentumDrift();
    return share ? 100 * *share : unknown;
}

std::vector<double> PlotHistory::rowOf(const Session& session) {
    const WorldReading sum = totals(session.world());
    m_energy = sum.energy();
    m_momentum = sum.momentum;
    if (!m_reference) {
        m_reference = Reference{m_energy, m_momentum, 0, 0};
    }
    m_reference->mostEnergy = std::max(m_reference->mostEnergy, sum.kinetic + sum.elastic);
    m_reference->mostMomentum = std::max(m_reference->mostMomentum, sum.motion);
    std::vector<double> row;
    row.reserve(m_sources.size());
    for (const PlotSource& source : m_sources) {
        row.push_back(isDrift(source.quantity) ? drift(source.quantity) : plotted(session, source).value_or(unknown));
    }
    return row;
}

void PlotHistory::eraseFrom(std::size_t row) {
    m_updates.resize(row);
    m_seconds.resize(row);
    for (std::vector<double>& column : m_columns) {
        column.resize(row);
    }
}

// NOLINTNEXTLINE(readability-function-size): where, when, and what
void PlotHistory::insert(std::size_t row, std::int64_t update, double seconds, const std::vector<double>& values) {
    const auto at = static_cast<std::ptrdiff_t>(row);
    m_updates.insert(m_updates.begin() + at, update);
    m_seconds.insert(m_seconds.begin() + at, seconds);
    for (std::size_t i = 0; i < values.size(); ++i) {
        m_columns[i].insert(m_columns[i].begin() + at, values[i]);
    }
}

void PlotHistory::sample(const Session& session) {
    const std::int64_t update = session.updates();
    const std::vector<double> values = rowOf(session);
    auto row =
        static_cast<std::size_t>(std::lower_bound(m_updates.begin(), m_updates.end(), update) - m_updates.begin());
    if (row < m_updates.size() && m_updates[row] == update) {
        bool same = true;
        for (std::size_t i = 0; i < values.size(); ++i) {
            same = same && (isDrift(m_sources[i].quantity) || !differs(m_columns[i][row], values[i]));
        }
        if (same) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                m_columns[i][row] = std::isnan(m_columns[i][row]) ? values[i] : m_columns[i][row];
            }
            m_shown = m_seconds[row];
            return;
        }
        eraseFrom(row);
    }
    // An update may have become longer or shorter since the one before.
    const double since = row == 0 ? 0 : m_seconds[row - 1];
    const std::int64_t passed = row == 0 ? update : update - m_updates[row - 1];
    m_shown = since + static_cast<double>(passed) * session.updateSeconds();
    insert(row, update, m_shown, values);
    thin();
}

void PlotHistory::thin() {
    const double oldest = m_seconds.back() - fullSeconds;
    const auto older =
        static_cast<std::size_t>(std::lower_bound(m_seconds.begin(), m_seconds.end(), oldest) - m_seconds.begin());
    if (older <= mostOlder) {
        return;
    }
    std::size_t to = 0;
    for (std::size_t from = 0; from < m_seconds.size(); ++from) {
        if (from >= older || from % 2 == 0) {
            m_updates[to] = m_updates[from];
            m_seconds[to] = m_seconds[from];
            for (std::vector<double>& column : m_columns) {
                column[to] = column[from];
            }
            ++to;
        }
    }
    eraseFrom(to);
}

std::optional<double> PlotHistory::energyDrift() const {
    return m_reference && m_reference->mostEnergy > 0
               ? std::optional((m_energy - m_reference->energy) / m_reference->mostEnergy)
               : std::nullopt;
}

std::optional<double> PlotHistory::momentumDrift() const {
    return m_reference && m_reference->mostMomentum > 0
               ? std::optional((m_momentum - m_reference->momentum).norm() / m_reference->mostMomentum)
               : std::nullopt;
}

std::string PlotHistory::csv(const std::vector<std::string>& names) const {
    std::string text = "s";
    for (const std::string& name : names) {
        text += ',' + cellText(name);
    }
    text += '\n';
    for (std::size_t row = 0; row < size(); ++row) {
        appendNumber(text, m_seconds[row]);
        for (const std::vector<double>& column : m_columns) {
            text += ',';
            if (!std::isnan(column[row])) {
                appendNumber(text, column[row]);
            }
        }
        text += '\n';
    }
    return text;
}

} // namespace spacetow
