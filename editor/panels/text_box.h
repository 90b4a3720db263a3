#pragma once
// A few lines of text that tell when the user is done with them.

#include <QPlainTextEdit>

namespace spacetow {

class TextBox : public QPlainTextEdit {
    Q_OBJECT

  public:
    explicit TextBox(QWidget* parent = nullptr);

    /// Emits nothing; left alone while something is being typed.
    void setValue(const QString& text);

    /// Whole lines.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {80, sizeHint().height()}; }

  Q_SIGNALS:
    void entered(const QString& text);

  protected:
    bool event(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
};

} // namespace spacetow
