#pragma once
// What has been plotted of a session so far: a table with a row for each update that was seen and a column for each
// curve. Bounded: the last minute in full, what is older thinned out.

#include "core/game/plot_quantity.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace spacetow {

class PlotHistory {
  public:
    static constexpr double fullSeconds = 60;
    static constexpr std::size_t mostOlder = 3000; // rows

    /// Columns that were there before keep what they have; new ones begin with nothing.
    void watch(std::vector<PlotSource> sources);
    const std::vector<PlotSource>& sources() const { return m_sources; }
    void clear();
    /// Another future has begun after this update.
    void forgetAfter(std::int64_t update);

    /// A row for the update that the session is at. What is seen again is left alone; where it has become different,
    /// another future has begun, and what was known of the old one goes.
    void sample(const Session& session);

    std::size_t size() const { return m_seconds.size(); }
    const std::vector<double>& seconds() const { return m_seconds; } // simulated, ascending
    /// As long as seconds(); NaN where nothing is known.
    const std::vector<double>& column(std::size_t source) const { return m_columns[source]; }

    /// Where the session stood that was sampled last, s; also when it was rewound.
    double shownSeconds() const { return m_shown; }

    /// J that energy has come from what it was in the first row; nothing before there is one.
    std::optional<double> energyChange() const;
    /// The same as a share of the most that ever moved or was
    /// stretched; nothing where nothing ever did.
    std::optional<double> energyDrift() const;
    /// Likewise momentum, of the most there ever was in all bodies.
    std::optional<double> momentumDrift() const;

    /// A head and a row for each update. `names` has one for each source. Decimal points, commas between; nothing
    /// where nothing is known.
    std::string csv(const std::vector<std::string>& names) const;

  private:
    struct Reference {
        double energy = 0;
        Vec2 momentum{0, 0};
        double mostEnergy = 0;   // J
        double mostMomentum = 0; // kg m/s
    };
    std::vector<double> rowOf(const Session& session);
    double drift(PlotQuantity quantity) const;
    void eraseFrom(std::size_t row);
    void insert(std::size_t row, std::int64_t update, double seconds, const std::vector<double>& values);
    void thin();

    std::vector<PlotSource> m_sources;
    std::vector<std::int64_t> m_updates;
    std::vector<double> m_seconds;
    std::vector<std::vector<double>> m_columns;
    double m_shown = 0;
    std::optional<Reference> m_reference;
    double m_energy = 0; // of the last sample
    Vec2 m_momentum{0, 0};
};

} // namespace spacetow
