#pragma once
// What is different from another level: a line for each object, a mark on the canvas, and a way to take single objects
// over as they are there. Follows the edits; looked for by a thread beside the window.

#include "editor/canvas/background_task.h"
#include "editor/canvas/canvas.h"
#include "editor/window/messages_compare.h"

#include <QAbstractListModel>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace spacetow {

class DifferenceList : public QAbstractListModel {
    Q_OBJECT

  public:
    using QAbstractListModel::QAbstractListModel;

    void setLines(std::vector<DifferenceLine> lines);
    const std::vector<DifferenceLine>& lines() const { return m_lines; }
    void setMarks(const MarkColors& colors, const QColor& selected);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    std::vector<DifferenceLine> m_lines;
    QIcon m_added, m_removed, m_changed;
};

class DifferencePanel : public QWidget {
    Q_OBJECT

  public:
    /// Document and canvas must outlive the panel.
    DifferencePanel(Document& document, Canvas& canvas, QWidget* parent = nullptr);
    ~DifferencePanel() override;

    /// `name` says what the other level is: "cave.json", "the version of 14:05".
    void compareWith(std::shared_ptr<const Level> other, const QString& name);
    /// Nothing is marked any more.
    void end();
    bool isComparing() const { return m_other != nullptr; }
    const std::vector<DifferenceLine>& lines() const { return m_list.lines(); }
    /// Waits for what is being looked for.
    void finish();
    /// The objects of the rows that are selected, as they are in the other level: one undo step.
    void takeOver();
    QSize sizeHint() const override { return {310, 180}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

  Q_SIGNALS:
    /// The user would like to choose a level to compare with.
    void levelWanted();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// Draws the marks in colours that are read on the palette.
    void tint();
    void lookBeside();
    void take(const std::shared_ptr<const Level>& level, std::vector<DifferenceLine> lines,
              std::shared_ptr<const ShownDifference> shown);
    void updateTexts();
    void showObject(const QModelIndex& row);
    std::vector<Key> selectedKeys() const;

    Document& m_document;
    Canvas& m_canvas;
    std::shared_ptr<const Level> m_other; // null while nothing is compared
    QString m_name;
    std::shared_ptr<const Level> m_looked; // for which the lines are

    QVBoxLayout m_column;
    QLabel m_title;
    QListView m_view;
    DifferenceList m_list;
    QHBoxLayout m_buttons;
    QPushButton m_choose, m_takeOver, m_end;
    QTimer m_soon;
    int m_listener = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
