#include "editor/panels/form.h"

#include "editor/panels/number_field.h"
#include "editor/panels/text_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace spacetow {

namespace {

constexpr int firstColumn = 1; // of the editors
constexpr int columns = 2;

QString translated(const char* words) {
    return *words == '\0' ? QString() : QCoreApplication::translate("Inspector", words);
}

bool isPairEnd(const FormRow& row) {
    return *row.label == '\0';
}

bool isPairStart(const FormRow& row) {
    return std::string_view(row.id).ends_with(".x");
}

/// Labels of masks stand above the buttons, those of switches are part of them.
bool hasWideEditor(RowKind kind) {
    return kind == RowKind::Tags || kind == RowKind::Touches || kind == RowKind::Switch;
}

} // namespace

Form::Form(std::span<const FormRow> rows, QWidget* parent) : QWidget(parent), m_grid(this) {
    m_grid.setContentsMargins(10, 6, 10, 10);
    m_grid.setHorizontalSpacing(8);
    m_grid.setVerticalSpacing(6);
    m_grid.setColumnStretch(firstColumn, 1);
    m_grid.setColumnStretch(firstColumn + 1, 1);
    for (const FormRow& row : rows) {
        addRow(row);
    }
    m_grid.setRowStretch(m_grid.rowCount(), 1);
    m_fullWidth = measured();
}

Form::~Form() = default;

int Form::measured() {
    NumberSpec widest;
    widest.unit = QStringLiteral("kg/m²");
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        row->editor->ensurePolished();
        if (row->spec.kind == RowKind::Number) {
            static_cast<NumberField&>(*row->editor).setSpec(widest);
        }
    }
    return m_grid.totalMinimumSize().width();
}

void Form::addRow(const FormRow& spec) {
    auto row = std::make_unique<FormRowState>();
    row->spec = spec;
    const bool newSection = m_rows.empty() || std::string_view(m_rows.back()->spec.section) != spec.section;
    int line = m_grid.rowCount();
    if (newSection) {
        row->heading = std::make_unique<QLabel>(translated(spec.section));
        QFont font = row->heading->font();
        font.setBold(true);
        row->heading->setFont(font);
        row->heading->setContentsMargins(0, m_rows.empty() ? 0 : 8, 0, 0);
        m_grid.addWidget(row->heading.get(), line++, 0, 1, firstColumn + columns);
    }
    makeEditor(*row);
    row->editor->setObjectName(QString::fromLatin1(spec.id));
    if (isPairEnd(spec)) {
        m_grid.addWidget(row->editor.get(), line - 1, firstColumn + 1);
        row->editor->setAccessibleName(m_rows.back()->editor->accessibleName().chopped(1) + QLatin1Char('y'));
    } else {
        const QString words = translated(spec.label);
        row->editor->setAccessibleName(isPairStart(spec) ? words + QStringLiteral(" x") : words);
        if (spec.kind != RowKind::Switch) {
            row->label = std::make_unique<QLabel>(words);
            row->label->setBuddy(row->editor.get());
            const bool above = hasWideEditor(spec.kind);
            m_grid.addWidget(row->label.get(), line, 0, 1, above ? firstColumn + columns : 1,
                             spec.kind == RowKind::LongText ? Qt::AlignTop : Qt::Alignment());
            line += above ? 1 : 0;
        }
        const bool wide = hasWideEditor(spec.kind);
        m_grid.addWidget(row->editor.get(), line, wide ? 0 : firstColumn, 1,
                         wide ? firstColumn + columns : (isPairStart(spec) ? 1 : columns));
    }
    m_rows.push_back(std::move(row));
}

