#include "editor/window/bug_capsule.h"

#include "core/level/file.h"
#include "editor/exchange/capsule_text.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QSysInfo>

namespace spacetow {

namespace {

struct CapsuleWords {
    Q_DECLARE_TR_FUNCTIONS(BugCapsule)
};

/// Without the hash, unless the session of the moment is at hand.
Result<Capsule> capsuleOf(MainWindow& window) {
    Capsule capsule;
    capsule.program = QStringLiteral("SpaceTow Studio %1").arg(QGuiApplication::applicationVersion()).toStdString();
    capsule.platform = QStringLiteral("%1, %2, Qt %3")
                           .arg(QSysInfo::prettyProductName(), QSysInfo::buildAbi(), QString::fromLatin1(qVersion()))
                           .toStdString();
    capsule.level = window.document().current().level;
    if (Runner* const runner = window.liveRun().runner()) {
        const std::int64_t shown = runner->frame()->timeline->shown;
        capsule.run = runner->recording();
        capsule.level = runner->startLevel();
        if (!capsule.level) {
            return Error{"capsule-no-run", {}};
        }
        if (capsule.run.updates() < shown) { // more than is recorded
            return Error{"capsule-too-long", {std::to_string(maxReplayUpdates)}};
        }
        InputRuns inputs = inputsOf(capsule.run, *capsule.level);
        inputs.cutAt(shown);
        setInputs(capsule.run, inputs, *capsule.level);
        const Level before = levelAfter(capsule.run, *capsule.level);
        if (const std::shared_ptr<const Level> now = window.levelToRun(); *now != before) {
            capsule.run.edits.push_back({shown, deltaBetween(before, *now)}); // the next update takes it over
        }
    }
    capsule.run.level = window.files().name().toStdString();
    return capsule;
}

/// Of the run at this moment, if a copy of it is shown as it is.
std::optional<std::uint64_t> shownHash(MainWindow& window, const Replay& run) {
    const std::shared_ptr<const Frame> frame = window.liveRun().frame();
    const bool isEditedSince = !run.edits.empty() && run.edits.back().update == run.updates();
    const bool isThere =
        frame && frame->session && frame->session->updates() == run.updates() && frame->timeline->iteration == 0;
    return isThere && !isEditedSince ? std::optional(frame->session->hash()) : std::nullopt;
}

} // namespace

bool BugCapsule::isBusy() {
    if (m_task.isRunning()) {
        m_window.messageBar().say(MessageBar::Tone::Info,
                                  CapsuleWords::tr("Another bug capsule is still being worked on."));
    }
    return m_task.isRunning();
}

void BugCapsule::copy() {
    if (isBusy()) {
        return;
    }
    m_window.enterTyping();
    Result<Capsule> made = capsuleOf(m_window);
    if (!made) {
        m_window.messageBar().say(MessageBar::Tone::Error, sentence(made.error()));
        return;
    }
    Capsule capsule = std::move(made).value();
    const std::optional<std::uint64_t> hash = shownHash(m_window, capsule.run);
    m_task.start([this, capsule, hash](const std::stop_token& stop) -> BackgroundTask::Then {
        Capsule whole = capsule;
        whole.hash = hash ? *hash : sessionOf(whole, stop).hash();
        const Result<std::string> text = capsuleText(whole);
        if (!text) {
            const Error error = text.error();
            return [this, error] { m_window.messageBar().say(MessageBar::Tone::Error, sentence(error)); };
        }
        const QString words = QString::fromStdString(text.value());
        return [this, words] { copied(words); };
    });
}

void BugCapsule::copied(const QString& text) {
    QGuiApplication::clipboard()->setText(text);
    m_window.messageBar().say(MessageBar::Tone::Info,
                              CapsuleWords::tr("A bug capsule of %1 is on the clipboard. Paste it into a mail or an "
                                               "issue, or into a window of this program.")
                                  .arg(QLocale().formattedDataSize(text.size())));
}

void BugCapsule::open(std::string text) {
    if (isBusy()) {
        return;
    }
    m_window.messageBar().say(MessageBar::Tone::Info,
                              CapsuleWords::tr("The run of the bug capsule is being simulated up to its moment…"));
    m_task.start([this, text = std::move(text)](const std::stop_token& stop) -> BackgroundTask::Then {
        Result<Capsule> read = capsuleFromText(text);
        if (!read) {
            const Error error = read.error();
            return [this, error] { m_window.messageBar().say(MessageBar::Tone::Error, sentence(error)); };
        }
        const auto capsule = std::make_shared<const Capsule>(std::move(read).value());
        const Opening opening{std::make_shared<const Level>(levelAfter(capsule->run, *capsule->level)),
                              sessionOf(*capsule, stop).hash() == capsule->hash};
        return [this, capsule, opening] { opened(capsule, opening); };
    });
}

MainWindow* BugCapsule::windowFor(const Capsule& capsule) {
    if (*m_window.document().current().level == *capsule.level) {
        return &m_window;
    }
    Application* const application = m_window.application();
    MainWindow& room = application != nullptr ? application->roomToRestore(QString(), m_window) : m_window;
    room.stopPlaying();
    const bool free =
        room.files().mayLeave() && room.files().restore({{}, capsule.run.level, {}, 0, levelText(*capsule.level)});
    return free ? &room : nullptr;
}

void BugCapsule::opened(const std::shared_ptr<const Capsule>& capsule, const Opening& opening) {
    m_window.messageBar().dismiss();
    MainWindow* const place = windowFor(*capsule);
    if (place == nullptr) {
        return;
    }
    place->comeForward();
    place->reopenRun(capsule->run, opening.edited);
    place->liveRun().seek(capsule->run.updates());
    if (opening.isSame) {
        place->messageBar().dismiss();
        return;
    }
    place->messageBar().say(
        MessageBar::Tone::Warning,
        CapsuleWords::tr("The run comes out otherwise here than where the bug capsule was made, "
                         "with %1 on %2.")
            .arg(QString::fromStdString(capsule->program), QString::fromStdString(capsule->platform)));
}

} // namespace spacetow
