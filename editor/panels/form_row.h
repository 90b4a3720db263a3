#pragma once
// What a form keeps of each row, and what is to be shown in it.

#include "editor/panels/field_access.h"
#include "editor/panels/form_rows.h"

#include <QLabel>
#include <QWidget>

#include <memory>
#include <vector>

namespace spacetow {

struct FormRowState {
    FormRow spec;
    std::unique_ptr<QLabel> heading; // above the first row of a section
    std::unique_ptr<QLabel> label;
    std::unique_ptr<QWidget> editor;
    double scale = 1; // shown per stored
};

/// One field over all the things that are shown.
struct FormShown {
    const FieldEntry* first = nullptr;
    bool mixed = false;
    bool mayBeUnset = true; // in all of them
    int count = 0;
    std::vector<TagMask> masks;
};

} // namespace spacetow
