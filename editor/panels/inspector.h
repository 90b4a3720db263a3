#pragma once
// Shows and changes the fields of what is selected, or of the level when nothing is. Follows gestures live; what is
// entered becomes one history entry a field.

#include "editor/editing/document.h"
#include "editor/editing/field_targets.h"
#include "editor/panels/level_panel.h"
#include "editor/panels/motion_line.h"

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QWidget>

namespace spacetow {

class Inspector : public QWidget {
    Q_OBJECT

  public:
    using Words = std::function<QString(const Error&)>;

    /// The document must outlive the inspector; `words` makes a sentence of a code.
    Inspector(Document& document, Words words, QWidget* parent = nullptr);
    ~Inspector() override;

    /// The form in sight.
    const Form& form() const { return m_document.selection().empty() ? m_level.form() : m_objectPage.form(); }
    QScrollArea& page() { return m_document.selection().empty() ? m_level.page() : m_objectPage; }
    QString title() const { return m_title.text(); }
    /// Which shape of a body of several is meant; not in sight for anything else.
    QComboBox& shapeBox() { return m_shapeBox; }

    /// How the selected body moves, while something runs; hidden again by `hideMotion`.
    MotionLine& motion() { return m_motion; }
    void showMotion(const std::optional<Motion>& motion);
    void showTension(double distance, double length, double tension);
    void hideMotion() { m_motion.hide(); }

    /// Which sections are folded up, to be kept from one start of the program to the next.
    QStringList foldedSections() const;
    void foldSections(const QStringList& titles);

    /// Never so narrow that a field would be cut off.
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

  Q_SIGNALS:
    void sectionsFolded();
    /// The user wants to see this one.
    void objectWanted(Key key);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    FormTarget target();
    void refresh();
    void showObjects(const Edit& shown);
    void showShapes(const Object& object);
    std::vector<ShapeRef> shapes(const Selection& selection) const;
    void showTitle(const std::vector<int>& kinds, const Object& last);
    /// The selected object of this number, in any order; null when the level lacks it.
    const Object* selected(const Edit& shown, int index);
    QString make(const FormEdit& edit);
    void defineTag(int index, const TagInfo& info, const FormEdit& edit);

    Document& m_document;
    Words m_words;
    QVBoxLayout m_column;
    QLabel m_title;
    QLabel m_subtitle;
    MotionLine m_motion;
    QVBoxLayout m_shapeRow;
    QComboBox m_shapeBox;
    QStackedWidget m_pages;
    LevelPanel m_level;
    FormPage m_objectPage;
    Selection m_shown;         // what the form shows
    std::vector<int> m_places; // of its objects in the level, as far as they are known
    int m_shape = -1;          // of the only object selected; −1 for all
    int m_listener = 0;
};

} // namespace spacetow
