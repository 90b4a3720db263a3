#pragma once
// The heading of a section of a form: a bold line with an arrow, which folds and unfolds what is beneath. Checked means
// unfolded.

#include <QAbstractButton>

namespace spacetow {

class SectionHeader : public QAbstractButton {
    Q_OBJECT

  public:
    explicit SectionHeader(const QString& title, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace spacetow
