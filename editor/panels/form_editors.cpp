// Makes the editors of a form's rows and turns what is entered into edits.
#include "editor/panels/color_field.h"
#include "editor/panels/form.h"
#include "editor/panels/object_field.h"
#include "editor/panels/tag_grid.h"
#include "editor/panels/text_box.h"
#include "editor/panels/text_line.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>

namespace spacetow {

namespace {

/// A choice that the wheel changes only after a click into it, so that scrolling the panel changes nothing.
class ChoiceBox : public QComboBox {
  public:
    ChoiceBox() {
        setFocusPolicy(Qt::StrongFocus);
        setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }

  protected:
    void wheelEvent(QWheelEvent* event) override {
        if (hasFocus()) {
            QComboBox::wheelEvent(event);
        } else {
            event->ignore();
        }
    }
};

} // namespace

void Form::makeEditor(FormRowState& row) {
    switch (row.spec.kind) {
    case RowKind::Number:
        makeNumber(row);
        break;
    case RowKind::Switch:
        makeSwitch(row);
        break;
    case RowKind::Choice:
        makeChoice(row);
        break;
    case RowKind::Background:
        makeBackground(row);
        break;
    case RowKind::Text:
    case RowKind::LongText:
        makeText(row);
        break;
    case RowKind::Body:
    case RowKind::Group:
        makeObject(row);
        break;
    case RowKind::Color:
        makeColor(row);
        break;
    case RowKind::Tags:
    case RowKind::Touches:
        makeTags(row);
        break;
    case RowKind::Points:
        row.editor = std::make_unique<QLabel>();
        break;
    }
    row.editor->setToolTip(rowText(row.spec.meaning));
}

void Form::makeNumber(FormRowState& row) {
    auto field = std::make_unique<NumberField>();
    FormRowState* const at = &row;
    field->enter = [this, at](const NumberEntry& entry) { return enterNumber(*at, entry); };
    field->words = m_target.words;
    connect(field.get(), &NumberField::faultChanged, this, &Form::showFaults);
    row.editor = std::move(field);
}

QString Form::enterNumber(FormRowState& row, const NumberEntry& entry) {
    if (!m_target.edit || !row.shown) {
        return {};
    }
    FormEdit edit;
    edit.phase = entry.phase;
    edit.mayMerge = entry.isStep;
    const char* const unit = row.shown->field.unit;
    if (entry.change) {
        edit.fields.push_back({row.spec.id, [change = *entry.change, unit](const FieldValue& value) {
                                   const double* number = std::get_if<double>(&value);
                                   if (number == nullptr && change.isRelative()) {
                                       return std::optional(value); // nothing to start from
                                   }
                                   const double from = number == nullptr ? 0 : shownNumber(*number, unit);
                                   return std::optional(FieldValue(storedNumber(applied(change, from), unit)));
                               }});
    } else {
        edit.fields.push_back({row.spec.id, [](const FieldValue&) { return std::optional(FieldValue(Unset{})); }});
    }
    return m_target.edit(edit);
}

void Form::makeSwitch(FormRowState& row) {
    auto box = std::make_unique<QCheckBox>(rowText(row.spec.label));
    QCheckBox* const at = box.get();
    connect(at, &QCheckBox::clicked, this, [this, id = std::string(row.spec.id), at] {
        at->setTristate(false); // several values are shown, but never chosen
        change(id, at->isChecked());
    });
    row.editor = std::move(box);
}

void Form::makeText(FormRowState& row) {
    const std::string id = row.spec.id;
    const auto enter = [this, id](const QString& text) { change(id, text.toStdString()); };
    if (row.spec.kind == RowKind::LongText) {
        auto box = std::make_unique<TextBox>();
        connect(box.get(), &TextBox::entered, this, enter);
        row.editor = std::move(box);
    } else {
        auto line = std::make_unique<TextLine>();
        connect(line.get(), &TextLine::entered, this, enter);
        row.editor = std::move(line);
    }
}

void Form::makeChoice(FormRowState& row) {
    auto box = std::make_unique<ChoiceBox>();
    for (const char* choice : row.spec.choices) {
        box->addItem(rowText(choice));
    }
    connect(box.get(), &QComboBox::activated, this,
            [this, id = std::string(row.spec.id)](int index) { change(id, Choice{index}); });
    box->setPlaceholderText(tr("mixed"));
    row.editor = std::move(box);
}

void Form::makeBackground(FormRowState& row) {
    auto box = std::make_unique<ChoiceBox>();
    QComboBox* const at = box.get();
    box->addItem(tr("Stars"), QStringLiteral("stars"));
    box->addItem(tr("Plain"), QStringLiteral("plain"));
    connect(at, &QComboBox::activated, this,
            [this, id = std::string(row.spec.id), at] { change(id, at->currentData().toString().toStdString()); });
    row.editor = std::move(box);
}

void Form::makeObject(FormRowState& row) {
    const bool isGroup = row.spec.kind == RowKind::Group;
    const auto suits = [isGroup](const Object& object) {
        return isGroup ? std::holds_alternative<GroupObject>(object.data)
                       : std::holds_alternative<BodyObject>(object.data);
    };
    auto field = std::make_unique<ObjectField>(suits, isGroup);
    field->level = m_target.level;
    field->enter = [this, id = std::string(row.spec.id)](Key key) {
        return change(id, key == 0 ? FieldValue(Unset{}) : FieldValue(KeyValue{key}));
    };
    field->showObject = m_target.showObject;
    connect(field.get(), &ObjectField::faultChanged, this, &Form::showFaults);
    row.editor = std::move(field);
}

void Form::makeColor(FormRowState& row) {
    auto field = std::make_unique<ColorField>();
    field->enter = [this, id = std::string(row.spec.id)](const QColor& color) {
        change(id, ColorValue{color.rgb() & 0xffffffU});
    };
    row.editor = std::move(field);
}

void Form::makeTags(FormRowState& row) {
    const std::string id = row.spec.id;
    auto grid = std::make_unique<TagGrid>(row.spec.kind == RowKind::Touches);
    const auto switching = [id](int index, bool on) {
        return FormEdit{{{id, [index, on](const FieldValue& value) {
                              const TagMask* mask = std::get_if<TagMask>(&value);
                              const std::uint32_t bits = mask == nullptr ? 0 : mask->bits;
                              const std::uint32_t bit = TagMask::bit(index).bits;
                              return std::optional(FieldValue(TagMask{on ? bits | bit : bits & ~bit}));
                          }}}};
    };
    connect(grid.get(), &TagGrid::tagSwitched, this, [this, switching](int index, bool on) {
        if (m_target.edit) {
            m_target.edit(switching(index, on));
        }
    });
    connect(grid.get(), &TagGrid::everythingSwitched, this,
            [this, id](bool on) { change(id, on ? TagMask::all() : TagMask{}); });
    const auto define = [this](int index, const QString& name, const QColor& color, const FormEdit& edit) {
        if (m_target.defineTag) {
            m_target.defineTag(index, {name.toStdString(), color.rgb() & 0xffffffU}, edit);
        }
    };
    connect(grid.get(), &TagGrid::tagDefined, this,
            [define](int index, const QString& name, const QColor& color) { define(index, name, color, {}); });
    connect(grid.get(), &TagGrid::tagMade, this,
            [define, switching](int index, const QString& name, const QColor& color) {
                define(index, name, color, switching(index, true));
            });
    connect(grid.get(), &TagGrid::selectionWanted, this, [this](int index) {
        if (m_target.selectTagged) {
            m_target.selectTagged(index);
        }
    });
    row.editor = std::move(grid);
}

} // namespace spacetow
