#include "editor/window/welcome_page.h"

#include "core/level/file.h"
#include "editor/canvas/icons.h"
#include "editor/panels/names.h"
#include "editor/window/preferences.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>

namespace spacetow {

namespace {

constexpr int widestPage = 1120; // pixels; longer lines are hard to look through
constexpr int border = 28;
constexpr int iconExtent = 56;

QFont larger(const QFont& font, double factor) {
    QFont result = font;
    result.setPointSizeF(factor * font.pointSizeF());
    result.setBold(true);
    return result;
}

/// The folder, with ~ for the user's own.
QString placeOf(const QString& path) {
    const QString folder = QFileInfo(path).path();
    const QString home = QDir::homePath();
    return folder == home || folder.startsWith(home + QLatin1Char('/')) ? QLatin1Char('~') + folder.mid(home.size())
                                                                        : folder;
}

struct ShippedWords {
    QString name;
    QString description;
};

/// The name by which a shipped level calls itself, and what it says of itself.
ShippedWords wordsIn(const QString& resource) {
    ShippedWords words{QFileInfo(resource).completeBaseName(), {}};
    QFile file(resource);
    if (file.open(QIODevice::ReadOnly)) {
        const LevelFile level = parseLevel(file.readAll().toStdString(), Checks::FileOnly);
        if (level.level && !level.level->name.empty()) {
            words = {QString::fromStdString(level.level->name), QString::fromStdString(level.level->description)};
        }
    }
    return words;
}

} // namespace

QStringList shippedLevels() {
    QStringList levels;
    for (const QString& folder : {QStringLiteral(":/levels"), QStringLiteral(":/levels/sandbox")}) {
        for (const QString& name : QDir(folder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
            levels << folder + QLatin1Char('/') + name;
        }
    }
    return levels;
}

WelcomePage::WelcomePage(QWidget* parent) : QScrollArea(parent), m_column(&m_page) {
    layOut();
    connect(&m_new, &QPushButton::clicked, this, &WelcomePage::newWanted);
    connect(&m_open, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(&m_atStart, &QCheckBox::toggled, this, [](bool on) { Preferences().setWelcomes(on); });
    for (CardGrid* grid : grids()) {
        connect(grid, &CardGrid::cardReached, this, [this](QWidget* card) { ensureWidgetVisible(card); });
    }
    connect(&m_pictures, &LevelPictures::painted, this, [this](const QString& path) {
        for (CardGrid* grid : grids()) {
            for (LevelCard* card : grid->cards()) {
                if (card->path() == path) {
                    showPicture(*card);
                }
            }
        }
    });
    m_shipped.setCards(shippedCards(false));
    m_sandboxes.setCards(shippedCards(true));
}

void WelcomePage::layOut() {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(&m_page);
    setMinimumSize(240, 180);
    setAccessibleName(tr("Welcome"));
    m_title.setText(QStringLiteral("SpaceTow Studio"));
    m_title.setFont(larger(font(), 1.9));
    m_subtitle.setText(tr("Draw a cave, and fly your load out of it."));
    m_subtitle.setWordWrap(true);
    m_icon.setPixmap(applicationIcon().pixmap(QSize(iconExtent, iconExtent), devicePixelRatioF()));
    m_new.setText(tr("&New Level"));
    m_open.setText(tr("&Open…"));
    m_recentTitle.setText(tr("Recent levels"));
    m_shippedTitle.setText(tr("Levels that come with the program; what you open is a copy"));
    m_shippedTitle.setWordWrap(true);
    m_sandboxTitle.setText(tr("Sandboxes: each shows one thing that the physics does, and says what to try"));
    m_sandboxTitle.setWordWrap(true);
    m_atStart.setText(tr("&Show this page at start and when the last level is closed"));
    for (QLabel* title : {&m_recentTitle, &m_shippedTitle, &m_sandboxTitle}) {
        title->setFont(larger(font(), 1.1));
    }
    for (QPushButton* button : {&m_new, &m_open}) {
        button->setIconSize(QSize(20, 20));
        button->setMinimumSize(150, 38);
    }

    m_new.setDefault(true);
    m_new.setAutoDefault(false);         // it stays the default one, whoever has the focus
    m_open.setAutoDefault(true);         // Enter presses it where it has the focus
    auto* const words = new QVBoxLayout; // each layout is owned by the one it is in
    words->setSpacing(2);
    words->addStretch();
    words->addWidget(&m_title);
    words->addWidget(&m_subtitle);
    words->addStretch();
    auto* const head = new QHBoxLayout;
    head->setSpacing(16);
    head->addWidget(&m_icon);
    head->addLayout(words, 1);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(12);
    buttons->addWidget(&m_new);
    buttons->addWidget(&m_open);
    buttons->addStretch();

    auto* const inner = new QVBoxLayout;
    inner->setSpacing(10);
    inner->addLayout(head);
    inner->addSpacing(6);
    inner->addLayout(buttons);
    inner->addSpacing(12);
    inner->addWidget(&m_recentTitle);
    inner->addWidget(&m_recent);
    inner->addSpacing(12);
    inner->addWidget(&m_shippedTitle);
    inner->addWidget(&m_shipped);
    inner->addSpacing(12);
    inner->addWidget(&m_sandboxTitle);
    inner->addWidget(&m_sandboxes);
    inner->addSpacing(12);
    inner->addWidget(&m_atStart);
    auto* const sheet = new QWidget(&m_page);
    sheet->setLayout(inner);
    inner->setContentsMargins(0, 0, 0, 0);
    sheet->setMaximumWidth(widestPage);
    auto* const across = new QHBoxLayout;
    across->addStretch(1);
    across->addWidget(sheet, 1000);
    across->addStretch(1);
    m_column.setContentsMargins(border, border, border, border);
    m_column.addLayout(across);
    m_column.addStretch();
}

std::vector<LevelCard*> WelcomePage::recentCards() {
    std::vector<LevelCard*> cards;
    for (const QString& path : Preferences().recentFiles()) {
        auto* const card = new LevelCard(path, QFileInfo(path).fileName(), placeOf(path), &m_recent);
        connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT fileWanted(path); });
        cards.push_back(card);
    }
    return cards;
}

std::vector<LevelCard*> WelcomePage::shippedCards(bool sandboxes) {
    std::vector<LevelCard*> cards;
    for (const QString& path : shippedLevels()) {
        if (path.contains(QStringLiteral("/sandbox/")) != sandboxes) {
            continue;
        }
        const ShippedWords words = wordsIn(path);
        auto* const card = new LevelCard(path, words.name, sandboxes ? tr("Sandbox") : tr("Level"),
                                         sandboxes ? &m_sandboxes : &m_shipped);
        if (!words.description.isEmpty()) {
            card->setToolTip(plainToolTip(words.description));
        }
        connect(card, &QAbstractButton::clicked, this, [this, path] { Q_EMIT exampleWanted(path); });
        cards.push_back(card);
    }
    return cards;
}

void WelcomePage::refresh() {
    m_recent.setCards(recentCards());
    m_recent.setVisible(!m_recent.cards().empty());
    m_recentTitle.setVisible(!m_recent.cards().empty());
    m_atStart.setChecked(Preferences().welcomes());
    QWidget* before = &m_open;
    for (const CardGrid* grid : grids()) {
        for (LevelCard* card : grid->cards()) {
            setTabOrder(before, card);
            before = card;
        }
    }
    setTabOrder(before, &m_atStart);
    setFocusProxy(m_recent.cards().empty() ? static_cast<QWidget*>(&m_new) : m_recent.cards().front());
    askForPictures();
}

void WelcomePage::askForPictures() {
    m_new.setIcon(spacetow::icon(QStringLiteral("new"), palette().color(QPalette::HighlightedText)));
    m_open.setIcon(spacetow::icon(QStringLiteral("open"), palette()));
    if (isVisible()) {
        for (CardGrid* grid : grids()) {
            for (LevelCard* card : grid->cards()) {
                showPicture(*card);
            }
        }
    }
}

void WelcomePage::showPicture(LevelCard& card) {
    card.setPicture(m_pictures.picture(card.path(), {LevelCard::pictureSize, devicePixelRatioF()}, shadeOf(palette())));
    card.setUnreadable(m_pictures.isUnreadable(card.path()));
}

void WelcomePage::showEvent(QShowEvent* event) {
    QScrollArea::showEvent(event);
    askForPictures();
}

void WelcomePage::changeEvent(QEvent* event) {
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        askForPictures();
    }
}

} // namespace spacetow
