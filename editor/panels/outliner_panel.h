#pragma once
// All objects of the level as a tree. Rows that are selected are the selected objects, both ways; a line above finds
// objects by words. Rows are dragged to another place in the drawing order or to another group.

#include "editor/panels/outliner_view.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>
#include <QWidget>

#include <set>
#include <span>
#include <vector>

class QAction;
class QMenu;

namespace spacetow {

class OutlinerPanel : public QWidget {
    Q_OBJECT

  public:
    /// Document and toolbox must outlive the panel.
    OutlinerPanel(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~OutlinerPanel() override;

    OutlinerModel& model() { return m_model; }
    OutlinerView& view() { return m_view; }
    QLineEdit& filterField() { return m_filter; }

    /// Buttons for them, below the tree.
    void addButtons(const QList<QAction*>& actions);
    /// Opens the name of the first selected object for editing.
    void renameSelected();
    /// Opens the name of this object for editing; a filter that hides it is taken away.
    void rename(Key key);
    /// What could be put into the filter; made for the level as it is.
    void fillFilterMenu(QMenu& menu);

    QSize sizeHint() const override { return {310, 260}; }
    QSize minimumSizeHint() const override { return {180, 110}; }

  Q_SIGNALS:
    void menuWanted(const QPoint& global);
    /// The user wants to see what is selected.
    void viewWanted();
    /// A sentence for the message bar.
    void said(const QString& sentence);

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeFilter();
    void refresh();
    void showSelection();
    void takeSelection();
    void applyFilter();
    void unfoldAgain();
    void flip(const QModelIndex& index);
    void chooseColor(const Object& group);
    void step(int by);
    void toggleTerm(const QString& term);

    Document& m_document;
    Toolbox& m_toolbox;
    OutlinerModel m_model;
    QVBoxLayout m_column;
    QHBoxLayout m_buttons;
    QLineEdit m_filter;
    QAction* m_choose = nullptr; // a button in the filter, which owns it
    OutlinerView m_view;
    std::set<Key> m_unfolded;     // groups, while nothing is filtered
    std::vector<Key> m_shownKeys; // selected in the tree
    bool m_hasNewRows = false;    // or others have moved; they may have to be selected
    bool m_showing = false;       // the tree is made to show the document
    int m_listener = 0;
};

} // namespace spacetow
