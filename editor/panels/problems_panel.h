#pragma once
// What lint finds in the level, looked for anew shortly after each edit. A click leads to the object.

#include "core/level/problem.h"
#include "editor/editing/document.h"

#include <QListWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <vector>

namespace spacetow {

class ProblemsPanel : public QWidget {
    Q_OBJECT

  public:
    using Sentence = std::function<QString(const Problem&)>;

    /// The document must outlive the panel.
    ProblemsPanel(Document& document, Sentence sentence, QWidget* parent = nullptr);
    ~ProblemsPanel() override;

    const std::vector<Problem>& problems() const { return m_problems; }
    int errors() const;
    int warnings() const;
    /// Goes to the problem before or after the current one, round and round.
    void go(int by);
    /// At once instead of shortly.
    void check();
    /// Draws the marks in colours that are read on the palette.
    void tint();

    QSize sizeHint() const override { return {310, 150}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

  Q_SIGNALS:
    void problemsChanged();
    /// The user wants to see this object; 0 for the level itself.
    void objectWanted(spacetow::Key key);

  private:
    void fill();
    void choose(int row);

    Document& m_document;
    Sentence m_sentence;
    QVBoxLayout m_column;
    QListWidget m_list;
    QTimer m_soon;
    std::vector<Problem> m_problems;
    std::shared_ptr<const Level> m_checked;
    int m_listener = 0;
};

} // namespace spacetow
