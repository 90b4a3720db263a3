#include "editor/panels/form.h"

#include "editor/canvas/icons.h"
#include "editor/panels/object_field.h"
#include "editor/panels/scrub_label.h"
#include "editor/panels/text_line.h"

#include <QCheckBox>
#include <QCoreApplication>

#include <algorithm>
#include <string_view>
#include <utility>

namespace spacetow {

namespace {

constexpr int firstColumn = 1; // of the editors
constexpr int columns = 2;
constexpr int resetColumn = firstColumn + columns;
constexpr int allColumns = resetColumn + 1;

/// In a row that is seen the arrow keeps its place while it is hidden, so that nothing beside it moves.
QSizePolicy resetPolicy(bool keepsPlace) {
    QSizePolicy policy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    policy.setRetainSizeWhenHidden(keepsPlace);
    return policy;
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

std::string changedField(const FormEdit& edit) {
    const std::vector<FieldEdit>& fields = edit.fields;
    if (fields.size() == 1) {
        return fields.front().id;
    }
    const bool isPoint = fields.size() == 2 && fields[0].id.ends_with(".x") && fields[1].id.ends_with(".y");
    const std::string name = isPoint ? fields[0].id.substr(0, fields[0].id.size() - 2) : std::string();
    return isPoint && fields[1].id.starts_with(name) ? name : std::string();
}

Form::Form(std::span<const FormRow> rows, FormTarget target, QWidget* parent)
    : QWidget(parent), m_target(std::move(target)), m_grid(this) {
    m_grid.setContentsMargins(10, 2, 6, 10);
    m_grid.setHorizontalSpacing(6);
    m_grid.setVerticalSpacing(5);
    m_grid.setColumnStretch(firstColumn, 1);
    m_grid.setColumnStretch(firstColumn + 1, 1);
    tint();
    for (const FormRow& row : rows) {
        addRow(row);
    }
    m_grid.setRowStretch(m_grid.rowCount(), 1);
    m_fullWidth = measured();
    setNarrow(true);
    m_narrowWidth = measured();
    setNarrow(false);
}

Form::~Form() {
    m_target = {}; // fields that lose the focus while they go change nothing any more
}

int Form::measured() {
    NumberSpec widest;
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        row->editor->ensurePolished();
        if (row->spec.kind == RowKind::Number) {
            const bool isOfPair = isPairStart(row->spec) || isPairEnd(row->spec);
            widest.unit = isOfPair ? QStringLiteral("m/s²") : QStringLiteral("kg/m²");
            static_cast<NumberField&>(*row->editor).setSpec(widest);
        }
    }
    return m_grid.totalMinimumSize().width();
}

void Form::setNarrow(bool narrow) {
    if (narrow == m_narrow) {
        return;
    }
    m_narrow = narrow;
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (row->labelLine >= 0) {
            m_grid.removeWidget(row->label.get());
            placeLabel(*row);
        }
        if (auto* const box = qobject_cast<QCheckBox*>(row->editor.get())) {
            const QString words = rowText(row->spec.label);
            box->setText(narrow ? words.section(QLatin1Char(':'), 0, 0) : words);
            box->setToolTip(box->text() == words ? QString() : words);
        }
    }
}

void Form::placeLabel(const FormRowState& row) {
    const Qt::Alignment side = row.spec.kind == RowKind::LongText ? Qt::AlignTop : Qt::Alignment();
    if (m_narrow) {
        m_grid.addWidget(row.label.get(), row.labelLine, 0, 1, allColumns);
    } else {
        m_grid.addWidget(row.label.get(), row.labelLine + 1, 0, side);
    }
}

void Form::addHeader(FormRowState& row, int line) {
    auto header = std::make_unique<SectionHeader>(rowText(row.spec.section));
    header->setObjectName(QString::fromLatin1(row.spec.section));
    header->setToolTip(tr("Fold or unfold this section"));
    const std::string section = row.spec.section;
    connect(header.get(), &SectionHeader::toggled, this, [this, section](bool open) {
        if (open) {
            m_folded.erase(section);
        } else {
            m_folded.insert(section);
        }
        arrangeSections();
        Q_EMIT sectionsFolded();
    });
    m_grid.addWidget(header.get(), line, 0, 1, allColumns);
    row.header = std::move(header);
}

void Form::addReset(FormRowState& row, int line) {
    row.reset = std::make_unique<QToolButton>();
    row.reset->setAutoRaise(true);
    row.reset->setIcon(m_resetIcon);
    row.reset->setIconSize({14, 14});
    row.reset->setFocusPolicy(Qt::TabFocus);
    row.reset->setToolTip(tr("Back to the default"));
    row.reset->setAccessibleName(tr("Back to the default: %1").arg(rowText(row.spec.label)));
    row.reset->setSizePolicy(resetPolicy(true));
    FormRowState* const at = &row;
    connect(row.reset.get(), &QToolButton::clicked, this, [this, at] { reset(*at); });
    m_grid.addWidget(row.reset.get(), line, resetColumn, Qt::AlignTop);
}

void Form::addRow(const FormRow& spec) {
    auto row = std::make_unique<FormRowState>();
    row->spec = spec;
    const bool isNewSection = m_rows.empty() || std::string_view(m_rows.back()->spec.section) != spec.section;
    int line = m_grid.rowCount();
    if (isNewSection) {
        addHeader(*row, line++);
    }
    makeEditor(*row);
    QWidget* const editor = row->editor.get();
    editor->setObjectName(QString::fromLatin1(spec.id));
    if (isPairEnd(spec)) {
        FormRowState& start = *m_rows.back();
        row->pairStart = &start;
        static_cast<NumberField*>(editor)->setAxis(QStringLiteral("y"));
        // The fault of the first one has taken the line below it.
        m_grid.addWidget(editor, line - 2, firstColumn + 1);
        editor->setAccessibleName(start.editor->accessibleName().chopped(1) + QLatin1Char('y'));
        m_rows.push_back(std::move(row));
        return;
    }
    const QString words = rowText(spec.label);
    editor->setAccessibleName(isPairStart(spec) ? words + QStringLiteral(" x") : words);
    const bool isWide = hasWideEditor(spec.kind);
    if (spec.kind != RowKind::Switch) {
        const bool isScrubbed = spec.kind == RowKind::Number && !isPairStart(spec);
        row->label = isScrubbed ? std::make_unique<ScrubLabel>(words, static_cast<NumberField&>(*editor))
                                : std::make_unique<QLabel>(words);
        row->label->setBuddy(editor);
        row->label->setToolTip(rowText(spec.meaning));
        if (isWide) {
            m_grid.addWidget(row->label.get(), line, 0, 1, resetColumn);
        } else {
            row->labelLine = line++;
            placeLabel(*row);
        }
    }
    if (isPairStart(spec)) {
        static_cast<NumberField*>(editor)->setAxis(QStringLiteral("x"));
    }
    addReset(*row, line);
    line += isWide && row->label ? 1 : 0;
    m_grid.addWidget(editor, line, isWide ? 0 : firstColumn, 1,
                     isWide && row->label ? allColumns
                     : isWide             ? resetColumn
                                          : (isPairStart(spec) ? 1 : columns));
    row->fault = std::make_unique<FaultLabel>();
    m_grid.addWidget(row->fault.get(), line + 1, 0, 1, allColumns);
    m_rows.push_back(std::move(row));
}

void Form::setContent(const FormContent& content) {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        showRow(*row, summaryOf(content.fields, row->spec.id), content);
    }
    arrangeSections();
}

