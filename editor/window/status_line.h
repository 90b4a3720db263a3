#pragma once
// The bottom line: on the left what the mouse and the keys do right now, on the right where the pointer is, what is
// selected, how points snap, the zoom and how many problems there are.

#include "core/math/aabb.h"
#include "editor/editing/snap.h"
#include "editor/window/zoom_field.h"

#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>

#include <memory>
#include <vector>

namespace spacetow {

class StatusLine : public QStatusBar {
    Q_OBJECT

  public:
    explicit StatusLine(QWidget* parent = nullptr);
    ~StatusLine() override;

    void setHint(const QString& sentence);
    void setPointer(double x, double y, int decimals = 2); // m
    void clearPointer();
    /// The box of what is selected, in metres; empty when it has no extent.
    void setSelection(int count, const Aabb& box);
    void setSnap(const SnapSettings& snap);
    void setZoom(double zoom); // 1 is the original size
    void setProblems(int errors, int warnings);
    /// How fast what runs is shown; empty while nothing runs.
    void setPace(const QString& pace);
    QString pace() const { return m_pace.text(); }
    /// Without a board that is drawn on, nothing is said about one.
    void setBoardShown(bool shown);

    QString hint() const { return m_hint; }
    /// The distances at which points may snap.
    QMenu& stepMenu() { return m_steps; }
    /// The parts into which a step may be divided.
    QMenu& divisionMenu() { return m_divisions; }
    /// Opens from the button that shows how points snap; must outlive this line or be gone before it is clicked.
    void setSnapMenu(QMenu& menu) { m_snap.setMenu(&menu); }

  Q_SIGNALS:
    void stepChosen(double metres);
    void divisionChosen(int parts);
    void zoomChosen(double zoom);
    void left(); // done with typing here
    void problemsClicked();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void elide();
    /// Leaves out what matters least where there is no room for everything.
    void fit();
    void dressButton(QToolButton& button);
    void fillSteps();
    void fillDivisions();

    QString m_hint;
    QLabel m_hintLabel;
    QLabel m_pointer;
    QLabel m_selection;
    QLabel m_pace;
    QMenu m_steps;
    QActionGroup m_stepGroup;
    std::vector<std::unique_ptr<QAction>> m_stepActions;
    QMenu m_divisions;
    QActionGroup m_divisionGroup;
    std::vector<std::unique_ptr<QAction>> m_divisionActions;
    QToolButton m_snap;
    ZoomField m_zoom;
    QToolButton m_problems;
    QString m_selectionCount; // "3 selected"
    QString m_selectionSize;  // ", 2.00 × 1.00 m"
    bool m_boardShown = true;
    int m_errors = 0;
    int m_warnings = 0;
};

} // namespace spacetow
