#include "editor/window/bug_capsule.h"

#include "core/game/codes.h"
#include "core/level/file.h"
#include "editor/exchange/capsule_text.h"
#include "editor/panels/number_text.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QSysInfo>

#include <utility>

namespace spacetow {

namespace {

struct CapsuleWords {
    Q_DECLARE_TR_FUNCTIONS(BugCapsule)
};

/// What is to be reported, as far as the window knows it.
struct Report {
    Capsule capsule; // without a run
    bool hasRun = false;
    std::function<Recording()> recording{};   // of the run
    std::int64_t shown = 0;                   // the moment
    std::shared_ptr<const Level> edited;      // as the next update has it
    std::shared_ptr<const Session> session{}; // of the moment; null where there is no copy of it as it is
};

Report reportOf(MainWindow& window) {
    Report report;
    Capsule& capsule = report.capsule;
    capsule.program = QStringLiteral("SpaceTow Studio %1").arg(QGuiApplication::applicationVersion()).toStdString();
    capsule.platform = QStringLiteral("%1, %2, Qt %3")
                           .arg(QSysInfo::prettyProductName(), QSysInfo::buildAbi(), QString::fromLatin1(qVersion()))
                           .toStdString();
    capsule.level = window.document().current().level;
    capsule.run.level = window.files().name().toStdString();
    report.edited = window.levelToRun();
    Runner* const runner = window.liveRun().runner();
    if (runner == nullptr) {
        return report;
    }
    report.hasRun = true;
    capsule.run.kind = window.liveRun().kind();
    const std::shared_ptr<const Frame> frame = runner->frame();
    report.recording = runner->askRecording(); // afterwards, so that what is shown is recorded
    report.shown = frame->timeline->shown;
    const bool isThere = frame->session && frame->session->updates() == report.shown && frame->timeline->iteration == 0;
    report.session = isThere ? frame->session : nullptr;
    return report;
}

/// Waits for the update that runs.
Result<Capsule> capsuleOf(const Report& report, const std::stop_token& stop) {
    Capsule capsule = report.capsule;
    bool isEditedSince = false;
    if (report.hasRun) {
        const Recording recording = report.recording();
        if (!recording.start) {
            return Error{GameCode("capsule-no-run"), {}};
        }
        if (recording.run.updates() < report.shown) { // more than is recorded
            return Error{GameCode("capsule-too-long"), {std::to_string(maxReplayUpdates)}};
        }
        InputRuns inputs = inputsOf(recording.run, *recording.start);
        inputs.cutAt(report.shown);
        capsule.level = recording.start;
        capsule.run.seed = recording.run.seed;
        setInputs(capsule.run, inputs, *capsule.level);
        if (const Level before = levelAfter(capsule.run, *capsule.level); *report.edited != before) {
            capsule.run.edits.push_back({report.shown, deltaBetween(before, *report.edited)});
            isEditedSince = true;
        }
    }
    capsule.hash = report.session && !isEditedSince ? report.session->hash() : sessionOf(capsule, stop).hash();
    return capsule;
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
    m_task.start([this, report = reportOf(m_window)](const std::stop_token& stop) -> BackgroundTask::Then {
        const Result<Capsule> capsule = capsuleOf(report, stop);
        const Result<std::string> text = capsule ? capsuleText(capsule.value()) : capsule.error();
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
                                  .arg(sizeText(text.size())));
}

void BugCapsule::open(std::string text) {
    if (isBusy()) {
        return;
    }
    m_window.messageBar().say(MessageBar::Tone::Info, CapsuleWords::tr("The bug capsule is being read…"));
    m_task.start([this, text = std::move(text)](const std::stop_token&) -> BackgroundTask::Then {
        Result<Capsule> read = capsuleFromText(text);
        if (!read) {
            const Error error = read.error();
            return [this, error] {
                m_window.messageBar().say(MessageBar::Tone::Error,
                                          sentence(CapsuleWords::tr("The bug capsule"), error));
            };
        }
        const auto capsule = std::make_shared<const Capsule>(std::move(read).value());
        const auto edited = std::make_shared<const Level>(levelAfter(capsule->run, *capsule->level));
        return [this, capsule, edited] { opened(capsule, edited); };
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

void BugCapsule::opened(const std::shared_ptr<const Capsule>& capsule, const std::shared_ptr<const Level>& edited) {
    m_window.messageBar().dismiss();
    MainWindow* const place = windowFor(*capsule);
    if (place == nullptr) {
        return;
    }
    place->comeForward();
    place->messageBar().dismiss();
    place->reopenRun(capsule->run, edited);
    place->liveRun().seek(capsule->run.updates());
    place->bugCapsule().m_opened = capsule;
    place->bugCapsule().compare();
}

void BugCapsule::compare() {
    const std::shared_ptr<const TimelineSummary> timeline = m_opened ? m_window.liveRun().timeline() : nullptr;
    if (!timeline || !timeline->opened) {
        return;
    }
    const std::shared_ptr<const Capsule> capsule = std::exchange(m_opened, nullptr);
    if (*timeline->opened == capsule->hash) {
        return;
    }
    m_window.messageBar().say(
        MessageBar::Tone::Warning,
        CapsuleWords::tr("The run comes out otherwise here than where the bug capsule was made, "
                         "with %1 on %2.")
            .arg(QString::fromStdString(capsule->program), QString::fromStdString(capsule->platform)));
}

} // namespace spacetow
