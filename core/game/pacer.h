#pragma once
// Turns the passing of real time into a number of updates of fixed length. Times are seconds of any steady clock.

namespace spacetow {

class Pacer {
  public:
    /// After a hold-up at most `catchUp` updates are made at once; what is older is given up, so that a machine that
    /// is too slow slows the game instead of freezing it.
    explicit Pacer(double period, int catchUp = 5) : m_period(period), m_catchUp(catchUp) {}

    /// The next update is due one period from now; what was due before is forgotten.
    void restart(double now) { m_next = now + m_period; }

    /// How many updates to make now. They count as made.
    int due(double now) {
        int count = 0;
        while (m_next <= now && count < m_catchUp) {
            m_next += m_period;
            ++count;
        }
        if (m_next <= now) {
            restart(now);
        }
        return count;
    }

    /// When `due` will next be positive.
    double next() const { return m_next; }
    double period() const { return m_period; }
    /// From the next update on.
    void setPeriod(double period) { m_period = period; }

  private:
    double m_period;
    int m_catchUp;
    double m_next = 0;
};

} // namespace spacetow
