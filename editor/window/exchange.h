#pragma once
// Import and export of the window: which file, what became of it, and the bars in which it is set up. Files are asked
// for through functions, so that tests can answer.

#include "editor/canvas/background_task.h"
#include "editor/canvas/canvas.h"
#include "editor/panels/export_bar.h"
#include "editor/panels/import_bar.h"
#include "editor/window/message_bar.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace spacetow {

struct ExchangeQuestions {
    std::function<QString(const QString& folder)> whichToImport;     // empty: none
    std::function<QString(const QString& suggestion)> whereToExport; // empty: nowhere
};

/// Asks with the dialogs of the desktop.
ExchangeQuestions exchangeDialogs(QWidget* parent);

class Exchange : public QObject {
    Q_OBJECT

  public:
    using Tell = std::function<void(MessageBar::Tone, const QString&)>;

    /// All must outlive this.
    Exchange(Document& document, Toolbox& toolbox, Canvas& canvas, Tell tell);

    ExchangeQuestions questions;
    /// Folder and name, without the end, to suggest for a picture.
    std::function<QString()> suggestion;

    ImportBar& importBar() { return m_import; }
    ExportBar& exportBar() { return m_export; }

    /// By the end of its name: a file that is imported rather than opened, unless its content says otherwise.
    static bool isForeign(const QString& path);
    void chooseAndImport();
    void importFile(const QString& path);

    void exportAs();
    /// To the same file, with the same settings, as the last time; asks when there was none.
    void exportAgain();
    /// What the canvas shows, as a PNG among the user's pictures.
    void takeScreenshot();
    /// Waits for the picture that is being written.
    void finishWork() { m_task.finish(); }

    /// Ends what is being set up, without doing it.
    void cancel();

  private:
    void tellImported(const QString& name, const QStringList& report);
    void appear(const Aabb& box);
    void chooseAndExport();
    void write();
    Aabb areaFor(const ExportSettings& settings) const;
    std::optional<QSize> sizeFor(const ExportSettings& settings) const;

    Document& m_document;
    Toolbox& m_toolbox;
    Canvas& m_canvas;
    Tell m_tell;
    ImportBar m_import;
    ExportBar m_export;
    BackgroundTask m_task;
    QString m_importFolder;
    QString m_exported; // path of the last picture
    ExportSettings m_exportedAs;
};

} // namespace spacetow
