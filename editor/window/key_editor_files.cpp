// Keys out of a file and into one.
#include "editor/window/key_editor.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QSaveFile>

namespace spacetow {

namespace {

constexpr qint64 largestKeyFile = 1'000'000; // bytes; what is larger is something else
constexpr int mostFaults = 5;                // that are told at once

QString keyFileFilter() {
    return KeyEditor::tr("Keys (*.json);;All files (*)");
}

} // namespace

KeyFileQuestions keyFileDialogs(QWidget* parent) {
    return {
        [parent] { return QFileDialog::getOpenFileName(parent, KeyEditor::tr("Import Keys"), {}, keyFileFilter()); },
        [parent] {
            return QFileDialog::getSaveFileName(parent, KeyEditor::tr("Export Keys"), QStringLiteral("keys.json"),
                                                keyFileFilter());
        }};
}

void KeyEditor::importKeys() {
    const QString path = questions.whichToImport();
    if (path.isEmpty()) {
        return;
    }
    const QString name = QFileInfo(path).fileName();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        say(tr("“%1” cannot be read: %2.").arg(name, file.errorString()), true);
        return;
    }
    const QByteArray text = file.read(largestKeyFile + 1);
    if (text.size() > largestKeyFile) {
        say(tr("“%1” is too large to be a file of keys.").arg(name), true);
        return;
    }
    const ReadKeys read = readKeys(text);
    if (!read.bindings) {
        QStringList told = read.faults.mid(0, mostFaults);
        if (read.faults.size() > mostFaults) {
            told << QStringLiteral("…");
        }
        say(tr("Nothing was taken from “%1”.").arg(name) + QLatin1Char('\n') + told.join(QLatin1Char('\n')), true);
        return;
    }
    change(*read.bindings);
    say(read.unknown.isEmpty() ? tr("These are the keys of “%1” now.").arg(name)
                               : tr("These are the keys of “%1” now. Nothing is called %2 here.")
                                     .arg(name, read.unknown.mid(0, mostFaults).join(QStringLiteral(", "))),
        false);
}

void KeyEditor::exportKeys() {
    const QString path = questions.whereToExport();
    if (path.isEmpty()) {
        return;
    }
    QSaveFile file(path);
    const bool written =
        file.open(QIODevice::WriteOnly) && file.write(keysText(m_bindings, true)) >= 0 && file.commit();
    const QString name = QFileInfo(path).fileName();
    say(written ? tr("Wrote all keys to “%1”.").arg(name)
                : tr("“%1” cannot be written: %2.").arg(name, file.errorString()),
        !written);
}

} // namespace spacetow