std::vector<Form::Seen> Form::arrangement() const {
    std::vector<Seen> seen(m_rows.size());
    std::size_t header = m_rows.size();
    bool isOpen = true;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const FormRowState& row = *m_rows[i];
        if (row.header) {
            header = i;
            isOpen = !m_folded.contains(row.spec.section);
        }
        const bool isThere = row.shown.has_value();
        if (isThere && header < m_rows.size()) {
            seen[std::exchange(header, m_rows.size())].header = true;
        }
        seen[i].editor = isThere && isOpen;
        if (seen[i].editor && row.shown->hasStandard && !row.shown->isStandard) {
            seen[row.pairStart != nullptr ? i - 1 : i].reset = true; // which stands beside the first part
        }
    }
    return seen;
}

/// Showing and hiding has the whole form laid out and painted anew, even where nothing comes or goes.
void Form::arrangeSections() {
    std::vector<Seen> wanted = arrangement();
    if (wanted != m_arrangement) {
        setUpdatesEnabled(false);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const FormRowState& row = *m_rows[i];
            if (row.header) {
                row.header->setVisible(wanted[i].header);
            }
            row.editor->setVisible(wanted[i].editor);
            if (row.label) {
                row.label->setVisible(wanted[i].editor);
            }
            if (row.reset) {
                row.reset->setSizePolicy(resetPolicy(wanted[i].editor));
                row.reset->setVisible(wanted[i].reset);
            }
        }
        m_arrangement = std::move(wanted);
        setUpdatesEnabled(true);
    }
    showFaults();
}

