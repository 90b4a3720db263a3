// How the rows of a form show values.
#include "editor/panels/color_field.h"
#include "editor/panels/form.h"
#include "editor/panels/object_field.h"
#include "editor/panels/tag_grid.h"
#include "editor/panels/text_box.h"
#include "editor/panels/text_line.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>

namespace spacetow {

namespace {

template <class T>
const T* shared(const FieldSummary& summary) {
    return summary.isMixed ? nullptr : std::get_if<T>(&summary.value);
}

void showNumber(NumberField& field, const FormRow& row, const FieldSummary& summary) {
    const char* const unit = summary.field.unit;
    NumberSpec spec;
    spec.unit = QString::fromUtf8(shownUnit(unit));
    spec.min = shownNumber(summary.field.min, unit);
    spec.max = shownNumber(summary.field.max, unit);
    spec.openMin = summary.field.openMin;
    spec.whole = summary.isWhole;
    spec.mayBeEmpty = summary.mayBeUnset;
    spec.none = rowText(row.none);
    spec.step = row.step;
    spec.meaning = rowText(row.meaning);
    field.setSpec(spec);
    if (summary.isMixed) {
        field.setMixed();
    } else if (const double* number = shared<double>(summary)) {
        field.setValue(shownNumber(*number, unit));
    } else {
        field.setValue({});
    }
}

void showSwitch(QCheckBox& box, const FieldSummary& summary) {
    const bool* on = shared<bool>(summary);
    box.setTristate(on == nullptr);
    box.setCheckState(on == nullptr ? Qt::PartiallyChecked : *on ? Qt::Checked : Qt::Unchecked);
}

void showText(TextLine& line, const FieldSummary& summary) {
    const std::string* text = shared<std::string>(summary);
    line.setValue(text == nullptr ? QString() : QString::fromStdString(*text));
    line.setPlaceholderText(text == nullptr ? QCoreApplication::translate("Inspector", "mixed") : QString());
}

void showBackground(QComboBox& box, const FieldSummary& summary) {
    const QString name = QString::fromStdString(std::get<std::string>(summary.value));
    if (box.findData(name) < 0) {
        box.addItem(name, name);
    }
    box.setCurrentIndex(box.findData(name));
}

void showObject(ObjectField& field, const FieldSummary& summary) {
    const KeyValue* key = std::get_if<KeyValue>(&summary.value);
    field.setValue(summary.isMixed ? std::nullopt : std::optional(key == nullptr ? Key(0) : key->key));
}

void showColor(ColorField& field, const FieldSummary& summary) {
    const ColorValue* color = shared<ColorValue>(summary);
    field.setValue(color == nullptr ? QColor() : QColor::fromRgb(color->rgb), summary.isMixed);
}

void showPoints(QLabel& label, const FieldSummary& summary) {
    const PointCount* points = shared<PointCount>(summary);
    label.setText(points == nullptr ? QCoreApplication::translate("Inspector", "mixed")
                                    : QLocale().toString(points->count));
}

} // namespace

void Form::showRow(FormRowState& row, const FieldSummary* summary, const FormContent& content) {
    const bool isSame = summary != nullptr && row.shown == *summary && row.things == content.things;
    const bool needsLevel = row.spec.kind == RowKind::Tags || row.spec.kind == RowKind::Touches ||
                            row.spec.kind == RowKind::Body || row.spec.kind == RowKind::Group;
    if (summary == nullptr || (isSame && (!needsLevel || content.isLive))) {
        row.shown = summary == nullptr ? std::nullopt : row.shown;
        return;
    }
    row.shown = *summary;
    row.things = content.things;
    if (row.label) {
        const bool isPartial = summary->count < content.things;
        row.label->setForegroundRole(isPartial ? QPalette::PlaceholderText : QPalette::WindowText);
        row.label->setToolTip(
            isPartial ? tr("%1 of the %2 selected objects have this.").arg(summary->count).arg(content.things)
                      : rowText(row.spec.meaning));
    }
    QWidget& editor = *row.editor;
    switch (row.spec.kind) {
    case RowKind::Number:
        showNumber(static_cast<NumberField&>(editor), row.spec, *summary);
        break;
    case RowKind::Switch:
        showSwitch(static_cast<QCheckBox&>(editor), *summary);
        break;
    case RowKind::Choice: {
        const Choice* choice = shared<Choice>(*summary);
        static_cast<QComboBox&>(editor).setCurrentIndex(choice == nullptr ? -1 : choice->index);
        break;
    }
    case RowKind::Background:
        showBackground(static_cast<QComboBox&>(editor), *summary);
        break;
    case RowKind::Text:
        showText(static_cast<TextLine&>(editor), *summary);
        break;
    case RowKind::LongText:
        static_cast<TextBox&>(editor).setValue(QString::fromStdString(std::get<std::string>(summary->value)));
        break;
    case RowKind::Body:
    case RowKind::Group:
        showObject(static_cast<ObjectField&>(editor), *summary);
        break;
    case RowKind::Color:
        showColor(static_cast<ColorField&>(editor), *summary);
        break;
    case RowKind::Points:
        showPoints(static_cast<QLabel&>(editor), *summary);
        break;
    case RowKind::Tags:
    case RowKind::Touches:
        static_cast<TagGrid&>(editor).setTags(m_target.level().tags,
                                              {summary->any, summary->every, summary->count, summary->exceptions});
        break;
    }
}

} // namespace spacetow
