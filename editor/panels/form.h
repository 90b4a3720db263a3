#pragma once
// A form made from a table of rows: shows what one thing or several at once have in each field, and turns what the user
// enters into edits of fields. Rows that nothing has are hidden, and so are those of sections that are folded up.

#include "core/level/field_edits.h"
#include "core/level/field_survey.h"
#include "editor/panels/form_row.h"
#include "editor/panels/number_field.h"

#include <QGridLayout>
#include <QIcon>
#include <QWidget>

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace spacetow {

/// Made together, as one undo step.
struct FormEdit {
    std::vector<FieldEdit> fields;
    NumberEntry::Phase phase = NumberEntry::Phase::Final;
    bool mayMerge = false; // with the one before, as steps of the arrow keys do
};

/// The id of the field that the edit is about, of both parts of a point without the axis; empty for several fields.
std::string changedField(const FormEdit& edit);

/// What a form needs from whoever shows it. The empty ones are not called.
struct FormTarget {
    /// Makes the edit and answers with an objection, empty for none.
    std::function<QString(const FormEdit&)> edit;
    std::function<QString(const Error&)> words;
    std::function<const Level&()> level; // that is shown
    /// With an edit that goes with it in one step, as where one is made for what is selected.
    std::function<void(int, const TagInfo&, const FormEdit&)> defineTag;
    std::function<void(int)> selectTagged;
    std::function<void(Key)> showObject;
};

/// What is shown.
struct FormContent {
    std::vector<FieldSummary> fields;
    int things = 1;
    bool isLive = false; // a gesture is under way, and names do not change
};

class Form : public QWidget {
    Q_OBJECT

  public:
    Form(std::span<const FormRow> rows, FormTarget target, QWidget* parent = nullptr);
    ~Form() override;

    void setContent(const FormContent& content);
    /// Forgets what is being typed, because something else is going to be shown.
    void revert();

    /// The width at which no row would be cut off, be it in sight or not.
    int fullWidth() const { return m_fullWidth; }
    /// The same with labels above their fields, and without what explains them.
    int narrowWidth() const { return m_narrowWidth; }
    void setNarrow(bool narrow);

    /// Titles of the sections that are folded up, in the language of the program's sources.
    QStringList foldedSections() const;
    void foldSections(const QStringList& titles);

    /// The widgets of a field, for tests and for the focus; null for an unknown one.
    QWidget* editor(const QString& id) const;
    QAbstractButton* resetButton(const QString& id) const;
    QLabel* faultLabel(const QString& id) const;
    QAbstractButton* sectionHeader(const QString& title) const;

  Q_SIGNALS:
    void sectionsFolded();
    /// Beneath what was typed there is a new sentence.
    void faultShown(QWidget* sentence);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void addRow(const FormRow& spec);
    void addHeader(FormRowState& row, int line);
    void addReset(FormRowState& row, int line);
    void placeLabel(const FormRowState& row);
    void makeEditor(FormRowState& row);
    void makeNumber(FormRowState& row);
    void makeSwitch(FormRowState& row);
    void makeChoice(FormRowState& row);
    void makeBackground(FormRowState& row);
    void makeText(FormRowState& row);
    void makeObject(FormRowState& row);
    void makeColor(FormRowState& row);
    void makeTags(FormRowState& row);

    /// Shows the summary in the row's editor; null hides it.
    void showRow(FormRowState& row, const FieldSummary* summary, const FormContent& content);
    /// Of a row.
    struct Seen {
        bool header = false;
        bool editor = false;
        bool reset = false;

        bool operator==(const Seen&) const = default;
    };
    std::vector<Seen> arrangement() const;
    void arrangeSections();
    void showFaults();
    void tint();

    QString change(const std::string& id, const FieldValue& value);
    QString enterNumber(FormRowState& row, const NumberEntry& entry);
    void reset(FormRowState& row);
    int measured();

    FormTarget m_target;
    QGridLayout m_grid;
    QIcon m_resetIcon;
    int m_fullWidth = 0;
    int m_narrowWidth = 0;
    bool m_narrow = false;
    std::set<std::string> m_folded;
    std::vector<std::unique_ptr<FormRowState>> m_rows; // rows stay where they are
    std::vector<Seen> m_arrangement;                   // as they are shown
};

} // namespace spacetow
