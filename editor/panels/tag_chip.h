#pragma once
// A button with the name and the colour of a tag: filled when the tag is set, hollow when not, half filled when only
// some of the selected objects have it.

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
    QColor m_color;
    State m_state = State::Off;
};

} // namespace spacetow
