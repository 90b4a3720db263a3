#pragma once
// The tags of the level as buttons that say their names, for "is" and for "touches": set, not set, or set for some of
// the selected objects only. A double click, F2 or the context menu renames or recolours a tag.

#include "core/level/tag_table.h"
#include "editor/panels/tag_chip.h"

#include <QLineEdit>
#include <QWidget>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace spacetow {

class TagGrid : public QWidget {
    Q_OBJECT

  public:
    /// With `everything` there is a button in front that stands for all tags, those to come included.
    explicit TagGrid(bool everything, QWidget* parent = nullptr);
    ~TagGrid() override;

    /// The table of the level, and the masks of the selected objects.
    void setTags(const TagTable& table, std::span<const TagMask> masks);

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
    void openMenu(int index, const QPoint& global);
    void edit(int index);
    /// Why the tag cannot have this name; empty when it can.
    QString objectionTo(const QString& name, int index) const;
    void endEdit(bool keep);
    void recolour(int index);
    std::optional<int> freeIndex() const;

    std::unique_ptr<TagChip> m_everything;
    std::vector<Entry> m_entries;
    TagChip m_add;
    QLineEdit m_name;
    TagTable m_table;
    std::optional<int> m_edited;
};

} // namespace spacetow
