#pragma once
// A folder with files for tests of what is done to them, calls of the system that fail, and somebody who is not root.

#include "core/base/disk_calls.h"
#include "core/base/whole_file.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spacetow::test {

namespace disk_scene {

/// Which call of the system fails, and how.
struct PlannedFault {
    int countdown = -1; // calls until then; none if < 0
    int code = 0;
    std::string_view only; // the calls that count; empty for all but those that remove files
    bool met = false;
};
inline PlannedFault plan;

inline int plannedFault(std::string_view call) {
    const bool counts = plan.only.empty() ? call != "remove" : call == plan.only;
    if (!counts || plan.countdown < 0 || plan.countdown-- > 0) {
        return 0;
    }
    plan.met = true;
    return plan.code;
}

} // namespace disk_scene

/// Lets the call of this name, or the n-th of all, fail.
class WithFault {
  public:
    WithFault(int countdown, int code, std::string_view only = {}) {
        disk_scene::plan = {countdown, code, only, false};
        disk::setFault(&disk_scene::plannedFault);
    }
    WithFault(const WithFault&) = delete;
    WithFault& operator=(const WithFault&) = delete;
    ~WithFault() { disk::setFault(nullptr); }
};

constexpr uid_t somebody = 65534;

/// Does it in a process of its own that is nobody special; permissions do not bind root. 0 when `good` holds there.
template <class Good>
int asSomebody(Good good) {
    const pid_t child = ::fork();
    if (child == 0) {
        const bool plain = ::geteuid() != 0 || (::setgid(somebody) == 0 && ::setuid(somebody) == 0);
        ::_exit(plain && good() ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

inline std::string codeOf(const Result<FileStamp>& written) {
    return written ? std::string("written") : std::string(written.error().code.text());
}

/// A folder that is gone with its test.
class FolderOfFiles {
  public:
    QString path() const { return m_folder.path(); }
    QString name(const QString& file) const { return m_folder.filePath(file); }
    std::filesystem::path path(const std::string& file) const {
        return std::filesystem::path(m_folder.path().toStdString()) / file;
    }
    void put(const QString& file, const QByteArray& text) const {
        QFile out(name(file));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }
    QByteArray get(const QString& file) const {
        QFile in(name(file));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("(unreadable)");
    }
    struct stat info(const std::string& file) const {
        struct stat info {};
        ::stat(path(file).c_str(), &info);
        return info;
    }
    QStringList entries() const {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
    }

  private:
    QTemporaryDir m_folder;
};

} // namespace spacetow::test
