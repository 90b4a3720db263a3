#pragma once
// A line for one number with its unit: takes "1.5" and "1,5", says what is wrong with anything else, and goes up and
// down with the arrow keys and the wheel. A number that nobody typed into is never rounded.

#include <QLineEdit>

#include <limits>
#include <optional>

namespace spacetow {

struct NumberSpec {
    QString unit;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool openMin = false;    // the least value itself is not allowed
    bool whole = false;      // no fractions
    bool mayBeEmpty = false; // an empty line means "none"
    QString none;            // what an empty line shows
    double step = 0.1;       // of the arrow keys; Shift a tenth of it, Ctrl ten times
};

class NumberField : public QLineEdit {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);

    void setSpec(const NumberSpec& spec);
    /// Shows the value unless something is being typed. Emits nothing.
    void setValue(std::optional<double> value);
    /// Several values at once.
    void setMixed();
    std::optional<double> value() const { return m_value; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// The number that the text spells, nothing for anything else.
    static std::optional<double> parsed(const QString& text);

  Q_SIGNALS:
    /// The user has entered this value; it is within the range.
    void entered(std::optional<double> value);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void commit();
    void revert();
    void stepBy(double steps);
    bool accepts(double number) const;
    QString rangeText() const;
    void setWrong(bool wrong);
    void refresh();

    NumberSpec m_spec;
    std::optional<double> m_value;
    bool m_mixed = false;
    bool m_wrong = false;
};

} // namespace spacetow
