#include "tests/support/desktop.h"

#include <QStandardPaths>
#include <QTest>

namespace spacetow::test {

namespace {

constexpr int toolTime = 10'000; // ms, in which xdotool has done what it was told

void end(QProcess& process) {
    if (process.state() != QProcess::NotRunning) {
        process.terminate();
        if (!process.waitForFinished(3000)) {
            process.kill();
            process.waitForFinished(3000);
        }
    }
}

} // namespace

bool waitUntil(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, Desktop::patience);
}

Desktop::Desktop() {
    for (const char* program : {"Xvfb", "openbox", "xdotool"}) {
        if (QStandardPaths::findExecutable(QString::fromLatin1(program)).isEmpty()) {
            m_trouble = QStringLiteral("there is no %1 here").arg(QString::fromLatin1(program));
            return;
        }
    }
    // The server chooses a number that is free, and says it when it is ready.
    m_server.start(QStringLiteral("Xvfb"),
                   {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
                    QStringLiteral("1280x800x24"), QStringLiteral("-nolisten"), QStringLiteral("tcp"),
                    QStringLiteral("-noreset")});
    const bool said = waitUntil([this] {
        m_server.waitForReadyRead(50);
        return m_server.canReadLine() || m_server.state() == QProcess::NotRunning;
    });
    const QByteArray number = m_server.readLine().trimmed();
    if (!said || number.isEmpty()) {
        m_trouble = QStringLiteral("Xvfb does not run: ") + QString::fromUtf8(m_server.readAllStandardError());
        return;
    }
    m_display = QLatin1Char(':') + QString::fromLatin1(number);
    m_manager.setProcessEnvironment(environment());
    m_manager.start(QStringLiteral("openbox"), {});
    // A window that is there before its manager never gets the focus.
    if (!m_manager.waitForStarted() || !waitUntil([this] { return isManaged(); })) {
        m_trouble = QStringLiteral("openbox does not run");
    }
}

Desktop::~Desktop() {
    end(m_manager);
    end(m_server);
}

QProcessEnvironment Desktop::environment() const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    environment.remove(QStringLiteral("DBUS_SESSION_BUS_ADDRESS"));
    environment.insert(QStringLiteral("DISPLAY"), m_display);
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    return environment;
}

QString Desktop::xdotool(const QStringList& arguments) const {
    QProcess tool;
    tool.setProcessEnvironment(environment());
    tool.start(QStringLiteral("xdotool"), arguments);
    tool.waitForFinished(toolTime);
    return QString::fromUtf8(tool.readAllStandardOutput()).trimmed();
}

bool Desktop::isManaged() const {
    QProcess tool;
    tool.setProcessEnvironment(environment());
    tool.start(QStringLiteral("xdotool"), {QStringLiteral("get_desktop")});
    return tool.waitForFinished(toolTime) && tool.exitStatus() == QProcess::NormalExit && tool.exitCode() == 0;
}

QString Desktop::title() const {
    return xdotool({QStringLiteral("getactivewindow"), QStringLiteral("getwindowname")});
}

bool Desktop::waitForTitle(const std::function<bool(const QString&)>& wanted) const {
    QString last;
    const bool came = waitUntil([&] {
        last = title();
        return wanted(last);
    });
    if (!came) {
        qWarning("the window is called “%s”", qPrintable(last));
    }
    return came;
}

void Desktop::keys(const QStringList& strokes) const {
    xdotool(QStringList{QStringLiteral("key"), QStringLiteral("--delay"), QStringLiteral("20")} + strokes);
}

void Desktop::type(const QString& text) const {
    xdotool({QStringLiteral("type"), QStringLiteral("--delay"), QStringLiteral("5"), text});
}

void Desktop::click(int x, int y) const {
    xdotool({QStringLiteral("mousemove"), QString::number(x), QString::number(y), QStringLiteral("click"),
             QStringLiteral("1")});
}

void Desktop::drag(int fromX, int fromY, int toX, int toY) const {
    const auto move = [](int x, int y) {
        return QStringList{QStringLiteral("mousemove"), QString::number(x), QString::number(y)};
    };
    xdotool(move(fromX, fromY) + QStringList{QStringLiteral("mousedown"), QStringLiteral("1")} +
            move((fromX + toX) / 2, (fromY + toY) / 2) + move(toX, toY) +
            QStringList{QStringLiteral("mouseup"), QStringLiteral("1")});
}

} // namespace spacetow::test
