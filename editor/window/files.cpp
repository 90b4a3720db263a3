#include "editor/window/files.h"

#include "editor/panels/number_text.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace spacetow {

namespace {

constexpr int fewProblems = 4; // as many as the bar lists

struct FileWords {
    Q_DECLARE_TR_FUNCTIONS(Files)
};

QString filter() {
    return FileWords::tr("SpaceTow levels (*.json);;All files (*)");
}

Unsaved askAboutChanges(QWidget* parent, const QString& name) {
    QMessageBox box(parent);
    box.setIcon(QMessageBox::Warning);
    box.setWindowTitle(FileWords::tr("Unsaved changes"));
    box.setTextFormat(Qt::PlainText); // the name may hold anything
    box.setText(FileWords::tr("Save the changes to “%1”?").arg(name));
    box.setInformativeText(FileWords::tr("If you discard them, they are lost."));
    const QAbstractButton* save = box.addButton(FileWords::tr("&Save"), QMessageBox::AcceptRole);
    const QAbstractButton* discard = box.addButton(FileWords::tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* cancel = box.addButton(FileWords::tr("&Cancel"), QMessageBox::RejectRole);
    box.setEscapeButton(cancel);
    box.exec();
    return box.clickedButton() == save      ? Unsaved::Save
           : box.clickedButton() == discard ? Unsaved::Discard
                                            : Unsaved::Cancel;
}

/// "Untitled 2", "cave 2.json".
QString numbered(const QString& name, int number) {
    const qsizetype end = name.endsWith(QLatin1String(".json")) ? name.size() - 5 : name.size();
    return number == 1 ? name : QStringLiteral("%1 %2%3").arg(name.left(end)).arg(number).arg(name.mid(end));
}

QString exampleName() {
    return FileWords::tr("The example");
}

/// One problem a line, the first few of them.
QString listed(const std::vector<Problem>& problems) {
    QString text;
    int count = 0;
    for (const Problem& problem : problems) {
        if (++count <= fewProblems) {
            text += QLatin1Char('\n');
            text += problem.line > 0 ? FileWords::tr("Line %1: %2").arg(problem.line).arg(sentence(problem))
                                     : sentence(problem);
        }
    }
    if (count > fewProblems) {
        text += QLatin1Char('\n') + FileWords::tr("… and %1 more").arg(countText(count - fewProblems));
    }
    return text;
}

} // namespace

FileQuestions dialogQuestions(const std::function<QWidget*()>& parent) {
    return {[parent](const QString& folder) {
                return QFileDialog::getOpenFileNames(parent(), FileWords::tr("Open level"), folder, filter());
            },
            [parent](const QString& suggestion) {
                QFileDialog dialog(parent(), FileWords::tr("Save level as"), suggestion, filter());
                dialog.setAcceptMode(QFileDialog::AcceptSave);
                dialog.setDefaultSuffix(QStringLiteral("json"));
                dialog.selectFile(suggestion);
                return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
            },
            [parent](const QString& name) { return askAboutChanges(parent(), name); },
            [parent](const QString& folder) {
                return QFileDialog::getOpenFileName(parent(), FileWords::tr("Compare with level"), folder, filter());
            }};
}

Files::Files(Document& document, FileQuestions questionsToAsk, Tell tell)
    : questions(std::move(questionsToAsk)), m_document(document), m_tell(std::move(tell)) {}

QString Files::name() const {
    if (!m_path.isEmpty()) {
        return QFileInfo(m_path).fileName();
    }
    return untitled(m_number);
}

QString Files::untitled(int number) const {
    return numbered(m_untitled.isEmpty() ? FileWords::tr("Untitled") : m_untitled, number);
}

QString Files::nameInFlights() const {
    return m_path.isEmpty() ? untitled(1) : name();
}

void Files::setUntitled(const QString& fileName) {
    m_untitled = fileName;
    m_number = 1;
}

void Files::setNumber(int number) {
    if (number != m_number) {
        m_number = number;
        changed.emit();
    }
}

QString Files::suggestion() const {
    if (!m_path.isEmpty()) {
        return m_path;
    }
    const QString name = m_untitled.isEmpty() ? FileWords::tr("level") + QStringLiteral(".json") : m_untitled;
    const QString file = numbered(name, m_number);
    const QStringList recent = preferences.recentFiles();
    return QDir(recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path()).filePath(file);
}

bool Files::startNew() {
    if (!mayLeave()) {
        return false;
    }
    startOver();
    return true;
}

void Files::startOver() {
    m_path.clear();
    m_disk = {};
    setUntitled({});
    m_document.reset(Level());
    opened.emit();
    changed.emit();
}

QStringList Files::chosen() const {
    return questions.whichToOpen(QFileInfo(suggestion()).path());
}

bool Files::open(const FileToOpen& file) {
    const FileToOpen absolute(QFileInfo(file.path).absoluteFilePath(), file.read);
    std::optional<LevelFile> found = readable(absolute);
    const bool modified = m_document.isModified();
    if (!found || !mayLeave()) {
        return false;
    }
    if (modified) {
        found = readable(absolute); // what was just saved may be this very file
    }
    if (!found) {
        return false;
    }
    preferences.addRecent(absolute.path); // before the news of the file goes out
    adopt(*found, absolute.path);
    return true;
}

std::shared_ptr<const Level> Files::chooseToCompare(QString& shownName) {
    const QString path = questions.whichToCompare(QFileInfo(suggestion()).path());
    const std::optional<LevelFile> file = path.isEmpty() ? std::nullopt : readable(path);
    if (!file) {
        return nullptr;
    }
    shownName = QFileInfo(path).fileName();
    return std::make_shared<const Level>(*file->level);
}

bool Files::openExample(const QString& resource) {
    QFile file(resource);
    if (!file.open(QIODevice::ReadOnly)) {
        return false;
    }
    m_readPath.clear();
    const LevelFile example = parseLevel(file.readAll().toStdString(), Checks::FileOnly);
    if (!holdsLevel(example, exampleName()) || !mayLeave()) {
        return false;
    }
    adopt(example, QString());
    setUntitled(QFileInfo(resource).fileName());
    changed.emit();
    return true;
}

std::optional<LevelFile> Files::readable(const FileToOpen& file) {
    m_readPath = file.path;
    Result<LevelFile> found = levelOfFile(file, m_read);
    if (!found) {
        preferences.removeRecent(file.path);
        m_tell(MessageBar::Tone::Error, sentence(found.error()), {});
        return {};
    }
    if (!holdsLevel(found.value(), QFileInfo(file.path).fileName())) {
        return {};
    }
    return std::move(found).value();
}

bool Files::holdsLevel(const LevelFile& file, const QString& shownName) {
    if (!file.level) {
        m_tell(MessageBar::Tone::Error, FileWords::tr("%1 cannot be opened.").arg(shownName) + listed(file.problems),
               backupChoices(m_readPath, [this, path = m_readPath] { openNewestBackup(path); }));
    }
    return file.level.has_value();
}

void Files::adopt(const LevelFile& file, const QString& path) {
    m_path = path;
    m_disk = path.isEmpty() ? FileState() : m_read;
    setUntitled({});
    m_document.reset(*file.level);
    if (!path.isEmpty()) {
        m_document.markSaved();
    }
    // What lint says of the level stands in the panel of problems as long as it is true.
    const std::vector<Problem>& problems = file.problems;
    if (!problems.empty()) {
        const QString shownName = path.isEmpty() ? exampleName() : QFileInfo(path).fileName();
        m_tell(MessageBar::Tone::Warning, FileWords::tr("%1 was opened, but:").arg(shownName) + listed(problems), {});
    }
    opened.emit();
    changed.emit();
}

bool Files::saveAs() {
    const QString path = questions.whereToSave(suggestion());
    return !path.isEmpty() && writeTo(QFileInfo(path).absoluteFilePath());
}

bool Files::mayLeave() {
    leaving.emit();
    if (!m_document.isModified()) {
        return true;
    }
    switch (questions.whatAboutChanges(name())) {
    case Unsaved::Save:
        return save();
    case Unsaved::Discard:
        return true;
    case Unsaved::Cancel:
        break;
    }
    return false;
}

} // namespace spacetow
