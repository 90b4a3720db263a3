#pragma once
// A form made from a table of rows: shows the values of one thing or of several at once, and says what the user enters.
// Rows that nothing has are hidden. Values are in the units of the file.

#include "core/level/tag_table.h"
#include "editor/panels/field_access.h"
#include "editor/panels/form_row.h"
#include "editor/panels/tag_grid.h"

#include <QGridLayout>
#include <QWidget>

#include <memory>
#include <vector>

namespace spacetow {

class Form : public QWidget {
    Q_OBJECT

  public:
    explicit Form(std::span<const FormRow> rows, QWidget* parent = nullptr);
    ~Form() override;

    /// The fields of each thing that is shown.
    void setThings(const std::vector<std::vector<FieldEntry>>& things, const TagTable& tags);

    /// The width at which no row would be cut off, be it in sight or not.
    int fullWidth() const { return m_fullWidth; }

    /// The widget that edits this field, for tests and for the focus; null for an unknown one.
    QWidget* editor(const QString& id) const;

  Q_SIGNALS:
    void entered(const QString& id, const spacetow::FieldValue& value);
    /// Of the masks "tags" or "touches": one bit of every thing.
    void tagSwitched(const QString& id, int index, bool on);
    void tagDefined(int index, const QString& name, const QColor& color);

  private:
    void addRow(const FormRow& spec);
    void makeEditor(FormRowState& row);
    void makeChoice(FormRowState& row);
    void makeTags(FormRowState& row);
    void show(FormRowState& row, const FormShown* shown, const TagTable& tags);

    int measured();

    QGridLayout m_grid;
    int m_fullWidth = 0;
    std::vector<std::unique_ptr<FormRowState>> m_rows; // rows stay where they are
};

} // namespace spacetow
