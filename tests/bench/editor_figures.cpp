#include "tests/bench/editor_figures.h"

#include "core/level/file.h"
#include "core/level/leak.h"
#include "editor/window/dropped_files.h"
#include "editor/window/main_window.h"
#include "tests/bench/stopwatch.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <fstream>

namespace spacetow::bench {

namespace {

constexpr int frames = 200;      // of which medians and quantiles are taken
constexpr int quietTime = 400;   // ms without work, after which the window has come to rest
constexpr double usualZoom = 66; // px a metre

/// Counts the paintings of a widget.
class PaintCount : public QObject {
  public:
    explicit PaintCount(QWidget& widget) { widget.installEventFilter(this); }
    int count = 0;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }
};

double residentMegabytes() {
    std::ifstream status("/proc/self/statm");
    long total = 0;
    long resident = 0;
    status >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

class Timing {
  public:
    Timing(const Subject& subject, const std::function<void(const Figure&)>& report)
        : m_subject(subject), m_report(report), m_large(subject.edges >= 100'000) {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath(QStringLiteral("settings")));
        m_window.files().questions.whatAboutChanges = [](const QString&) { return Unsaved::Discard; };
        m_window.resize(1280, 800);
        m_window.show();
        m_window.activateWindow();
        rest();
    }

    void run() {
        open();
        pan();
        zoom();
        hover();
        search();
        dragOne();
        dragNode();
        autosave();
        changeAll();
        play();
        findLeaks();
        importDrawing();
    }

  private:
    template <class Work>
    double time(Work&& work) {
        return m_subject.cpu ? processorMilliseconds(work) : milliseconds(work);
    }
    template <class Event>
    double frame(Event&& event) {
        return time([&] {
            event();
            QCoreApplication::processEvents();
        });
    }
    /// Until what goes on beside the window, such as checking, has come to an end.
    static void rest() {
        QElapsedTimer quiet;
        quiet.start();
        while (quiet.elapsed() < quietTime) {
            QElapsedTimer work;
            work.start();
            QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
            if (work.nsecsElapsed() > 2'000'000) {
                quiet.restart();
            }
            QTest::qSleep(5);
        }
    }
    void say(const char* name, double value, double small, double large) const {
        m_report({name, value, "ms", m_large ? large : small});
    }
    void sayFrames(const std::string& name, const std::vector<double>& times, double small, double large) const {
        say((name + ".median").c_str(), quantile(times, 0.5), small, large);
        say((name + ".p99").c_str(), quantile(times, 0.99), 2 * small, m_large ? 2 * large + 1 : 0);
    }
    Canvas& canvas() { return m_window.canvas(); }
    QPoint middle() { return canvas().rect().center(); }
    QPoint at(const Vec2& world) {
        const Vec2 screen = canvas().view().toScreen(world);
        return {qRound(screen.x()), qRound(screen.y())};
    }
    void mouse(const QPoint& position, Qt::MouseButtons buttons) {
        QMouseEvent move(QEvent::MouseMove, position, canvas().mapToGlobal(QPointF(position)), Qt::NoButton, buttons,
                         {});
        QCoreApplication::sendEvent(&canvas(), &move);
    }
    void wheel(int angle) {
        QWheelEvent event(middle(), canvas().mapToGlobal(QPointF(middle())), {}, {0, angle}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&m_window, key, modifiers); }
    void canvasKey(Qt::Key key) { QTest::keyClick(&canvas(), key); }

    void open() {
        const QString path = m_folder.filePath(QStringLiteral("large.json"));
        std::ofstream(path.toStdString()) << levelText(largeLevel(m_subject.level, m_subject.edges));
        double longest = 0;
        const auto turn = [&longest](auto&& work) { longest = std::max(longest, milliseconds(work)); };
        const double taken = time([&] {
            turn([&] { openDropped({path}, m_window); });
            PaintCount paints(canvas());
            while (m_window.files().path() != path || paints.count == 0) {
                turn([] { QCoreApplication::processEvents(); });
            }
        });
        say("open", taken, 150, 1000);
        for (QElapsedTimer quiet; !quiet.isValid() || quiet.elapsed() < 5 * quietTime;) { // until the rest is there
            quiet.isValid() ? void() : quiet.start();
            turn([] { QCoreApplication::processEvents(); });
            QTest::qSleep(1);
        }
        rest();
        say("open.blocked", longest, 50, 50);
        m_report({"memory", residentMegabytes(), "MB", m_large ? 300.0 : 120.0});
    }

    void panFrames(std::vector<double>& times) {
        QPoint place = middle();
        QTest::mousePress(&canvas(), Qt::MiddleButton, {}, place);
        for (int i = 0; i < frames; ++i) {
            place += i / 25 % 2 == 0 ? QPoint(9, 4) : QPoint(-9, -4);
            times.push_back(frame([&] { mouse(place, Qt::MiddleButton); }));
        }
        QTest::mouseRelease(&canvas(), Qt::MiddleButton, {}, place);
    }
    void pan() {
        std::vector<double> times;
        panFrames(times);
        rest();
        canvas().zoomTo(usualZoom);
        rest();
        panFrames(times);
        canvas().fitLevel();
        rest();
        sayFrames("pan", times, 8, 16);
    }

    /// Notches in and out again, as fast as they come; then how long it takes until the picture is the final one.
    void zoom() {
        std::vector<double> times;
        for (int i = 0; i < frames; ++i) {
            times.push_back(frame([&] { wheel(i / 10 % 2 == 0 ? 120 : -120); }));
        }
        rest();
        sayFrames("zoom", times, 8, 16);
    }

    void hover() {
        std::vector<double> times;
        for (int i = 0; i < frames; ++i) {
            const QPoint place = middle() + QPoint(i * 7 % 400 - 200, i * 13 % 300 - 150);
            times.push_back(frame([&] { mouse(place, Qt::NoButton); }));
        }
        say("hover.median", quantile(times, 0.5), 1, 2);
    }

    /// From the key that opens the command palette to what it shows first, and from each letter to what is found then.
    void search() {
        std::vector<double> times;
        Finder& finder = m_window.finder();
        for (int i = 0; i < frames / 20; ++i) {
            times.push_back(frame([&] { m_window.actions()[Act::CommandPalette].trigger(); }));
            for (const char letter : {'w', 'a', 'l'}) {
                times.push_back(frame([&] { QTest::keyClick(&finder.field(), letter); }));
                finder.model().finish();
            }
            finder.close();
        }
        say("palette.worst", quantile(times, 1), 50, 50);
        rest();
    }

    /// A point on the outline of a body about the middle of the level.
    Vec2 grip() {
        const ObjectList& objects = m_window.document().level().objects;
        const Object& object = objects[objects.size() == 4 ? 3 : objects.size() / 2];
        const auto& body = std::get<BodyObject>(object.data);
        const std::vector<Vec2>& vertices = std::get<EdgeChain>(body.shapes.front()).vertices;
        const std::size_t middle = vertices.size() / 2;
        return body.position + 0.5 * (vertices[middle - 1] + vertices[middle]);
    }

    std::vector<double> dragFrames(const std::string& what, const QPoint& from) {
        std::vector<double> times;
        mouse(from, Qt::NoButton);
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= frames / 2; ++i) {
            const QPoint place = from + QPoint(3 * i % 160 + 5, i % 90);
            times.push_back(frame([&] { mouse(place, Qt::LeftButton); }));
        }
        say((what + ".first").c_str(), std::max(times[0], times[1]), 0, 0);
        times.erase(times.begin(), times.begin() + 2); // picking up is not dragging
        say((what + ".release").c_str(),
            frame([&] { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + QPoint(40, 30)); }), 0, 0);
        return times;
    }
    void dragOne() {
        rest();
        sayFrames("drag-one", dragFrames("drag-one", at(grip())), 4, 8);
        rest();
        say("undo-one", frame([&] { key(Qt::Key_Z, Qt::ControlModifier); }), 0, 0);
        rest();
    }

