#pragma once
// What can be found by typing: actions, panels, levels, objects and problems. What there are few of is gathered when
// the search is opened; objects and problems, of which there may be many, say what they are called when they are asked.

#include "core/level/problem.h"

#include <QIcon>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

class MainWindow;

enum class FindKind : std::uint8_t { Action, Panel, Level, Problem, Object };

struct FinderRow {
    FindKind kind;
    QString name;
    QString place;       // where it is found otherwise: a menu, a folder
    QString key = {};    // as it is printed on keyboards
    QString tip = {};    // a sentence
    QString code = {};   // by which it is remembered; empty: it is not
    QString whyNot = {}; // a sentence, while it is not possible
    QIcon icon = {};
    bool isOn = false; // for a switch
    bool isPossible = true;
    std::function<void()> run;
};

class FinderRows {
  public:
    /// The window must outlive this.
    explicit FinderRows(MainWindow& window);

    int size() const { return few() + problemCount() + objectCount(); }
    /// Actions, panels and levels; they come first.
    int few() const { return static_cast<int>(m_few.size()); }
    FindKind kind(int row) const;
    /// What is searched; the name comes first.
    QString text(int row) const;
    FinderRow row(int row) const;
    /// Of those that are remembered.
    std::optional<int> withCode(const QString& code) const;

  private:
    void addActions();
    void addPanels();
    void addEntries();
    void addLevels();
    void addLevel(const QString& path, const QString& place);
    int problemCount() const { return static_cast<int>(m_problems.size()); }
    int objectCount() const { return m_level->objects.size(); }
    FinderRow problemRow(const Problem& problem) const;
    FinderRow objectRow(const Object& object) const;

    MainWindow& m_window;
    std::shared_ptr<const Level> m_level;
    std::vector<Problem> m_problems;
    std::vector<QString> m_kinds; // names of the kinds of objects
    std::vector<FinderRow> m_few;
};

} // namespace spacetow
