#pragma once
// The tree of the outliner: its keys, clicks on the eye and its neighbours, and drops between rows.

#include "editor/panels/outliner_model.h"

#include <QPointer>
#include <QTreeView>

namespace spacetow {

class OutlinerView : public QTreeView {
    Q_OBJECT

  public:
    explicit OutlinerView(OutlinerModel& model, QWidget* parent = nullptr);

    /// Opens the name for editing; after that the keyboard goes back to where it was.
    void rename(const QModelIndex& index);

  Q_SIGNALS:
    /// A click on the colour, eye or lock of a row, or the space bar for the eye of the current one.
    void switchWanted(const QModelIndex& index);
    /// Select all, while a filter leaves only some.
    void allFoundWanted();
    /// Enter.
    void objectWanted();
    /// Alt and an arrow: one row up (−1) or down (1).
    void stepWanted(int by);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

  private:
    /// Whether the press is on one of the switches, and has been dealt with.
    bool isSwitched(const QMouseEvent& event);

    OutlinerModel& m_model;
    QPointer<QWidget> m_backTo; // had the keyboard before a name was edited
};

} // namespace spacetow
