#include "core/physics/solver/accelerated_passes.h"

#include "core/physics/lanes/solver_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spacetow {

namespace {

// So many passes before are mixed.
constexpr std::size_t window = 8;
// What a pass changes of the impulses, as a share of them, once they have converged.
constexpr double convergedShare = 1e-10;
// From as many times the least change so far on, the passes before mislead: other contacts have come to act since.
constexpr double misledRatio = 2;

/// Of each contact in turn: both normals and the friction of general ones, the normal and the friction of circles.
using Impulses = std::vector<double>;

template <class Add>
void listImpulses(const ContactBatches& batches, const OrderedLanes& lanes, const Add& add) {
    for (const Lane at : lanes.circles) {
        const CircleBatch& batch = batches.circles[at.batch];
        add(batch.normalImpulse[at.lane], batch.normalMass[at.lane]);
        add(batch.tangentImpulse[at.lane], batch.tangentMass[at.lane]);
    }
    for (const Lane at : lanes.general) {
        const ConstraintBatch& batch = batches.general[at.batch];
        add(batch.impulse1[at.lane], batch.mass1[at.lane]);
        add(batch.impulse2[at.lane], batch.mass2[at.lane]);
        add(batch.tangentImpulse[at.lane], batch.tangentMass[at.lane]);
    }
}

Impulses impulsesOf(const ContactBatches& batches, const OrderedLanes& lanes) {
    Impulses all;
    all.reserve(2 * lanes.circles.size() + 3 * lanes.general.size());
    listImpulses(batches, lanes, [&](double impulse, double) { all.push_back(impulse); });
    return all;
}

/// The inverse of the effective mass for each impulse, so that impulses on light and heavy bodies count alike.
Impulses weightsOf(const ContactBatches& batches, const OrderedLanes& lanes) {
    Impulses all;
    listImpulses(batches, lanes, [&](double, double mass) { all.push_back(mass > 0 ? 1 / mass : 0); });
    return all;
}

void setImpulses(ContactBatches& batches, const OrderedLanes& lanes, const Impulses& all) {
    const double* next = all.data();
    for (const Lane at : lanes.circles) {
        CircleBatch& batch = batches.circles[at.batch];
        batch.normalImpulse[at.lane] = *next++;
        batch.tangentImpulse[at.lane] = *next++;
    }
    for (const Lane at : lanes.general) {
        ConstraintBatch& batch = batches.general[at.batch];
        batch.impulse1[at.lane] = *next++;
        batch.impulse2[at.lane] = *next++;
        batch.tangentImpulse[at.lane] = *next++;
    }
}

void add(Impulses& sum, double factor, const Impulses& term) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += factor * term[i];
    }
}

Impulses difference(const Impulses& a, const Impulses& b) {
    Impulses result = a;
    add(result, -1, b);
    return result;
}

using Square = std::array<std::array<double, window>, window>;

/// Solves the first `count` equations of a positive definite matrix.
void solveEquations(Square matrix, std::array<double, window>& x, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = i + 1; k < count; ++k) {
            const double factor = matrix[k][i] / matrix[i][i];
            for (std::size_t j = i; j < count; ++j) {
                matrix[k][j] -= factor * matrix[i][j];
            }
            x[k] -= factor * x[i];
        }
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t j = i + 1; j < count; ++j) {
            x[i] -= matrix[i][j] * x[j];
        }
        x[i] /= matrix[i][i];
    }
}

/// Guesses from the last passes where all would end.
class PassMixer {
  public:
    explicit PassMixer(Impulses weights) : m_weights(std::move(weights)) {}

    /// Takes over what a pass has made of some impulses; whether it changed nothing worth another pass.
    bool converges(const Impulses& before, const Impulses& after) {
        Impulses change = difference(after, before);
        const double size = product(change, change);
        if (!(size > convergedShare * convergedShare * product(after, after))) {
            return true;
        }
        const bool misled = size > misledRatio * misledRatio * m_least;
        if (misled) {
            m_count = 0;
        } else if (!m_change.empty()) {
            keep(difference(change, m_change), difference(after, m_after));
        }
        m_least = misled ? size : std::min(m_least, size);
        m_change = std::move(change);
        m_after = after;
        return false;
    }

    /// What to add to the impulses after the pass, so that the changes of all passes that are kept cancel out as far as
    /// they can.
    Impulses correction() const {
        Impulses result(m_weights.size(), 0.0);
        const std::size_t count = std::min(m_count, window);
        std::array<double, window> shares{};
        for (std::size_t i = 0; i < count; ++i) {
            shares[i] = product(m_changes[i], m_change);
        }
        solveEquations(m_products, shares, count);
        for (std::size_t i = 0; i < count; ++i) {
            if (std::isfinite(shares[i])) {
                add(result, -shares[i], m_results[i]);
            }
        }
        return result;
    }

  private:
    Impulses m_weights;
    Impulses m_change, m_after; // of the last pass
    double m_least = std::numeric_limits<double>::infinity();
    // By how much changes and results differ from one pass to the next; the oldest are replaced.
    std::size_t m_count = 0;
    std::array<Impulses, window> m_changes, m_results;
    Square m_products{}; // of the changes with each other

    double product(const Impulses& a, const Impulses& b) const {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            sum += m_weights[i] * a[i] * b[i];
        }
        return sum;
    }

    void keep(Impulses change, Impulses result) {
        constexpr double regularization = 1e-10;
        const std::size_t at = m_count % window;
        m_changes[at] = std::move(change);
        m_results[at] = std::move(result);
        ++m_count;
        for (std::size_t i = 0; i < std::min(m_count, window); ++i) {
            m_products[at][i] = m_products[i][at] = product(m_changes[at], m_changes[i]);
        }
        m_products[at][at] *= 1 + regularization;
    }
};

} // namespace

void solveUntilConverged(ContactBatches& batches, const OrderedLanes& lanes, std::vector<BodyVelocity>& velocities,
                         int most) {
    PassMixer mixer(weightsOf(batches, lanes));
    Impulses impulses = impulsesOf(batches, lanes);
    for (int pass = 1;; ++pass) {
        solvePass(batches, velocities);
        const Impulses after = impulsesOf(batches, lanes);
        if (pass == most || mixer.converges(impulses, after)) {
            return;
        }
        impulses = mixer.correction();
        setImpulses(batches, lanes, impulses);
        warmStart(batches, velocities);
        add(impulses, 1, after);
        setImpulses(batches, lanes, impulses);
    }
}

} // namespace spacetow
