#pragma once
// What was changed in the level while it ran, a row for each change, to be kept or not: see
// editor/editing/run_changes.h.

#include "editor/canvas/canvas.h"
#include "editor/editing/run_changes.h"

#include <QAbstractListModel>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

namespace spacetow {

/// The rows, with what is ticked.
class RunChangesList : public QAbstractListModel {
    Q_OBJECT

  public:
    /// The changes must outlive this.
    explicit RunChangesList(RunChanges& changes) : m_changes(changes) {}

    /// Rows that are others, or the same with other ticks.
    void refresh();
    void setMarks(const MarkColors& colors, const QColor& selected);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    QVariant markOf(const LevelChange& change) const;
    QString needsText(const LevelChange& change) const;

    RunChanges& m_changes;
    QStringList m_texts;
    QIcon m_added, m_removed, m_changed;
};

/// Space and the arrow keys are its own.
class RunChangesView : public QListView {
    Q_OBJECT

  public:
    using QListView::QListView;

  protected:
    bool event(QEvent* event) override;
};

class RunChangesPanel : public QWidget {
    Q_OBJECT

  public:
    /// All of them must outlive the panel.
    RunChangesPanel(RunChanges& changes, Document& document, Canvas& canvas, QWidget* parent = nullptr);
    ~RunChangesPanel() override;

    QSize sizeHint() const override { return {310, 180}; }
    QSize minimumSizeHint() const override { return {200, 110}; }

  Q_SIGNALS:
    /// Changes have come that wait to be kept or discarded.
    void wanted();
    /// None waits any more.
    void settled();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void follow();
    void tint();
    void updateTexts();
    void showObject(const QModelIndex& row);

    RunChanges& m_changes;
    Document& m_document;
    Canvas& m_canvas;
    bool m_wereWaiting = false;
    bool m_wereTold = false; // of those that wait, or that undo has put into the level again

    QVBoxLayout m_column;
    QLabel m_title;
    RunChangesView m_view;
    RunChangesList m_list;
    QHBoxLayout m_buttons;
    QPushButton m_keepAll, m_keepTicked, m_discard;
    int m_listener = 0;
};

} // namespace spacetow
