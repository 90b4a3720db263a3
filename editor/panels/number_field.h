#pragma once
// A line for one number with its unit. Takes expressions ("2*pi/3", "20 cm", "+=0.5"), says what is wrong with anything
// else and leaves it to be mended, and goes up and down with the arrow keys, the wheel and a drag on its label. What is
// shown is rounded, what is kept never.

#include "core/base/expression.h"

#include <QLineEdit>

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace spacetow {

class ScrubLabel;

struct NumberSpec {
    QString unit;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool openMin = false;    // the least value itself is not allowed
    bool whole = false;      // no fractions
    bool mayBeEmpty = false; // an empty line means "none"
    QString none;            // what an empty line shows
    double step = 0.1;       // of the arrow keys; Shift a tenth of it, Ctrl ten times
    QString meaning;         // of the field, first line of the tooltip

    bool operator==(const NumberSpec&) const = default;
};

/// What the user has done to the number. Without a change it is to be none.
struct NumberEntry {
    enum class Phase { Final, Preview, Cancelled };
    std::optional<NumberChange> change;
    Phase phase = Phase::Final;
    bool isStep = false; // of the arrow keys or the wheel
};

class NumberField : public QLineEdit {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);
    ~NumberField() override;

    void setSpec(const NumberSpec& spec);
    const NumberSpec& spec() const { return m_spec; }
    /// Shows the value unless something is being typed.
    void setValue(std::optional<double> value);
    /// Several values at once.
    void setMixed();
    std::optional<double> value() const { return m_value; }
    bool isMixed() const { return m_mixed; }

    /// Forgets what is being typed.
    void revert();
    /// Makes it the value; false when it is to be mended first.
    bool enterTyped();

    /// Makes the entry and answers with an objection, empty for none. A change that is absolute is within the range.
    /// Without it the field keeps its value itself and tells of it by entered().
    std::function<QString(const NumberEntry&)> enter;
    /// The sentence for a code of core/base/expression.
    std::function<QString(const Error&)> words;

    /// What is wrong with what was typed; empty when nothing is.
    const QString& fault() const { return m_fault; }

    /// A letter before the number that can be dragged, for one of a pair.
    void setAxis(const QString& axis);

    // A drag on the label: one step is five pixels long.
    void beginScrub();
    void scrub(int pixels, Qt::KeyboardModifiers modifiers);
    void endScrub(bool isMeant);
    bool isScrubbing() const { return m_scrub.has_value(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void entered(std::optional<double> value);
    void faultChanged();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Steps taken from one number, so that as many back give it again to the bit.
    struct Steps {
        double from;
        int tenths;
        double result;
    };
    struct Scrub {
        std::optional<double> from;
        std::optional<NumberChange> last;
    };

    void commit();
    void stepBy(int tenths);
    bool isWithin(double number) const;
    QString objectionTo(double number) const;
    std::optional<NumberChange> read();
    double scrubbed(double from, int pixels, Qt::KeyboardModifiers modifiers) const;
    void send(const NumberChange& change, bool isStep);
    void keep(std::optional<double> value);
    QString rangeText() const;
    void setFault(const QString& fault);
    void refresh();
    /// After the value was set from outside.
    void follow(bool isSame);
    void placeMargins();

    NumberSpec m_spec;
    std::optional<double> m_value;
    bool m_mixed = false;
    QString m_fault;
    std::optional<Steps> m_steps;
    std::optional<Scrub> m_scrub;
    int m_wheel = 0; // eighths of a degree that make no step yet
    std::unique_ptr<ScrubLabel> m_axis;
};

} // namespace spacetow
