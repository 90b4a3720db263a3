#pragma once
// A sentence that says what is wrong with what was typed, beneath the field or bar that it is about. Hidden while there
// is nothing to say.

#include <QLabel>

namespace spacetow {

class FaultLabel : public QLabel {
    Q_OBJECT

  public:
    explicit FaultLabel(QWidget* parent = nullptr);

    void say(const QString& fault);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void tint();
};

} // namespace spacetow
