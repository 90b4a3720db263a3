#pragma once
// The zoom in the status bar: shows the percentage, takes another one typed or chosen. 1 is the original size.

#include <QComboBox>

#include <optional>

namespace spacetow {

class ZoomField : public QComboBox {
    Q_OBJECT

  public:
    explicit ZoomField(QWidget* parent = nullptr);

    void setZoom(double zoom);

    /// "150", "150 %", "12,5%" as a factor; nothing for what is no percentage.
    static std::optional<double> zoomIn(const QString& text);
    static QString textFor(double zoom);

  signals:
    void zoomChosen(double zoom);
    /// Done with typing: the focus belongs to the canvas again.
    void left();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void enter();
    void restore();

    double m_zoom = 1;
};

} // namespace spacetow
