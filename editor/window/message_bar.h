#pragma once
// A bar above the canvas that says what went wrong or is worth knowing, without getting in the way of the work.

#include "editor/canvas/palette.h"

#include <QBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include <functional>
#include <vector>

namespace spacetow {

class MessageBar : public QWidget {
    Q_OBJECT

  public:
    enum class Tone { Info, Warning, Error };
    /// What the user can do about it: a button.
    struct Choice {
        QString text;
        std::function<void()> run;
    };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Replaces what the bar says; plain text, may have several lines.
    void say(Tone tone, const QString& text, const std::vector<Choice>& choices = {});
    void dismiss();
    QString text() const { return m_text.text(); }
    Tone tone() const { return m_tone; }
    /// As many as there are choices, in their order.
    const std::vector<QToolButton*>& buttons() const { return m_buttons; }

  Q_SIGNALS:
    void dismissed(); // by its own button

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void dress();
    void arrange();

    QHBoxLayout m_row;
    QBoxLayout m_content; // the text, and beside or below it the buttons
    QHBoxLayout m_choices;
    QLabel m_icon;
    QLabel m_text;
    QToolButton m_close;
    std::vector<QToolButton*> m_buttons;
    Tone m_tone = Tone::Info;
};

/// The colours of a bar, and the name of its icon.
struct BarDress {
    QColor plate;
    QColor ink;
    const char* icon;
};
BarDress barDress(MessageBar::Tone tone, Shade shade);

} // namespace spacetow
