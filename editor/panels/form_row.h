#pragma once
// What a form keeps of each row.

#include "core/level/field_survey.h"
#include "editor/panels/fault_label.h"
#include "editor/panels/form_rows.h"
#include "editor/panels/section_header.h"

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include <memory>
#include <optional>

namespace spacetow {

struct FormRowState {
    FormRow spec;
    std::unique_ptr<SectionHeader> header; // above the first row of a section
    std::unique_ptr<QLabel> label;         // the second part of a pair has none, and none of the three that follow
    int labelLine = -1; // of a label that a narrow form has above the editor, which is in the next line
    std::unique_ptr<QToolButton> reset;
    std::unique_ptr<FaultLabel> fault; // beneath
    std::unique_ptr<QWidget> editor;
    FormRowState* pairStart = nullptr; // of the second part of a pair
    std::optional<FieldSummary> shown;
    int things = 0; // among which it was shown
};

} // namespace spacetow
