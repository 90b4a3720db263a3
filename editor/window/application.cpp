#include "editor/window/application.h"

#include "editor/window/dropped_files.h"
#include "editor/window/language.h"
#include "editor/window/main_window.h"

#include <QFileInfo>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr std::size_t maxClosed = 10;
constexpr QPoint cascade(32, 32); // pixels from one window to the next
constexpr QPoint frame(16, 48);   // pixels that the desktop puts around a window, at most

/// The same for all names of a file.
QString identity(const QString& path) {
    const QFileInfo file(path);
    const QString canonical = file.canonicalFilePath(); // empty for a file that is gone
    return canonical.isEmpty() ? file.absoluteFilePath() : canonical;
}

} // namespace

Application::Application() = default;

Application::~Application() {
    m_quitting = true; // nothing of what goes now is to be remembered as closed
    m_windows.clear();
}

std::vector<MainWindow*> Application::windows() const {
    std::vector<MainWindow*> all;
    for (const auto& window : m_windows) {
        all.push_back(window.get());
    }
    return all;
}

void Application::start(const QStringList& files) {
    if (files.isEmpty() && Preferences().restoresWindows()) {
        restoreWindows();
    }
    if (!m_windows.empty()) {
        return;
    }
    MainWindow& first = add(nullptr, nullptr);
    if (files.isEmpty() && Preferences().welcomes()) {
        first.showWelcome();
    }
    first.comeForward();
    openDropped(files, first);
}

void Application::restoreWindows() {
    m_left = rememberedWindows();
    restoreNext();
}

void Application::restoreNext() {
    while (!m_quitting && m_arriving == nullptr && !m_left.empty()) {
        const RememberedWindow remembered = m_left.front();
        m_left.erase(m_left.begin());
        if (QFileInfo::exists(remembered.path)) {
            restore(remembered);
        } else {
            m_gone << remembered.path;
        }
    }
    if (isRestoring() || m_windows.empty()) {
        return;
    }
    remember();
    if (!m_gone.isEmpty()) {
        m_windows.front()->messageBar().say(MessageBar::Tone::Info,
                                            MainWindow::tr("Was open at the end of the last run, but is gone: %1")
                                                .arg(std::exchange(m_gone, {}).join(QStringLiteral(", "))));
    }
}

void Application::restore(const RememberedWindow& remembered) {
    const MainWindow* const same = showing(remembered.path);
    MainWindow& window = add(same != nullptr ? same->openLevel() : nullptr, nullptr);
    window.restoreGeometry(remembered.geometry);
    window.restoreState(remembered.arrangement);
    window.show();
    if (same != nullptr) {
        showView(window, remembered.view);
        return;
    }
    m_arriving = &window;
    window.fileReader().read({remembered.path}, [this, &window, remembered](const std::vector<FileToOpen>& files) {
        m_arriving = nullptr;
        // Not in place of what has been opened there meanwhile.
        if (MainWindow* const there = files.empty() ? nullptr : open(files.front(), window)) {
            showView(*there, remembered.view);
        }
        restoreNext();
    });
}

MainWindow& Application::add(std::shared_ptr<OpenLevel> level, const MainWindow* beside) {
    MainWindow& window = *m_windows.emplace_back(std::make_unique<MainWindow>(std::move(level), this));
    connect(&window, &MainWindow::closing, this, [this, &window] { closed(window); });
    connect(&window, &MainWindow::fileChanged, this, [this, &window] {
        tellApart(window);
        remember();
    });
    tellApart(window);
    if (beside != nullptr) {
        window.restoreState(beside->panels().arrangement());
        window.setWindowState(Qt::WindowNoState);
        window.resize(beside->isMaximized() || beside->isFullScreen() ? beside->normalGeometry().size()
                                                                      : beside->size());
        window.move(m_windows[m_windows.size() - 2]->pos() + cascade); // beside the newest, or many would be one
        if (const QScreen* monitor = beside->screen()) {               // rather smaller than beyond its border
            const QPoint room = monitor->availableGeometry().bottomRight() - frame - window.pos();
            window.resize(window.size().boundedTo({room.x(), room.y()}).expandedTo(window.minimumSizeHint()));
        }
    }
    return window;
}

