#pragma once
// A desktop of its own for a test: an X server without a screen, a window manager, and keys and a mouse whose events
// come through the server like a user's. Nothing waits for a fixed time.

#include <QProcess>
#include <QString>
#include <QStringList>

#include <functional>

namespace spacetow::test {

class Desktop {
  public:
    static constexpr int patience = 20'000; // ms; a sound program needs a fraction of it

    Desktop();
    ~Desktop();

    /// Empty when it runs; else what keeps it from running.
    const QString& trouble() const { return m_trouble; }
    QProcessEnvironment environment() const;

    /// Of the window that has the focus; empty while none has.
    QString title() const;
    bool waitForTitle(const std::function<bool(const QString&)>& wanted) const;
    /// Such as ctrl+s; one after the other.
    void keys(const QStringList& strokes) const;
    void type(const QString& text) const;
    void click(int x, int y) const;
    void drag(int fromX, int fromY, int toX, int toY) const;

  private:
    /// Only a window manager numbers the desktops.
    bool isManaged() const;
    QString xdotool(const QStringList& arguments) const;

    QProcess m_server;
    QProcess m_manager;
    QString m_display;
    QString m_trouble;
};

/// Until it is so, but no longer than Desktop::patience.
bool waitUntil(const std::function<bool()>& condition);

} // namespace spacetow::test
