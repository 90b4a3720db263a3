#pragma once
// A line of text that tells when the user is done with it. Once entered it is undone in the level, not in the line.

#include <QLineEdit>

namespace spacetow {

class TextLine : public QLineEdit {
    Q_OBJECT

  public:
    explicit TextLine(QWidget* parent = nullptr);

    /// Emits nothing; left alone while something is being typed.
    void setValue(const QString& text);
    /// Forgets what is being typed.
    void revert();

  Q_SIGNALS:
    void entered(const QString& text);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void commit();

    QString m_value;
};

} // namespace spacetow
