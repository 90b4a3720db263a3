#include "editor/window/recovery_row.h"
#include "editor/panels/number_text.h"

#include <QDateTime>
#include <QDir>
#include <QLocale>

namespace spacetow {

namespace {

constexpr QSize shownSize(112, 70);

QString timeText(std::int64_t seconds) {
    const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds);
    return QLocale().toString(time, QLocale::ShortFormat);
}

QString withHome(const QString& path) {
    const QString home = QDir::homePath() + QLatin1Char('/');
    return path.startsWith(home) ? QStringLiteral("~/") + path.mid(home.size()) : path;
}

} // namespace

QSize RecoveryRow::pictureSize(double pixelRatio) {
    return shownSize * pixelRatio;
}

RecoveryRow::RecoveryRow(FoundWork found) : m_found(std::move(found)), m_row(this) {
    const JournalEntry& entry = m_found.orphan.entry;
    const QString path = QString::fromStdString(entry.path);
    QPixmap picture = QPixmap::fromImage(m_found.picture);
    picture.setDevicePixelRatio(static_cast<double>(picture.width()) / shownSize.width());
    m_picture.setPixmap(picture);
    m_picture.setFixedSize(shownSize);
    m_name.setTextFormat(Qt::PlainText);
    m_name.setText(QString::fromStdString(entry.name));
    QFont bold = m_name.font();
    bold.setBold(true);
    m_name.setFont(bold);
    QStringList details{timeText(entry.time)};
    if (m_found.level) {
        details << counted(tr("%n objects", nullptr, m_found.level->objects.size()), m_found.level->objects.size());
    }
    details << (path.isEmpty() ? tr("never saved") : withHome(path));
    m_details.setText(details.join(QStringLiteral(" · ")));
    for (QLabel* label : {&m_details, &m_explanation}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_explanation.hide();
    const std::pair<QToolButton*, QString> buttons[] = {
        {&restore, tr("Restore")}, {&compare, tr("Compare")}, {&discard, tr("Discard")}, {&undo, tr("Undo")}};
    for (const auto& [button, text] : buttons) {
        button->setText(text);
        button->setFocusPolicy(Qt::StrongFocus);
        m_buttons.addWidget(button);
    }
    restore.setToolTip(tr("Go on with this level; its file stays as it is until you save"));
    compare.setToolTip(tr("Say and show what differs from the file"));
    discard.setToolTip(tr("Do not offer this any more"));
    restore.setEnabled(m_found.level != nullptr);
    compare.setEnabled(m_found.level != nullptr);
    m_buttons.addStretch(1);
    m_buttons.setSpacing(6);
    m_column.setSpacing(2);
    m_column.addWidget(&m_name);
    m_column.addWidget(&m_details);
    m_column.addWidget(&m_explanation);
    m_column.addLayout(&m_buttons);
    m_row.setContentsMargins(0, 0, 0, 0);
    m_row.setSpacing(10);
    m_row.addWidget(&m_picture, 0, Qt::AlignTop);
    m_row.addLayout(&m_column, 1);
    setDiscarded(false);
}

void RecoveryRow::explain(const QString& text) {
    m_explanation.setText(text);
    m_explanation.setVisible(!text.isEmpty());
}

void RecoveryRow::setDiscarded(bool discarded) {
    for (QToolButton* button : {&restore, &compare, &discard}) {
        button->setVisible(!discarded);
    }
    undo.setVisible(discarded);
    explain(discarded ? tr("Discarded.") : QString());
}

} // namespace spacetow
