#pragma once
// A level as a card: its picture, its name, and where it is. A button, for the mouse and for keys.

#include <QAbstractButton>
#include <QPixmap>

namespace spacetow {

class LevelCard : public QAbstractButton {
    Q_OBJECT

  public:
    static constexpr QSize pictureSize{200, 125}; // logical pixels

    /// The path may be that of a resource.
    LevelCard(const QString& path, const QString& name, const QString& place, QWidget* parent = nullptr);

    const QString& path() const { return m_path; }
    const QPixmap& picture() const { return m_picture; }
    /// A null one stands for a level that has not been painted yet.
    void setPicture(const QPixmap& picture);
    /// There is nothing that could be painted.
    void setUnreadable(bool unreadable);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QString m_path;
    QString m_place;
    QPixmap m_picture;
    bool m_unreadable = false;
};

} // namespace spacetow
