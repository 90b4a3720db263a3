#include "editor/window/open_level.h"

#include "editor/window/main_window.h"
#include "editor/window/messages.h"
#include "editor/window/state_folder.h"

#include <algorithm>

namespace spacetow {

OpenLevel::OpenLevel()
    : runChanges(document), check(document),
      files(document, dialogQuestions([this]() -> QWidget* { return front(); }),
            [this](MessageBar::Tone tone, const QString& text, const std::vector<MessageBar::Choice>& choices) {
                if (MainWindow* const view = front()) {
                    view->messageBar().say(tone, text, choices);
                }
            }),
      disk(document, files), recovery(document, files, journalFolder()) {
    listen();
}

void OpenLevel::listen() {
    disk.isBusy = [this] {
        return document.hasPreview() ||
               std::ranges::any_of(m_views, [](MainWindow* view) { return view->toolbox().isBusy(); });
    };
    disk.compare = [this](std::shared_ptr<const Level> other, const QString& name) {
        if (front() != nullptr) {
            front()->compareWith(std::move(other), name);
        }
    };
    recovery.unfinished = [this]() -> std::shared_ptr<const Level> {
        const std::optional<Edit> edit = front() != nullptr ? front()->toolbox().unfinished() : std::nullopt;
        return edit ? edit->level : nullptr;
    };
    const auto say = [this](MessageBar::Tone tone, const QString& text) {
        if (front() != nullptr) {
            front()->messageBar().say(tone, text);
        }
    };
    recovery.undecided = [this] { return runChanges.undecided(); };
    runChanges.changed.connect([this] { recovery.lookAgain(); });
    // Who leaves without a word about them has them; the question about what is not saved comes next.
    files.leaving.connect([this] { runChanges.keepAll(); });
    recovery.failed.connect([say](const Error& error) {
        say(MessageBar::Tone::Warning,
            MainWindow::tr("Should the program end all of a sudden, what is not saved will be lost:") +
                QLatin1Char('\n') + sentence(error));
    });
    files.opened.connect([this, say] {
        if (recovery.isFileOpenElsewhere()) {
            say(MessageBar::Tone::Info,
                MainWindow::tr("%1 is open in another window too. What is saved there will arrive here.")
                    .arg(files.name()));
        }
    });
    // A file that has to be written in place is neither the old nor the new one for a moment: should the program end
    // then, the journal has the new one, and the backups the old.
    files.saving.connect([this] { recovery.flush(); });
    files.saved.connect([this] {
        if (front() != nullptr) {
            front()->messageBar().dismiss(); // what kept it from being saved is no longer true
        }
    });
}

int OpenLevel::add(MainWindow& view) {
    m_views.insert(m_views.begin(), &view);
    files.changed.emit(); // with a second view, titles number them
    return ++m_lastNumber;
}

void OpenLevel::remove(const MainWindow& view) {
    if (std::erase(m_views, &view) > 0) {
        files.changed.emit();
    }
}

void OpenLevel::bringToFront(MainWindow& view) {
    const auto found = std::ranges::find(m_views, &view);
    if (found == m_views.end() || found == m_views.begin()) {
        return;
    }
    for (MainWindow* const other : m_views) {
        if (other != &view) {
            other->canvas().loseMouse();
            other->finishDrawing();
        }
    }
    std::rotate(m_views.begin(), found, found + 1);
}

bool OpenLevel::isUntouched() const {
    return files.path().isEmpty() && document.historySize() == 0 && !document.isModified();
}

} // namespace spacetow
