#include "editor/window/disk_changes.h"

#include <QFileInfo>
#include <QGuiApplication>

#include <utility>

namespace spacetow {

namespace {

constexpr int settleTime = 100; // ms
constexpr int busyTime = 300;   // ms, after which to try again
constexpr int fadeTime = 10000; // ms

} // namespace

DiskChanges::DiskChanges(Document& document, Files& files) : m_document(document), m_files(files) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(settleTime);
    connect(&m_soon, &QTimer::timeout, this, &DiskChanges::look);
    m_fading.setSingleShot(true);
    m_fading.setInterval(fadeTime);
    connect(&m_fading, &QTimer::timeout, this, &DiskChanges::dismiss);
    const auto lookSoon = [this] {
        if (!m_soon.isActive()) { // a busy folder would put it off for ever
            m_soon.start();
        }
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, lookSoon);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, lookSoon);
    // Some file systems tell nothing.
    if (auto* application = qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        connect(application, &QGuiApplication::applicationStateChanged, this, lookSoon);
    }
    const auto anew = [this] {
        m_gone = false;
        m_told = {};
        watch();
        dismiss();
    };
    m_listeners = {m_files.changed.connect([this] { watch(); }), m_files.opened.connect(anew),
                   m_files.saved.connect(anew), m_files.conflict.connect([this] { saveRefused(); })};
    watch();
}

DiskChanges::~DiskChanges() {
    m_files.changed.disconnect(m_listeners[0]);
    m_files.opened.disconnect(m_listeners[1]);
    m_files.saved.disconnect(m_listeners[2]);
    m_files.conflict.disconnect(m_listeners[3]);
}

/// The folders as well: many programs write another file and rename it.
void DiskChanges::watch() {
    const QFileInfo file(m_files.path());
    QStringList wanted;
    if (!m_files.path().isEmpty()) {
        wanted << file.filePath() << file.path() << QFileInfo(file.canonicalFilePath()).path();
        wanted.removeDuplicates();
    }
    const QStringList present = m_watcher.files() + m_watcher.directories();
    for (const QString& path : present) {
        if (!wanted.contains(path)) {
            m_watcher.removePath(path);
        }
    }
    for (const QString& path : std::as_const(wanted)) {
        if (!present.contains(path) && QFileInfo::exists(path)) {
            m_watcher.addPath(path);
        }
    }
}

void DiskChanges::look() {
    const QString path = m_files.path();
    if (path.isEmpty()) {
        return;
    }
    if (m_task.isRunning()) {
        m_again = true;
        return;
    }
    watch(); // a file that was replaced is no longer watched
    const FileState known = m_files.disk();
    m_task.start([this, path, known](const std::stop_token&) -> BackgroundTask::Then {
        const FileState now = fileState(path.toStdString(), known);
        auto file = std::make_shared<std::optional<LevelFile>>();
        if (now.exists() && !now.sameContent(known)) {
            Result<LevelFile> found = readLevel(path.toStdString(), Checks::FileOnly);
            if (found) {
                *file = std::move(found).value();
            }
        }
        return [this, path, known, now, file] { conclude(path, known, now, std::move(*file)); };
    });
}

void DiskChanges::conclude(const QString& path, const FileState& known, const FileState& now,
                           std::optional<LevelFile> file) {
    const bool outdated = path != m_files.path() || known.stamp != m_files.disk().stamp;
    if (std::exchange(m_again, false) || outdated) {
        m_soon.start();
    }
    if (outdated) {
        return;
    }
    if (!now.exists()) {
        gone();
    } else if (!now.sameContent(known)) {
        changed(now, std::move(file));
    } else {
        m_files.setDisk(now); // what else may be new of it need not be asked again
        m_told = {};
        if (std::exchange(m_gone, false)) {
            m_document.setSavedGone(false);
            dismiss();
        }
    }
}

void DiskChanges::gone() {
    if (m_files.disk().exists() && !std::exchange(m_gone, true)) {
        m_told = {};
        m_document.setSavedGone(true);
        say(MessageBar::Tone::Warning,
            tr("%1 is no longer there: it was deleted, moved or renamed. Your level is still here.")
                .arg(m_files.name()),
            {{tr("Save Again"), [this] { m_files.overwrite(); }}, {tr("Save As…"), [this] { m_files.saveAs(); }}});
    }
}

void DiskChanges::changed(const FileState& now, std::optional<LevelFile> file) {
    if (isBusy && isBusy()) {
        m_soon.start(busyTime);
        return;
    }
    if (std::exchange(m_gone, false)) {
        m_document.setSavedGone(false);
    }
    if (now.sameContent(m_told)) {
        return;
    }
    const bool readable = file && file->level;
    if (readable && !m_document.isModified()) {
        m_files.takeFromDisk(std::move(*file->level), now);
        say(MessageBar::Tone::Info,
            tr("%1 was changed by another program and has been loaded anew. Undo takes that back.")
                .arg(m_files.name()));
        m_fading.start();
        return;
    }
    m_told = now;
    if (readable) {
        say(MessageBar::Tone::Warning,
            tr("%1 was changed by another program, and you have changed it here.").arg(m_files.name()),
            {reloadChoice(), keepChoice(now), compareChoice()});
    } else {
        m_document.setSavedGone(true);
        say(MessageBar::Tone::Warning,
            tr("%1 was changed by another program and cannot be read any more. Your level is still here.")
                .arg(m_files.name()),
            {keepChoice(now), {tr("Save As…"), [this] { m_files.saveAs(); }}});
    }
}

void DiskChanges::saveRefused() {
    m_told = fileState(m_files.path().toStdString(), m_files.disk());
    say(MessageBar::Tone::Warning,
        tr("Not saved: %1 was changed by another program since you opened it, and saving would overwrite that.")
            .arg(m_files.name()),
        {{tr("Overwrite"), [this] { m_files.overwrite(); }}, reloadChoice(), compareChoice()});
}

MessageBar::Choice DiskChanges::reloadChoice() {
    return {tr("Reload"), [this] {
                dismiss();
                m_files.reload();
            }};
}

MessageBar::Choice DiskChanges::keepChoice(const FileState& now) {
    return {tr("Keep Mine"), [this, now] {
                m_files.setDisk(now);
                m_document.setSavedGone(true);
                dismiss();
            }};
}

MessageBar::Choice DiskChanges::compareChoice() {
    return {tr("Compare"), [this] {
                const Result<LevelFile> file = readLevel(m_files.path().toStdString(), Checks::FileOnly);
                if (file && file.value().level && compare) {
                    m_comparing = true;
                    compare(std::make_shared<const Level>(*file.value().level), m_files.name());
                } else {
                    look();
                }
            }};
}

void DiskChanges::say(MessageBar::Tone tone, const QString& text, std::vector<MessageBar::Choice> choices) {
    m_fading.stop();
    m_notice = Notice{tone, text, std::move(choices)};
    noticed.emit();
}

void DiskChanges::dismiss() {
    m_fading.stop();
    if (std::exchange(m_comparing, false)) {
        compare(nullptr, {});
    }
    if (m_notice) {
        m_notice.reset();
        noticed.emit();
    }
}

} // namespace spacetow