void Form::showFaults() {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        FormRowState& start = row->pairStart != nullptr ? *row->pairStart : *row;
        const auto* number = qobject_cast<const NumberField*>(row->editor.get());
        const auto* object = qobject_cast<const ObjectField*>(row->editor.get());
        const QString fault = number != nullptr ? number->fault() : object != nullptr ? object->fault() : QString();
        if (row->pairStart == nullptr || !fault.isEmpty()) {
            const bool isNew = !fault.isEmpty() && fault != start.fault->text();
            start.fault->setText(fault);
            start.fault->setVisible(!fault.isEmpty() && !row->editor->isHidden());
            if (isNew) {
                Q_EMIT faultShown(start.fault.get());
            }
        }
    }
}

void Form::revert() {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (auto* number = qobject_cast<NumberField*>(row->editor.get())) {
            number->revert();
        } else if (auto* line = qobject_cast<TextLine*>(row->editor.get())) {
            line->revert();
        } else if (auto* object = qobject_cast<ObjectField*>(row->editor.get())) {
            object->revert();
        }
        row->shown.reset();
    }
}

void Form::reset(FormRowState& row) {
    FormEdit edit;
    for (const std::unique_ptr<FormRowState>& other : m_rows) {
        if ((other.get() == &row || other->pairStart == &row) && other->shown && other->shown->hasStandard) {
            edit.fields.push_back(
                {other->spec.id, [value = other->shown->standard](const FieldValue&) { return std::optional(value); }});
        }
    }
    if (m_target.edit && !edit.fields.empty()) {
        m_target.edit(edit);
    }
}

QString Form::change(const std::string& id, const FieldValue& value) {
    if (!m_target.edit) {
        return {};
    }
    return m_target.edit({{{id, [value](const FieldValue&) { return std::optional(value); }}}});
}

QStringList Form::foldedSections() const {
    QStringList titles;
    for (const std::string& title : m_folded) {
        titles << QString::fromStdString(title);
    }
    return titles;
}

void Form::foldSections(const QStringList& titles) {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (row->header) {
            row->header->setChecked(!titles.contains(QString::fromLatin1(row->spec.section)));
        }
    }
}

void Form::tint() {
    m_resetIcon = icon(QStringLiteral("reset"), palette());
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (row->reset) {
            row->reset->setIcon(m_resetIcon);
        }
    }
}

void Form::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

namespace {

template <class Rows>
FormRowState* rowOf(const Rows& rows, const QString& id) {
    const auto found = std::ranges::find_if(rows, [&id](const auto& row) { return id == QLatin1String(row->spec.id); });
    return found == rows.end() ? nullptr : found->get();
}

} // namespace

QWidget* Form::editor(const QString& id) const {
    const FormRowState* row = rowOf(m_rows, id);
    return row == nullptr ? nullptr : row->editor.get();
}

QAbstractButton* Form::resetButton(const QString& id) const {
    const FormRowState* row = rowOf(m_rows, id);
    return row == nullptr ? nullptr : row->pairStart != nullptr ? row->pairStart->reset.get() : row->reset.get();
}

QLabel* Form::faultLabel(const QString& id) const {
    const FormRowState* row = rowOf(m_rows, id);
    return row == nullptr ? nullptr : row->pairStart != nullptr ? row->pairStart->fault.get() : row->fault.get();
}

QAbstractButton* Form::sectionHeader(const QString& title) const {
    for (const std::unique_ptr<FormRowState>& row : m_rows) {
        if (row->header && row->header->objectName() == title) {
            return row->header.get();
        }
    }
    return nullptr;
}

} // namespace spacetow
