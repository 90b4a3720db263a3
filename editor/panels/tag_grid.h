#pragma once
// The tags of the level as buttons that say their names, for "is" and for "touches": set, not set, or set for some of
// the selected objects only. "Touches" is read as a sentence: "everything", "everything except" with the excepted ones
// crossed out, or the ones that are touched. A double click, F2 or the context menu renames or recolours a tag.

#include "core/level/tag_table.h"
#include "editor/panels/tag_chip.h"

#include <QLineEdit>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// What is known of the masks of the selected objects.
struct TagsShown {
    TagMask any;        // bits set in some of them…
    TagMask every;      // …and in all
    int count = 0;      // of masks
    int exceptions = 0; // of those that are told by what they leave out, see isSpelledByExceptions

    bool operator==(const TagsShown&) const = default;
};

class TagGrid : public QWidget {
    Q_OBJECT

  public:
    /// With `everything` there is a button in front that stands for all tags, those to come included.
    explicit TagGrid(bool everything, QWidget* parent = nullptr);
    ~TagGrid() override;

    void setTags(const TagTable& table, const TagsShown& shown);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange(width, false); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// For tests: the button of a tag, null when the tag is not shown.
    TagChip* chip(int index) const;
    TagChip* everythingChip() const { return m_everything.get(); }

  Q_SIGNALS:
    void tagSwitched(int index, bool on);
    void everythingSwitched(bool on);
    /// The tag was renamed, recoloured or made.
    void tagDefined(int index, const QString& name, const QColor& color);
    /// Likewise of one that had no name, and is meant for what is shown.
    void tagMade(int index, const QString& name, const QColor& color);
    /// All objects with the tag are to be selected.
    void selectionWanted(int index);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Entry {
        int index;
        std::unique_ptr<TagChip> chip;
    };
    int arrange(int width, bool move) const;
    void rebuild(TagMask shown);
    void showEverything(bool isException);
    void openMenu(int index, const QPoint& global);
    void edit(int index);
    void endEdit(bool keep);
    void recolour(int index);
    std::optional<int> freeIndex() const;

    std::unique_ptr<TagChip> m_everything;
    std::vector<Entry> m_entries;
    TagChip m_add;
    QLineEdit m_name;
    TagTable m_table;
    TagsShown m_shown;
    std::optional<int> m_edited;
};

} // namespace spacetow
