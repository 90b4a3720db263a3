#pragma once
// A table of the exact coordinates of the nodes in edit. Rows that are selected are the selected nodes, both ways.

#include "editor/panels/fault_label.h"
#include "editor/panels/nodes_delegate.h"
#include "editor/panels/nodes_model.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class NodesPanel : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the panel.
    explicit NodesPanel(Document& document, QWidget* parent = nullptr);
    ~NodesPanel() override;

    /// Makes a sentence of a code of core/base/expression.
    void setWords(const std::function<QString(const Error&)>& words) { m_delegate.words = words; }
    QTableView& table() { return m_table; }
    const NodesModel& model() const { return m_model; }

    QSize sizeHint() const override { return {310, 200}; }
    QSize minimumSizeHint() const override { return {180, 90}; }

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    void showSelection();
    void takeSelection();
    bool editByKey(const QKeyEvent& key);
    bool editSeveral(const QMouseEvent& mouse);
    void insertNode();
    void removeSelectedNodes();

    Document& m_document;
    NodesModel m_model;
    NodesDelegate m_delegate;
    QVBoxLayout m_column;
    QHBoxLayout m_buttons;
    QTableView m_table;
    FaultLabel m_fault;
    QToolButton m_insert, m_remove;
    std::vector<NodeRef> m_selectedBefore; // when the mouse was pressed
    int m_listener = 0;
    bool m_showing = false; // rows are being selected to show the document's selection
};

} // namespace spacetow
