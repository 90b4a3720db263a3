#pragma once
// The command palette: a field at the top of the window that finds actions, panels, levels, objects and problems by a
// few letters, and does or shows what was found. Enter takes what is marked, Escape leaves everything as it is.

#include "editor/window/finder_model.h"

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPointer>
#include <QVBoxLayout>

namespace spacetow {

class Finder : public QFrame {
    Q_OBJECT

  public:
    /// The window must be a MainWindow of which this is a part.
    explicit Finder(MainWindow& window);

    /// With this already typed, as ">" for actions; where it is open, it goes on with that.
    void open(const QString& typed);
    /// Puts the keyboard back where it was.
    void close();

    QLineEdit& field() { return m_field; }
    QListView& list() { return m_list; }
    FinderModel& model() { return m_model; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isKeyOfList(int key) const;
    void move(int key);
    void take(const QModelIndex& index);
    void showFound();
    void place();

    MainWindow& m_window;
    FinderModel m_model;
    QVBoxLayout m_column;
    QLineEdit m_field;
    QListView m_list;
    QLabel m_hint;
    QPointer<QWidget> m_before; // had the keyboard
};

} // namespace spacetow
