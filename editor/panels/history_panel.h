#pragma once
// What has been done, by name. A click leads to the state after it, whatever the number of steps.

#include "editor/editing/toolbox.h"
#include "editor/panels/history_model.h"

#include <QListView>
#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class HistoryPanel : public QWidget {
    Q_OBJECT

  public:
    /// Document and toolbox must outlive the panel.
    HistoryPanel(Document& document, Toolbox& toolbox, HistoryModel::Words words, QWidget* parent = nullptr);
    ~HistoryPanel() override;

    HistoryModel& model() { return m_model; }
    QListView& list() { return m_list; }
    /// What the first row says, such as which file was opened.
    void setOrigin(const QString& text) { m_model.setOrigin(text); }

    QSize sizeHint() const override { return {310, 200}; }
    QSize minimumSizeHint() const override { return {180, 70}; }

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    void jump(const QModelIndex& index);

    Document& m_document;
    Toolbox& m_toolbox;
    HistoryModel m_model;
    QVBoxLayout m_column;
    QListView m_list;
    int m_listener = 0;
};

} // namespace spacetow