/// Gives the level another number when one that was there before, without a file either, is called the same.
void Application::tellApart(const MainWindow& window) {
    OpenLevel& level = *window.openLevel();
    const auto isTaken = [&](const QString& name) {
        return std::ranges::any_of(m_windows, [&](const std::unique_ptr<MainWindow>& other) {
            const OpenLevel& there = *other->openLevel();
            return &there != &level && there.files.path().isEmpty() && there.files.name() == name;
        });
    };
    if (!level.files.path().isEmpty() || !isTaken(level.files.name())) {
        return;
    }
    int number = 1;
    while (isTaken(level.files.untitled(number))) {
        ++number;
    }
    level.files.setNumber(number);
}

MainWindow& Application::newWindow(const MainWindow* beside) {
    MainWindow& window = add(nullptr, beside);
    window.comeForward();
    return window;
}

MainWindow& Application::newView(const MainWindow& of) {
    MainWindow& window = add(of.openLevel(), &of);
    window.comeForward();
    showView(window, viewOf(of));
    remember();
    return window;
}

MainWindow* Application::showing(const QString& path) const {
    const QString wanted = identity(path);
    for (const auto& window : m_windows) {
        const QString shown = window->files().path();
        if (!shown.isEmpty() && identity(shown) == wanted) {
            return window->openLevel()->front();
        }
    }
    return nullptr;
}

/// Not on the screen yet where it is a new one.
MainWindow& Application::roomFor(MainWindow& from) {
    const bool free = from.openLevel()->isUntouched() && from.openLevel()->views().size() == 1 && !from.isPlaying();
    return free ? from : add(nullptr, &from);
}

MainWindow& Application::roomToRestore(const QString& path, MainWindow& from) {
    MainWindow* const there = path.isEmpty() ? nullptr : showing(path);
    return there != nullptr && !there->document().isModified() ? *there : roomFor(from);
}

void Application::startNew(MainWindow& from) {
    MainWindow& window = roomFor(from);
    if (&window == &from) {
        window.files().startNew();
    }
    window.comeForward();
}

void Application::openAll(const std::vector<FileToOpen>& files, MainWindow& from) {
    MessageBar& bar = from.messageBar();
    if (files.size() == 1) {
        bar.dismiss();
        open(files.front(), from); // what is said of it may offer a way out
        return;
    }
    QStringList said;
    MessageBar::Tone worst = MessageBar::Tone::Info;
    for (const FileToOpen& file : files) {
        bar.dismiss();
        open(file, from);
        if (!bar.text().isEmpty()) {
            said << bar.text();
            worst = std::max(worst, bar.tone());
        }
    }
    if (!said.isEmpty()) {
        bar.say(worst, said.join(QLatin1Char('\n')));
    }
}

MainWindow* Application::open(const FileToOpen& file, MainWindow& from) {
    if (MainWindow* const there = showing(file.path)) {
        there->comeForward();
        return there;
    }
    MainWindow& window = roomFor(from);
    if (window.open(file)) {
        window.comeForward();
        return &window;
    }
    if (&window != &from) {
        std::vector<MessageBar::Choice> choices;
        if (!window.messageBar().buttons().empty()) {
            const QString path = QFileInfo(file.path).absoluteFilePath();
            choices = Files::backupChoices(path, [this, path, &from] {
                MainWindow& room = roomFor(from);
                room.files().openNewestBackup(path);
                room.comeForward();
            });
        }
        from.messageBar().say(window.messageBar().tone(), window.messageBar().text(), choices);
        m_windows.pop_back(); // the one that nobody has seen
    }
    return nullptr;
}

void Application::showNext(const MainWindow& from) {
    const auto found = std::ranges::find(m_windows, &from, &std::unique_ptr<MainWindow>::get);
    const auto next = found == m_windows.end() || found + 1 == m_windows.end() ? m_windows.begin() : found + 1;
    (*next)->comeForward();
}

void Application::showWelcome(MainWindow& from) {
    const std::vector<MainWindow*> all = windows();
    const auto shown = std::ranges::find_if(all, &MainWindow::isWelcoming);
    MainWindow& window = shown != all.end() ? **shown : roomFor(from);
    window.showWelcome();
    window.comeForward();
}