    /// The vertex where the grip's segment begins, of the body there alone.
    void dragNode() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(grip()));
        canvasKey(Qt::Key_O);
        canvas().zoomTo(usualZoom);
        canvas().frameSelection();
        rest();
        const ObjectList& objects = m_window.document().level().objects;
        const auto* body = std::get_if<BodyObject>(&objects.find(m_window.document().selection().keys().front())->data);
        const std::vector<Vec2>& vertices = std::get<EdgeChain>(body->shapes.front()).vertices;
        sayFrames("drag-node", dragFrames("drag-node", at(body->position + vertices[vertices.size() / 2 - 1])), 4, 8);
        rest();
        key(Qt::Key_Z, Qt::ControlModifier);
        canvasKey(Qt::Key_S);
        canvas().fitLevel();
        rest();
    }

    /// How long the journal holds up the window; the edit is one that leaves nothing to paint.
    void autosave() {
        std::vector<double> times;
        for (int i = 0; i < 8; ++i) {
            Document& document = m_window.document();
            Level level = *document.current().level;
            level.description = std::to_string(i);
            document.commit({"change-level", 1}, {std::make_shared<const Level>(std::move(level)), {}});
            double longest = 0;
            while (m_window.recovery().isBehind()) {
                longest = std::max(longest, time([] { QCoreApplication::processEvents(); }));
            }
            times.push_back(longest);
            rest();
        }
        say("autosave.blocked", quantile(times, 0.99), 16, 0);
        key(Qt::Key_Z, Qt::ControlModifier);
        rest();
    }

    void changeAll() {
        canvas().setFocus();
        rest();
        say("select-all", frame([&] { key(Qt::Key_A, Qt::ControlModifier); }), 100, 700);
        rest();
        say("move-all", frame([&] { canvasKey(Qt::Key_Right); }), 100, 700);
        rest();
        const std::vector<double> times = dragFrames("drag-all", at(grip()));
        say("drag-all.median", quantile(times, 0.5), 0, 0);
        rest();
        say("undo-move", frame([&] { key(Qt::Key_Z, Qt::ControlModifier); }), 100, 700);
        rest();
        key(Qt::Key_A, Qt::ControlModifier);
        rest();
        say("delete-all", frame([&] { canvasKey(Qt::Key_Delete); }), 100, 700);
        rest();
        say("undo-delete", frame([&] { key(Qt::Key_Z, Qt::ControlModifier); }), 100, 700);
        rest();
    }

    /// From F5 to the first picture, a picture later, what the game takes, and back.
    void play() {
        const double before = residentMegabytes();
        say("play.start", frame([&] { m_window.play(); }), 0, 0);
        const LiveRun& view = m_window.liveRun();
        QElapsedTimer waiting;
        waiting.start();
        while (view.updates() < 5 && waiting.elapsed() < 60'000) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        }
        std::vector<double> times;
        for (int i = 0; i < frames / 4; ++i) {
            times.push_back(frame([&] { m_window.liveView().refresh(), m_window.canvas().repaint(); }));
        }
        say("play.frame", quantile(times, 0.5), 8, 16);
        m_report({"play.memory", residentMegabytes() - before, "MB", 0});
        say("play.leave", frame([&] { m_window.stopPlaying(); }), 16, 16);
        rest();
    }

    /// Of the level as it is, and of one that lacks a piece of its longest wall.
    void findLeaks() {
        Level level = largeLevel(m_subject.level, m_subject.edges);
        const auto isBad = [](int) { return false; };
        say("leaks", time([&] { leaksOf(level, isBad); }), 200, 2000);
        const int last = level.objects.size() - 1;
        Object object = level.objects[last];
        auto& chain = std::get<EdgeChain>(std::get<BodyObject>(object.data).shapes.front());
        if (chain.closed) {
            chain.closed = false;
            chain.vertices.resize(chain.vertices.size() - chain.vertices.size() / 100);
            level.objects.replace(last, object);
            say("leaks.found", time([&] { leaksOf(level, isBad); }), 200, 2000);
        }
    }

    /// An SVG of 10,000 segments, curves and lines in turns, until it is shown as it would come; and the longest time
    /// for which the window did nothing else.
    void importDrawing() {
        const QString path = m_folder.filePath(QStringLiteral("drawing.svg"));
        std::ofstream out(path.toStdString());
        out << R"(<svg xmlns="http://www.w3.org/2000/svg" width="2000" height="2000">)";
        for (int i = 0; i < 100; ++i) {
            out << "<path fill='none' stroke='black' d='M" << 10 * i << ' ' << 20 * i % 700;
            for (int j = 0; j < 50; ++j) {
                out << "c5 " << j % 9 << " 9-6 14 3l6-" << j % 5;
            }
            out << "'/>";
        }
        out << "</svg>";
        out.close();
        double longest = 0;
        const double taken = milliseconds([&] {
            longest = milliseconds([&] { m_window.open(path); });
            while (!m_window.document().hasPreview()) {
                longest = std::max(longest, milliseconds([] { QCoreApplication::processEvents(); }));
            }
        });
        say("import-drawing", taken, 1000, 1000);
        say("import-drawing.longest", longest, 0, 0);
        say("import-drawing.commit", frame([&] { m_window.exchange().importBar().apply(); }), 0, 0);
        rest();
    }

    Subject m_subject;
    std::function<void(const Figure&)> m_report;
    bool m_large;
    QTemporaryDir m_folder;
    bool m_ownJournal = qputenv("XDG_STATE_HOME", m_folder.path().toUtf8()); // before the window is made
    MainWindow m_window;
};

} // namespace

void timeEditor(const Subject& subject, const std::function<void(const Figure&)>& report) {
    Timing(subject, report).run();
}

} // namespace spacetow::bench
