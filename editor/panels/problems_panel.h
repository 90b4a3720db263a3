#pragma once
// What lint finds in the level, looked for anew shortly after each edit, by a thread beside the window. A click leads
// to the object.

#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"
#include "editor/panels/problem_list.h"

#include <QLabel>
#include <QListView>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include <vector>

namespace spacetow {

class ProblemsPanel : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the panel.
    ProblemsPanel(Document& document, ProblemList::Sentence sentence, QWidget* parent = nullptr);
    ~ProblemsPanel() override;

    const std::vector<Problem>& problems() const { return m_problems.problems(); }
    int errors() const;
    int warnings() const;
    /// Goes to the problem before or after the current one, round and round.
    void go(int by);
    /// At once instead of shortly; waits for what is found.
    void check();
    /// Draws the marks in colours that are read on the palette.
    void tint();

    QSize sizeHint() const override { return {310, 150}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

  Q_SIGNALS:
    void problemsChanged();
    /// The user wants to see this object; 0 for the level itself.
    void objectWanted(spacetow::Key key);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void checkBeside();
    void take(const std::shared_ptr<const Level>& level, std::vector<Problem> problems);
    void note();
    void choose(const QModelIndex& row);

    Document& m_document;
    ProblemList m_problems;
    QVBoxLayout m_column;
    QLabel m_note; // instead of rows, or while checking takes its time
    QListView m_list;
    QTimer m_soon;
    QTimer m_slow; // since a check began
    std::shared_ptr<const Level> m_checked;
    int m_listener = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
