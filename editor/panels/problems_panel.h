#pragma once
// What lint finds in the level, looked for anew shortly after each edit, by a thread beside the window. A click leads
// to the object; what can be cured is cured by a button, and what is not to be seen is hidden.

#include "core/level/problem_place.h"
#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"
#include "editor/panels/problem_delegate.h"
#include "editor/panels/problem_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <array>
#include <vector>

class QMenu;

namespace spacetow {

class ProblemsPanel : public QWidget {
    Q_OBJECT

  public:
    using Marks = std::vector<ProblemMark>;

    /// The document must outlive the panel. `words` say what fixes are called.
    ProblemsPanel(Document& document, ProblemList::Sentence sentence, ProblemList::Words words = {},
                  QWidget* parent = nullptr);
    ~ProblemsPanel() override;

    /// All of them, those that are hidden or filtered out among them.
    const std::vector<Problem>& problems() const { return m_problems.problems(); }
    /// Where those are that are not hidden; never null.
    const std::shared_ptr<const Marks>& marks() const { return m_marks; }
    /// That of the current row; null for none.
    const Problem* currentProblem() const;
    /// Its place among all; −1 for none.
    int current() const { return m_problems.problemAt(m_list.currentIndex().row()); }
    /// Of what is not hidden.
    int errors() const { return m_problems.count(Severity::Error); }
    int warnings() const { return m_problems.count(Severity::Warning); }
    const ProblemFilter& filter() const { return m_problems.filter(); }
    void setFilter(const ProblemFilter& filter);

    /// Those that are not hidden.
    std::vector<Problem> shown() const;
    /// Goes to this problem, which is one of another moment if it is no longer there.
    void goTo(const Problem& problem);
    /// Goes to the problem before or after the current one, round and round.
    void go(int by);
    /// At once instead of shortly; waits for what is found.
    void check();
    /// Carries out the fix of the current row's problem, if it has one.
    void fixCurrent();
    /// All that are safe, beside the window.
    void fixAll();
    /// The current row's problem, or shown again.
    void hideCurrent();
    /// How many could be cured by fixAll.
    int safeFixes() const { return m_safe; }
    bool canFixCurrent() const;
    /// Fills the menu of a row.
    void fillMenu(QMenu& menu);

    /// Draws the marks in colours that are read on the palette.
    void tint();

    QSize sizeHint() const override { return {310, 150}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

  Q_SIGNALS:
    void problemsChanged();
    /// Other marks, or another problem is the current one.
    void marksChanged();
    /// The user wants to see this object; 0 for the level itself.
    void objectWanted(spacetow::Key key);
    /// And this place of it; see placeOf. Comes after objectWanted.
    void placeWanted(const std::vector<spacetow::Vec2>& place);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Found {
        std::vector<Problem> problems;
        std::shared_ptr<const Marks> marks;
    };

    void layOut();
    void listen();
    void checkBeside();
    void take(const std::shared_ptr<const Level>& level, Found found);
    void note();
    void countAll();
    void choose(const QModelIndex& row);
    void showMenu(const QPoint& position);

    Document& m_document;
    ProblemList m_problems;
    ProblemDelegate m_delegate;
    QVBoxLayout m_column;
    QHBoxLayout m_row;
    std::array<QToolButton, 3> m_severities; // by Severity
    QToolButton m_hidden;
    QLabel m_note; // instead of rows, or while checking takes its time
    QListView m_list;
    QPushButton m_fixAll;
    QTimer m_soon;
    QTimer m_slow; // since a check began
    std::shared_ptr<const Level> m_checked;
    std::shared_ptr<const Marks> m_marks = std::make_shared<Marks>();
    int m_safe = 0;
    int m_steps = 0; // to go once the level has been checked
    int m_listener = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
