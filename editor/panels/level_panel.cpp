#include "editor/panels/level_panel.h"

#include "core/level/edits.h"
#include "editor/panels/form_rows.h"

namespace spacetow {

LevelPanel::LevelPanel(Document& document, Words words, QWidget* parent)
    : QWidget(parent), m_document(document), m_column(this), m_page(levelRows(), target(std::move(words))) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.addWidget(&m_page);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (isVisible() && change.before.level != change.after.level) {
            refresh();
        }
    });
    refresh();
}

LevelPanel::~LevelPanel() {
    m_document.changed.disconnect(m_listener);
}

FormTarget LevelPanel::target(Words words) {
    FormTarget target;
    target.edit = [this](const FormEdit& edit) { return make(edit); };
    target.words = std::move(words);
    target.level = [this]() -> const Level& { return m_document.level(); };
    return target;
}

void LevelPanel::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void LevelPanel::refresh() {
    FieldSurvey survey;
    survey.add(m_document.level());
    form().setContent({survey.summaries(), 1, m_document.hasPreview()});
}

QString LevelPanel::make(const FormEdit& edit) {
    if (edit.phase == NumberEntry::Phase::Cancelled) {
        m_document.dropPreview();
        return {};
    }
    const Edit current = m_document.current();
    Level level = *current.level;
    for (const FieldEdit& field : edit.fields) {
        FieldEditResult result = withLevelFieldEdited(std::move(level), field);
        if (result.refused > 0) {
            return tr("That would leave the range of the field, so nothing has changed.");
        }
        level = std::move(result.level);
    }
    Edit made{std::make_shared<const Level>(std::move(level)), current.selection};
    if (edit.phase == NumberEntry::Phase::Preview) {
        m_document.preview(std::move(made));
        return {};
    }
    const bool merges = edit.mayMerge && !edit.fields.empty();
    m_document.commit({"change-level", 1, changedField(edit)}, std::move(made),
                      merges ? "level field " + edit.fields.front().id : "");
    refresh();
    return {};
}

} // namespace spacetow
