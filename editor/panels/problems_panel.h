#pragma once
// What lint finds in the level (see level_check.h). A click leads to the object; what can be cured is cured by a
// button, and what is not to be seen is hidden.

#include "editor/canvas/background_task.h"
#include "editor/panels/level_check.h"
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
    using Marks = LevelCheck::Marks;

    /// The check must outlive the panel. `words` say what fixes are called.
    ProblemsPanel(LevelCheck& check, ProblemList::Sentence sentence, ProblemList::Words words = {},
                  QWidget* parent = nullptr);

    /// All of them, those that are hidden or filtered out among them.
    const std::vector<Problem>& problems() const { return m_problems.problems(); }
    /// Where those are that are not hidden; never null.
    const std::shared_ptr<const Marks>& marks() const { return m_check.found().marks; }
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

    QSize sizeHint() const override { return {310, 150}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

  Q_SIGNALS:
    /// The user should hear of this.
    void said(const QString& text);
    void problemsChanged();
    /// Other marks, or another problem is the current one.
    void marksChanged();
    /// The user wants to see this object; 0 for the level itself.
    void objectWanted(spacetow::Key key);
    /// And this place of it; see placeOf. Comes after objectWanted.
    void placeWanted(const std::vector<spacetow::Vec2>& place);
    /// A problem of this object has been cured, which may have moved it; 0 for the level itself.
    void cured(spacetow::Key key);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void layOut();
    void listen();
    /// Draws the marks in colours that are read on the palette.
    void tint();
    void take();
    void showFound(const LevelCheck::Found& found);
    void note();
    void countAll();
    void choose(const QModelIndex& row);
    void showMenu(const QPoint& position);

    LevelCheck& m_check;
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
    QTimer m_slow; // since a check began
    std::shared_ptr<const Level> m_checked;
    int m_safe = 0;
    bool m_fixClicked = false; // with the click that is going on
    int m_steps = 0;           // to go once the level has been checked
    BackgroundTask m_fixing;   // last, so that it has ended before the rest goes
};

} // namespace spacetow
