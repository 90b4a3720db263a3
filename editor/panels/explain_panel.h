#pragma once
// Why what is selected moves as it does: its forces, contacts, tags touched, energy and momentum, while a session runs
// or as it stands at the start. Of two objects it says why they do not collide, with a button for the cure.

#include "core/game/session.h"
#include "editor/editing/collision_cure.h"
#include "editor/editing/document.h"
#include "editor/panels/explain_rows.h"

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

namespace spacetow {

class ExplainPanel : public QWidget {
    Q_OBJECT

  public:
    using Words = std::function<QString(const Error&)>;

    /// The document must outlive the panel; `words` makes a sentence of a code.
    ExplainPanel(Document& document, Words words, QWidget* parent = nullptr);
    ~ExplainPanel() override;

    /// Null: there is none yet. Is read some ten times a second, however often it comes.
    void showSession(std::shared_ptr<const Session> session);
    void refresh();

    QLabel& answer() { return m_answer; }
    QPushButton& cure() { return m_cure; }
    QTreeWidget& rows() { return m_rows; }
    /// The object that is explained; 0: the world.
    Key explained() const { return m_object; }

    QSize sizeHint() const override { return {310, 260}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

  Q_SIGNALS:
    /// The user wants to see this object.
    void objectWanted(spacetow::Key key);
    /// Another object is explained, or none is, or the panel has gone out of sight.
    void explainedChanged();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void layOut();
    void refreshSoon();
    void showAnswer(const std::vector<Key>& keys);
    void showSections(const std::vector<ExplainSection>& sections);
    void carryOut();
    void follow(QTreeWidgetItem* item);

    Document& m_document;
    Words m_words;
    QVBoxLayout m_column;
    QLabel m_title;
    QLabel m_answer;
    QPushButton m_cure;
    QTreeWidget m_rows;
    QTimer m_pause; // between two looks
    bool m_stale = false;
    std::shared_ptr<const Session> m_session;
    Key m_object = 0;
    std::optional<CollisionCure> m_offered;
    int m_listener = 0;
};

} // namespace spacetow
