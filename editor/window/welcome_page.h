#pragma once
// What a window shows while it holds no level: levels to go on with, levels to begin from, and the way to a new one.

#include "editor/window/card_grid.h"
#include "editor/window/level_pictures.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <array>

namespace spacetow {

/// The resources with the levels that come with the program.
QStringList shippedLevels();

class WelcomePage : public QScrollArea {
    Q_OBJECT

  public:
    explicit WelcomePage(QWidget* parent = nullptr);

    /// Shows the recent files, newest first, and the levels that come with the program as they are now.
    void refresh();
    CardGrid& recent() { return m_recent; }
    /// Games that come with the program, and sandboxes.
    CardGrid& shipped() { return m_shipped; }
    CardGrid& sandboxes() { return m_sandboxes; }
    QPushButton& newButton() { return m_new; }
    QPushButton& openButton() { return m_open; }
    QCheckBox& atStart() { return m_atStart; }
    LevelPictures& pictures() { return m_pictures; }

  Q_SIGNALS:
    void newWanted();
    void openWanted();
    void fileWanted(const QString& path);
    void exampleWanted(const QString& resource);

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void layOut();
    std::vector<LevelCard*> recentCards();
    std::vector<LevelCard*> shippedCards(bool sandboxes);
    std::array<CardGrid*, 3> grids() { return {&m_recent, &m_shipped, &m_sandboxes}; }
    void askForPictures();
    void showPicture(LevelCard& card);

    QWidget m_page;
    QVBoxLayout m_column;
    QLabel m_icon;
    QLabel m_title;
    QLabel m_subtitle;
    QPushButton m_new;
    QPushButton m_open;
    QLabel m_recentTitle;
    CardGrid m_recent;
    QLabel m_shippedTitle;
    CardGrid m_shipped;
    QLabel m_sandboxTitle;
    CardGrid m_sandboxes;
    QCheckBox m_atStart;
    LevelPictures m_pictures; // last, so that nothing is painted for who is gone
};

} // namespace spacetow
