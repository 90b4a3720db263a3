#pragma once
// A bar above the canvas for a file that is being imported: it shows on the canvas what would come, while scale,
// tolerance and the rest are being changed, and says what is left out. The work is done beside the window. What else is
// done to the level meanwhile closes it.

#include "editor/canvas/background_task.h"
#include "editor/editing/toolbox.h"
#include "editor/exchange/import.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/number_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/panels/wrapping_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <atomic>
#include <memory>
#include <optional>

namespace spacetow {

class ImportBar : public QWidget {
    Q_OBJECT

  public:
    /// Both must outlive the bar.
    ImportBar(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~ImportBar() override;

    /// Makes sentences of codes.
    void setWords(const std::function<QString(const Error&)>& words);
    /// Where the middle of the view is, m.
    void setMiddle(std::function<Vec2()> middle) { m_middle = std::move(middle); }

    void begin(const QString& path);
    bool isOpen() const { return m_context.has_value(); }
    /// One history entry, as soon as what is shown is up to date.
    void apply();
    void cancel();
    /// Waits for the work that is being done.
    void finishWork();

    /// What is said of the file: how much it is, or why it is none.
    QString summary() const { return m_summary.text(); }
    /// What is not taken over, one a line.
    const QStringList& report() const { return m_lines; }

  Q_SIGNALS:
    void closed();
    /// What would come is shown for the first time.
    void appeared(const Aabb& box);
    void imported(const QString& name, const QStringList& report);
    void refused(const QString& path, const spacetow::Error& why);

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    struct Outcome;

    void layOut();
    void layOutFields();
    ImportOptions options() const;
    void refresh();
    void start();
    void take(Outcome outcome);
    void show(const Outcome& outcome);
    void say(const std::vector<Error>& notes);
    void shut();

    Document& m_document;
    Toolbox& m_toolbox;
    int m_connection = 0;
    bool m_updating = false;
    std::function<QString(const Error&)> m_words;
    std::function<Vec2()> m_middle;

    std::optional<ToolContext> m_context; // while open
    QString m_path;
    Vec2 m_place{0, 0};                       // the middle of the view when it began
    std::shared_ptr<const Drawing> m_drawing; // of the file, once it has been read
    std::optional<Edit> m_edit;               // what is shown
    int m_count = 0;                          // of objects in it
    QStringList m_lines;
    bool m_isStale = false;  // options have changed since the work began
    bool m_isWanted = false; // to be imported as soon as it is there
    bool m_hasAppeared = false;

    std::stop_source m_stop;
    std::atomic<int> m_percent = 0;
    BackgroundTask m_task;
    QTimer m_tick;

    QVBoxLayout m_column;
    QHBoxLayout m_top;
    WrappingRow m_fields, m_choices;
    QLabel m_title, m_summary, m_report;
    QProgressBar m_progress;
    NumberField m_scale, m_tolerance;
    ScrubLabel m_scaleLabel, m_toleranceLabel; // after the fields that they drag
    QComboBox m_walls, m_fills;
    QCheckBox m_layer, m_center;
    QToolButton m_apply, m_cancel;
    FaultLabel m_fault;
};

} // namespace spacetow