void Form::makeEditor(FormRowState& row) {
    const QString id = QString::fromLatin1(row.spec.id);
    switch (row.spec.kind) {
    case RowKind::Number: {
        auto field = std::make_unique<NumberField>();
        connect(field.get(), &NumberField::entered, this, [this, id, &row](std::optional<double> number) {
            Q_EMIT entered(id, number ? FieldValue(*number / row.scale) : FieldValue(Unset{}));
        });
        row.editor = std::move(field);
        break;
    }
    case RowKind::Switch: {
        auto box = std::make_unique<QCheckBox>(translated(row.spec.label));
        QCheckBox* const at = box.get();
        connect(at, &QCheckBox::clicked, this, [this, id, at] {
            at->setTristate(false);
            Q_EMIT entered(id, at->isChecked());
        });
        row.editor = std::move(box);
        break;
    }
    case RowKind::Text: {
        auto line = std::make_unique<QLineEdit>();
        QLineEdit* const at = line.get();
        connect(at, &QLineEdit::editingFinished, this, [this, id, at] {
            if (at->isModified()) {
                at->setModified(false);
                Q_EMIT entered(id, at->text().toStdString());
            }
        });
        row.editor = std::move(line);
        break;
    }
    case RowKind::LongText: {
        auto box = std::make_unique<TextBox>();
        connect(box.get(), &TextBox::entered, this,
                [this, id](const QString& text) { Q_EMIT entered(id, text.toStdString()); });
        row.editor = std::move(box);
        break;
    }
    case RowKind::Choice:
    case RowKind::Background:
        makeChoice(row);
        break;
    case RowKind::Tags:
    case RowKind::Touches:
        makeTags(row);
        break;
    }
}

void Form::makeChoice(FormRowState& row) {
    const QString id = QString::fromLatin1(row.spec.id);
    auto box = std::make_unique<QComboBox>();
    QComboBox* const at = box.get();
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    if (row.spec.kind == RowKind::Background) {
        box->addItem(tr("Stars"), QStringLiteral("stars"));
        box->addItem(tr("Plain"), QStringLiteral("plain"));
        connect(at, &QComboBox::activated, this,
                [this, id, at] { Q_EMIT entered(id, at->currentData().toString().toStdString()); });
    } else {
        for (const char* choice : row.spec.choices) {
            box->addItem(translated(choice));
        }
        connect(at, &QComboBox::activated, this, [this, id](int index) { Q_EMIT entered(id, Choice{index}); });
    }
    box->setPlaceholderText(tr("mixed"));
    box->setFocusPolicy(Qt::StrongFocus);
    row.editor = std::move(box);
}

void Form::makeTags(FormRowState& row) {
    const QString id = QString::fromLatin1(row.spec.id);
    auto grid = std::make_unique<TagGrid>(row.spec.kind == RowKind::Touches);
    connect(grid.get(), &TagGrid::tagSwitched, this,
            [this, id](int index, bool on) { Q_EMIT tagSwitched(id, index, on); });
    connect(grid.get(), &TagGrid::everythingSwitched, this,
            [this, id](bool on) { Q_EMIT entered(id, on ? TagMask::all() : TagMask{}); });
    connect(grid.get(), &TagGrid::tagDefined, this, &Form::tagDefined);
    row.editor = std::move(grid);
}

void Form::setThings(const std::vector<std::vector<FieldEntry>>& things, const TagTable& tags) {
    std::unordered_map<std::string, FormShown> all;
    for (const std::vector<FieldEntry>& fields : things) {
        for (const FieldEntry& entry : fields) {
            FormShown& shown = all[entry.id];
            ++shown.count;
            shown.mayBeUnset = shown.mayBeUnset && entry.mayBeUnset;
            if (shown.first == nullptr) {
                shown.first = &entry;
            } else if (!(shown.first->value == entry.value)) {
                shown.mixed = true;
            }
            if (const TagMask* mask = std::get_if<TagMask>(&entry.value)) {
                shown.masks.push_back(*mask);
            }
        }
    }
    QLabel* heading = nullptr;
    bool anyInSection = false;
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (row->heading) {
            if (heading != nullptr) {
                heading->setVisible(anyInSection);
            }
            heading = row->heading.get();
            anyInSection = false;
        }
        const auto found = all.find(row->spec.id);
        const bool shared = found != all.end() && found->second.count == static_cast<int>(things.size());
        show(*row, shared ? &found->second : nullptr, tags);
        anyInSection = anyInSection || shared;
    }
    if (heading != nullptr) {
        heading->setVisible(anyInSection);
    }
}

QWidget* Form::editor(const QString& id) const {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (id == QLatin1String(row->spec.id)) {
            return row->editor.get();
        }
    }
    return nullptr;
}

} // namespace spacetow
