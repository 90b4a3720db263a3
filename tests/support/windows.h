#pragma once
// The program with its windows, for tests: with preferences and files of its own, and questions answered in advance.

#include "core/level/file.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace spacetow::test {

class TestApplication {
  public:
    TestApplication() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath(QStringLiteral("settings")));
        QCoreApplication::setOrganizationName(QStringLiteral("spacetow-test"));
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
        QApplication::setQuitOnLastWindowClosed(false);
        application.emplace();
    }
    ~TestApplication() {
        application.reset();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    void start(const QStringList& files = {}) {
        application->start(files);
        answer();
    }
    /// Left, and started again with what it remembers.
    void startAgain(const QStringList& files = {}) {
        QVERIFY(application->quit());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        application.emplace();
        start(files);
    }
    /// All windows ask here instead of the user.
    void answer() {
        for (MainWindow* window : application->windows()) {
            window->files().questions = {[this](const QString&) { return toOpen; },
                                         [this](const QString&) { return toSave; },
                                         [this](const QString& name) {
                                             asked << name;
                                             return unsaved;
                                         }};
        }
        QApplication::processEvents();
    }

    std::size_t count() const { return application->windows().size(); }
    MainWindow& window(std::size_t i) { return *application->windows().at(i); }
    void trigger(std::size_t i, ActionId id) {
        window(i).actions().refresh(); // as coming to the front does, which nothing offscreen does for sure
        window(i).actions()[id].trigger();
        answer();
    }

    /// Of a level of this name that holds one ball.
    QString writtenLevel(const QString& name) {
        Level level;
        level.name = name.toStdString();
        level.objects.append(ball(1, {0, 0}));
        QString path = m_folder.filePath(name);
        writeLevel(path.toStdString(), level);
        return path;
    }
    static Object ball(Key key, const Vec2& at) {
        Object object;
        object.key = key;
        object.data = BodyObject{.shapes = {Circle{at, 0.5}}};
        return object;
    }
    /// One more ball.
    static void edit(MainWindow& window) {
        Level level = window.document().level();
        const Key key = 1000 + static_cast<Key>(level.objects.size());
        level.objects.append(ball(key, {static_cast<double>(key), 0}));
        window.document().commit({"draw-circle"}, {std::make_shared<const Level>(std::move(level)), {}});
    }
    QString file(const QString& name) const { return m_folder.filePath(name); }

    QStringList toOpen;
    QString toSave;
    Unsaved unsaved = Unsaved::Cancel;
    QStringList asked;
    std::optional<Application> application;

  private:
    QTemporaryDir m_folder;
};

} // namespace spacetow::test
