#pragma once
// A button with the name and the colour of a tag: filled when the tag is set, hollow when not, half filled when only
// some of the selected objects have it; crossed out when it is an exception.

#include <QAbstractButton>
#include <QColor>

namespace spacetow {

class TagChip : public QAbstractButton {
    Q_OBJECT

  public:
    enum class State { Off, On, Mixed };

    explicit TagChip(QWidget* parent = nullptr);

    void setTag(const QString& name, const QColor& color);
    void setState(State state);
    State state() const { return m_state; }
    /// What is not set is then crossed out.
    void setExcepting(bool excepting);
    bool isCrossedOut() const { return m_excepting && m_state == State::Off; }
    QColor color() const { return m_color; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void editWanted();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QString m_name;
    QColor m_color;
    State m_state = State::Off;
    bool m_excepting = false;
};

} // namespace spacetow
