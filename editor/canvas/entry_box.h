#pragma once
// Two small fields beside the pointer, into which length and angle are typed while something is drawn. What they mean
// and what becomes of it is said by the toolbox; the fields only hold the text.

#include "editor/editing/toolbox.h"

#include <QFrame>
#include <QLabel>
#include <QLineEdit>

#include <array>

namespace spacetow {

class EntryBox : public QFrame {
    Q_OBJECT

  public:
    /// Hidden at first. The toolbox must outlive the box.
    EntryBox(Toolbox& toolbox, QWidget& canvas);

    /// Opens with the text that was typed on the canvas.
    void begin(const QString& text);
    /// Shows what the toolbox says, beside the pointer; hides when nothing is being typed any more.
    void follow(const QPoint& pointer);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    struct Field {
        QLabel name;
        QLineEdit text;
        QLabel unit;
    };
    void send();
    void showKind(TypedKind kind);
    void showFaults(int faulty);
    void moveBeside(const QPoint& pointer);

    Toolbox& m_toolbox;
    std::array<Field, 2> m_fields;
};

} // namespace spacetow
