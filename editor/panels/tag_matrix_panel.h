#pragma once
// The panel of the tag matrix: shows which tags meet in the level and makes the edits.

#include "editor/editing/document.h"
#include "editor/panels/tag_matrix_view.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class TagMatrixPanel : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the panel.
    explicit TagMatrixPanel(Document& document, QWidget* parent = nullptr);
    ~TagMatrixPanel() override;

    TagMatrixView& view() { return m_view; }
    QLineEdit& nameLine() { return m_name; }
    /// A button for the action that shows what the selection collides with.
    void setAction(QAction& action) { m_highlight.setDefaultAction(&action); }

    void rename(int tag);
    /// Of the run that goes on, or was the last.
    void showTouches(const TagTouches& touches) { m_view.setTouches(touches); }

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    void commit(const Label& label, Level level);
    void openMenu(int tag, const QPoint& global);
    void endRename(bool keep);
    void selectTagged(int tag);

    Document& m_document;
    QVBoxLayout m_column;
    QToolButton m_highlight;
    QScrollArea m_page;
    TagMatrixView m_view;
    QLabel m_note;
    QLineEdit m_name;
    int m_renamed = -1;
    std::shared_ptr<const Level> m_shown;
    int m_listener = 0;
};

} // namespace spacetow