void Application::close(MainWindow& window) {
    if (m_windows.size() > 1 || window.isWelcoming() || !Preferences().welcomes()) {
        window.close();
    } else if (window.mayClose()) {
        keepClosed(window);
        window.stopPlaying();
        window.fileReader().leave();
        window.files().startOver();
        window.showWelcome();
    }
}

void Application::reopenClosed(MainWindow& from) {
    if (m_closed.empty()) {
        return;
    }
    const Closed last = std::move(m_closed.back());
    m_closed.pop_back();
    const auto show = [last](MainWindow& window) {
        showView(window, last.view);
        window.actions().refresh();
    };
    if (last.path.isEmpty()) {
        MainWindow& window = roomFor(from);
        window.files().startNew();
        window.comeForward();
        window.document().commit({"reopen"}, {last.level, {}}); // not saved anywhere, and shown as that
        show(window);
        return;
    }
    from.fileReader().read({last.path}, [this, show, last, &from](const std::vector<FileToOpen>& files) {
        if (files.empty()) {
            m_closed.push_back(last); // its reading was left
            return;
        }
        MainWindow* const window = open(files.front(), from);
        if (window != nullptr) {
            show(*window);
        }
    });
}

void Application::keepClosed(const MainWindow& window) {
    const OpenLevel& level = *window.openLevel();
    const QString path = level.files.path();
    if (level.views().size() > 1 || (path.isEmpty() && level.isUntouched())) {
        return;
    }
    m_closed.push_back({path, path.isEmpty() ? level.document.current().level : nullptr, viewOf(window)});
    if (m_closed.size() > maxClosed) {
        m_closed.erase(m_closed.begin());
    }
}

void Application::closed(MainWindow& window) {
    window.fileReader().leave();
    keepClosed(window);
    const auto found = std::ranges::find(m_windows, &window, &std::unique_ptr<MainWindow>::get);
    if (found == m_windows.end()) {
        return;
    }
    const bool last = m_windows.size() == 1;
    if (last && !m_quitting) {
        remember(); // the program ends with it, and begins with it
    }
    window.openLevel()->remove(window); // from now on the others are asked
    found->release()->deleteLater();    // it is in the middle of being closed
    m_windows.erase(found);
    if (!last && !m_quitting) {
        remember();
    }
}

void Application::remember() const {
    if (!m_quitting && !isRestoring() && !m_windows.empty()) {
        rememberWindows(windows());
    }
}

void Application::setLanguage(const QString& code) {
    Preferences().setLanguage(code);
    for (MainWindow* const window : windows()) {
        window->stopPlaying();
        window->finishWork();
    }
    speak(code);
    for (MainWindow* const window : windows()) {
        replace(*window);
    }
}

/// By one that is made anew, with the same level, place and view.
void Application::replace(MainWindow& old) {
    old.fileReader().leave();
    const bool welcoming = old.isWelcoming();
    const bool active = old.isActiveWindow();
    MainWindow& window = add(old.openLevel(), nullptr);
    window.restoreGeometry(old.saveGeometry());
    window.restoreState(old.panels().arrangement());
    window.show();
    if (welcoming) {
        window.showWelcome();
    } else {
        showView(window, viewOf(old));
    }
    if (active) {
        window.activateWindow();
    }
    const auto found = std::ranges::find(m_windows, &old, &std::unique_ptr<MainWindow>::get);
    old.disconnect(this);
    old.openLevel()->remove(old);
    old.hide();
    found->release()->deleteLater(); // whose menu has called
    m_windows.erase(found);
}

bool Application::quit() {
    for (MainWindow* const window : windows()) {
        window->finishWork();
    }
    std::vector<const OpenLevel*> asked;
    for (MainWindow* const window : windows()) {
        OpenLevel& level = *window->openLevel();
        if (std::ranges::find(asked, &level) != asked.end()) {
            continue;
        }
        asked.push_back(&level);
        if (level.document.isModified() || level.runChanges.areWaiting()) {
            level.front()->comeForward();
        }
        if (!level.files.mayLeave()) {
            return false;
        }
    }
    remember();
    m_quitting = true;
    for (MainWindow* const window : windows()) {
        window->closeUnasked();
    }
    m_quitting = false;
    return true;
}

} // namespace spacetow
