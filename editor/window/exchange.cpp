#include "editor/window/exchange.h"

#include "core/base/whole_file.h"
#include "core/level/bounds.h"
#include "editor/canvas/export_picture.h"
#include "editor/panels/number_text.h"
#include "editor/window/messages.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace spacetow {

namespace {

constexpr double pictureMargin = 0.5; // m, round the level

/// Empty when it is done.
QString writtenBytes(const QString& path, const QByteArray& bytes) {
    if (bytes.isEmpty()) {
        return Exchange::tr("There is not enough memory for a picture of this size.");
    }
    const Result<FileStamp> written =
        writeFile(path.toStdU16String(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return written ? QString() : sentence(written.error());
}

} // namespace

ExchangeQuestions exchangeDialogs(QWidget* parent) {
    return {[parent](const QString& folder) {
                return QFileDialog::getOpenFileName(
                    parent, Exchange::tr("Import"), folder,
                    Exchange::tr("Drawings and maps (*.svg *.tmx *.tmj *.json);;All files (*)"));
            },
            [parent](const QString& suggestion) {
                QFileDialog dialog(parent, Exchange::tr("Export picture"), suggestion,
                                   Exchange::tr("PNG pictures (*.png);;SVG drawings (*.svg)"));
                dialog.setAcceptMode(QFileDialog::AcceptSave);
                dialog.setDefaultSuffix(QStringLiteral("png"));
                QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
                    dialog.setDefaultSuffix(filter.contains(QLatin1String("*.svg")) ? QStringLiteral("svg")
                                                                                    : QStringLiteral("png"));
                });
                dialog.selectFile(suggestion);
                return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
            }};
}

Exchange::Exchange(Document& document, Toolbox& toolbox, Canvas& canvas, Tell tell)
    : m_document(document), m_toolbox(toolbox), m_canvas(canvas), m_tell(std::move(tell)), m_import(document, toolbox) {
    const auto words = [](const Error& error) { return sentence(error); };
    m_import.setWords(words);
    m_export.setWords(words);
    m_import.setMiddle([this] { return m_canvas.view().center; });
    m_export.setMeasure([this](const ExportSettings& settings) { return sizeFor(settings); });
    connect(&m_import, &ImportBar::appeared, this, &Exchange::appear);
    connect(&m_import, &ImportBar::imported, this, &Exchange::tellImported);
    connect(&m_import, &ImportBar::refused, this, [this](const QString& path, const Error& why) {
        const QString name = QFileInfo(path).fileName();
        m_tell(MessageBar::Tone::Error, namesItsFile(why)
                                            ? sentence(why)
                                            : tr("%1 was not imported.").arg(name) + QLatin1Char('\n') + sentence(why));
    });
    connect(&m_import, &ImportBar::closed, &m_canvas, qOverload<>(&Canvas::setFocus));
    connect(&m_export, &ExportBar::closed, &m_canvas, qOverload<>(&Canvas::setFocus));
    connect(&m_export, &ExportBar::wanted, this, &Exchange::chooseAndExport);
}

bool Exchange::isForeign(const QString& path) {
    const QString end = QFileInfo(path).suffix().toLower();
    return end == QLatin1String("svg") || end == QLatin1String("svgz") || end == QLatin1String("tmx") ||
           end == QLatin1String("tmj");
}

void Exchange::chooseAndImport() {
    const QString path = questions.whichToImport(m_importFolder);
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void Exchange::importFile(const QString& path) {
    m_importFolder = QFileInfo(path).path();
    m_export.cancel();
    m_import.begin(QFileInfo(path).absoluteFilePath());
}

void Exchange::appear(const Aabb& box) {
    if (!box.isEmpty() && !m_canvas.view().visible().contains(box)) {
        m_canvas.setView(m_canvas.view().showing(box));
    }
}

void Exchange::tellImported(const QString& name, const QStringList& report) {
    constexpr int fewLines = 6;
    if (report.isEmpty()) {
        m_tell(MessageBar::Tone::Info, tr("%1 was imported as a whole.").arg(name));
        return;
    }
    QString text =
        tr("%1 was imported, but:").arg(name) + QLatin1Char('\n') + report.mid(0, fewLines).join(QLatin1Char('\n'));
    if (report.size() > fewLines) {
        text += QLatin1Char('\n') + tr("… and %1 more").arg(countText(report.size() - fewLines));
    }
    m_tell(MessageBar::Tone::Warning, text);
}

Aabb Exchange::areaFor(const ExportSettings& settings) const {
    const Aabb box = settings.wholeLevel ? boundsOf(*m_document.current().level) : m_canvas.view().visible();
    return settings.wholeLevel && !box.isEmpty() ? box.grown(pictureMargin) : box;
}

std::optional<QSize> Exchange::sizeFor(const ExportSettings& settings) const {
    return pictureSize(areaFor(settings), settings.pixelsPerMetre);
}

void Exchange::exportAs() {
    m_import.cancel();
    m_export.begin();
}

void Exchange::exportAgain() {
    if (m_exported.isEmpty() || !sizeFor(m_exportedAs)) {
        exportAs();
    } else {
        write();
    }
}

void Exchange::chooseAndExport() {
    const QString wish = suggestion ? suggestion() : QString();
    QString path = questions.whereToExport(m_exported.isEmpty() ? wish + QStringLiteral(".png") : m_exported);
    if (path.isEmpty()) {
        return;
    }
    path = QFileInfo(path).absoluteFilePath();
    if (!pictureFormat(path)) {
        path += QStringLiteral(".png");
    }
    m_exported = path;
    m_exportedAs = m_export.settings();
    write();
}

void Exchange::write() {
    m_task.finish(); // one at a time
    const std::optional<QSize> size = sizeFor(m_exportedAs);
    if (!size) {
        return;
    }
    PictureSpec spec;
    spec.view.center = areaFor(m_exportedAs).center();
    spec.view.scale = m_exportedAs.pixelsPerMetre;
    spec.view.size = Vec2(size->width(), size->height());
    spec.theme = &editingTheme(shadeOf(m_canvas.palette()));
    spec.transparent = m_exportedAs.transparent;
    spec.gridStep = m_exportedAs.grid ? m_toolbox.snap.fineStep() : 0;
    spec.title = QString::fromStdString(m_document.current().level->name);
    const PictureFormat format = pictureFormat(m_exported).value_or(PictureFormat::Png);
    m_task.start([this, format, spec, path = m_exported,
                  level = m_document.current().level](const std::stop_token&) -> BackgroundTask::Then {
        const QString wrong = writtenBytes(path, pictureBytes(format, *level, spec));
        return [this, wrong, path] {
            m_tell(wrong.isEmpty() ? MessageBar::Tone::Info : MessageBar::Tone::Error,
                   wrong.isEmpty() ? tr("The picture was written to %1.").arg(path) : wrong);
        };
    });
}

void Exchange::takeScreenshot() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    QDir().mkpath(folder);
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd hh-mm-ss-zzz"));
    const QString path = QDir(folder).filePath(QStringLiteral("SpaceTow Studio %1.png").arg(stamp));
    const QImage picture = m_canvas.grab().toImage();
    QByteArray bytes;
    QBuffer out(&bytes);
    out.open(QIODevice::WriteOnly);
    picture.save(&out, "PNG");
    const QString wrong = writtenBytes(path, bytes);
    m_tell(wrong.isEmpty() ? MessageBar::Tone::Info : MessageBar::Tone::Error,
           wrong.isEmpty() ? tr("The screenshot was written to %1.").arg(path) : wrong);
}

void Exchange::cancel() {
    m_import.cancel();
    m_export.cancel();
}

} // namespace spacetow
