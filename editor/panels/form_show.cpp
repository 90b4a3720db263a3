// How the rows of a form show values.
#include "editor/panels/form.h"
#include "editor/panels/form_row.h"
#include "editor/panels/number_field.h"
#include "editor/panels/text_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>

namespace spacetow {

namespace {

void showNumber(NumberField& field, const FormRow& row, const FormShown& shown) {
    const FieldEntry& entry = *shown.first;
    const double scale = shownPerStored(entry.field.unit);
    NumberSpec spec;
    spec.unit = QString::fromUtf8(shownUnit(entry.field.unit));
    spec.min = entry.field.min * scale;
    spec.max = entry.field.max * scale;
    spec.openMin = entry.field.openMin;
    spec.whole = entry.whole;
    spec.mayBeEmpty = shown.mayBeUnset;
    spec.none = *row.none == '\0' ? QString() : QCoreApplication::translate("Inspector", row.none);
    spec.step = row.step;
    field.setSpec(spec);
    if (shown.mixed) {
        field.setMixed();
    } else if (const double* number = std::get_if<double>(&entry.value)) {
        field.setValue(*number * scale);
    } else {
        field.setValue({});
    }
}

void showSwitch(QCheckBox& box, const FormShown& shown) {
    box.setTristate(shown.mixed);
    box.setCheckState(shown.mixed                          ? Qt::PartiallyChecked
                      : std::get<bool>(shown.first->value) ? Qt::Checked
                                                           : Qt::Unchecked);
}

void showText(QLineEdit& line, const FormShown& shown) {
    if (line.hasFocus() && line.isModified()) {
        return;
    }
    const QString text = shown.mixed ? QString() : QString::fromStdString(std::get<std::string>(shown.first->value));
    if (line.text() != text) {
        line.setText(text);
    }
    line.setModified(false);
    line.setPlaceholderText(shown.mixed ? QCoreApplication::translate("Inspector", "mixed") : QString());
}

void showBackground(QComboBox& box, const FormShown& shown) {
    const QString name = QString::fromStdString(std::get<std::string>(shown.first->value));
    if (box.findData(name) < 0) {
        box.addItem(name, name);
    }
    box.setCurrentIndex(box.findData(name));
}

} // namespace

void Form::show(FormRowState& row, const FormShown* shown, const TagTable& tags) {
    row.editor->setVisible(shown != nullptr);
    if (row.label) {
        row.label->setVisible(shown != nullptr);
    }
    if (shown == nullptr) {
        return;
    }
    QWidget* const editor = row.editor.get();
    switch (row.spec.kind) {
    case RowKind::Number:
        row.scale = shownPerStored(shown->first->field.unit);
        showNumber(static_cast<NumberField&>(*editor), row.spec, *shown);
        break;
    case RowKind::Switch:
        showSwitch(static_cast<QCheckBox&>(*editor), *shown);
        break;
    case RowKind::Choice:
        static_cast<QComboBox&>(*editor).setCurrentIndex(shown->mixed ? -1
                                                                      : std::get<Choice>(shown->first->value).index);
        break;
    case RowKind::Background:
        showBackground(static_cast<QComboBox&>(*editor), *shown);
        break;
    case RowKind::Text:
        showText(static_cast<QLineEdit&>(*editor), *shown);
        break;
    case RowKind::LongText:
        static_cast<TextBox&>(*editor).setValue(QString::fromStdString(std::get<std::string>(shown->first->value)));
        break;
    case RowKind::Tags:
    case RowKind::Touches:
        static_cast<TagGrid&>(*editor).setTags(tags, shown->masks);
        break;
    }
}

} // namespace spacetow
