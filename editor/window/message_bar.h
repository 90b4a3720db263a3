#pragma once
// A bar above the canvas that says what went wrong or is worth knowing, without getting in the way of the work.

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

namespace spacetow {

class MessageBar : public QWidget {
    Q_OBJECT

  public:
    enum class Tone { Info, Warning, Error };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Replaces what the bar says; plain text, may have several lines.
    void say(Tone tone, const QString& text);
    void dismiss();
    QString text() const { return m_text.text(); }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void dress();

    QHBoxLayout m_row;
    QLabel m_icon;
    QLabel m_text;
    QToolButton m_close;
    Tone m_tone = Tone::Info;
};

} // namespace spacetow
