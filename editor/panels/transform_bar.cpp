#include "editor/panels/transform_bar.h"

#include "core/level/arrange.h"
#include "core/level/fields.h"
#include "editor/editing/handles.h"
#include "editor/editing/verbs.h"
#include "editor/panels/number_text.h"

#include <QKeyEvent>

#include <algorithm>
#include <numbers>

namespace spacetow {

namespace {

constexpr double degreeOfTurn = std::numbers::pi / 180;
constexpr double flat = 1e-9; // m; what is no longer than this cannot be scaled

/// Whether all of it may be in a file.
bool isOnTheMap(const Aabb& box) {
    const double furthest =
        std::max({std::abs(box.min.x()), std::abs(box.min.y()), std::abs(box.max.x()), std::abs(box.max.y())});
    return box.isEmpty() || furthest <= limits::coordinate;
}

/// The lower left one of the bounds.
Vec2 cornerOf(const Edit& edit) {
    return placedBounds(*edit.level, unlockedKeys(*edit.level, edit.selection.keys())).min;
}

} // namespace

TransformBar::TransformBar(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox),
      m_column(this), m_labels{ScrubLabel({}, m_fields[X]), ScrubLabel({}, m_fields[Y]),
                               ScrubLabel({}, m_fields[Width]), ScrubLabel({}, m_fields[Height]),
                               ScrubLabel({}, m_fields[Angle])} {
    layOut();
    for (int i = 0; i < fields; ++i) {
        NumberField& field = m_fields[static_cast<std::size_t>(i)];
        field.enter = [this, i](const NumberEntry& entry) { return enter(static_cast<Field>(i), entry); };
        connect(&field, &NumberField::faultChanged, this, &TransformBar::showFaults);
    }
    connect(&m_relative, &QCheckBox::toggled, this, [this] {
        dressFields();
        refresh();
    });
    connect(&m_close, &QToolButton::clicked, this, &TransformBar::shut);
    m_connection = m_document.changed.connect([this](const Change&) {
        if (isVisible()) {
            refresh();
        }
    });
}

TransformBar::~TransformBar() {
    m_document.changed.disconnect(m_connection);
}

void TransformBar::setWords(const std::function<QString(const Error&)>& words) {
    for (NumberField& field : m_fields) {
        field.words = words;
    }
}

void TransformBar::showFaults() {
    const auto wrong =
        std::ranges::find_if(m_fields, [](const NumberField& field) { return !field.fault().isEmpty(); });
    m_fault.say(wrong == m_fields.end() ? QString() : wrong->fault());
}

void TransformBar::layOut() {
    m_column.setContentsMargins(10, 4, 6, 4);
    m_column.setSpacing(4);
    m_column.addLayout(&m_row);
    m_column.addWidget(&m_fault);
    m_row.setSpacing(6);
    m_title.setText(tr("Transform"));
    m_row.addWidget(&m_title);
    const std::array<QString, fields> names{tr("X"), tr("Y"), tr("Width"), tr("Height"), tr("Turn by")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_labels[i].setText(names[i]);
        m_fields[i].setAccessibleName(names[i]);
        m_row.addWidget(&m_labels[i]);
        m_row.addBeside(&m_fields[i]);
    }
    m_relative.setText(tr("Relative"));
    m_relative.setToolTip(tr("Move by metres and scale by percent instead of to a place and size"));
    m_row.addWidget(&m_relative);
    m_close.setText(tr("Close"));
    m_close.setToolTip(tr("Close this bar (Escape)"));
    m_row.addAtEnd(&m_close);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum); // grows with its lines
    dressFields();
    hide();
}

void TransformBar::dressFields() {
    const bool relative = m_relative.isChecked();
    for (const Field field : {X, Y}) {
        m_fields[field].setSpec({.unit = QStringLiteral("m"), .min = -limits::coordinate, .max = limits::coordinate});
    }
    for (const Field field : {Width, Height}) {
        m_fields[field].setSpec({.unit = relative ? QStringLiteral("%") : QStringLiteral("m"),
                                 .min = 0,
                                 .openMin = true,
                                 .step = relative ? 10.0 : 0.1});
    }
    m_fields[Angle].setSpec({.unit = QStringLiteral("°"), .step = 5});
}

void TransformBar::begin() {
    show();
    refresh();
    m_fields[X].setFocus();
    const auto length = static_cast<int>(m_fields[X].text().size());
    m_fields[X].setSelection(length, -length); // of a long number the beginning is seen
}

void TransformBar::shut() {
    hide();
    Q_EMIT closed();
}

void TransformBar::refresh() {
    ToolContext context;
    context.edit = m_document.shown();
    context.snap = m_toolbox.snap;
    const HandleFrame frame = handleFrame(context);
    const bool none = frame.box.isEmpty();
    const Vec2 corner = none ? Vec2(0, 0) : cornerOf(context.edit);
    const Vec2 size = none ? Vec2(0, 0) : frame.box.size();
    const bool relative = m_relative.isChecked();
    const std::array values{relative ? 0 : corner.x(), relative ? 0 : corner.y(), relative ? 100 : size.x(),
                            relative ? 100 : size.y(), 0.0};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!m_fields[i].isScrubbing()) {
            m_fields[i].setValue(values[i]);
        }
        m_fields[i].setEnabled(!none);
    }
    m_fields[Width].setEnabled(frame.scales && size.x() > flat);
    m_fields[Height].setEnabled(frame.scales && size.y() > flat);
}

QString TransformBar::enter(Field field, const NumberEntry& entry) {
    if (!entry.change || entry.phase == NumberEntry::Phase::Cancelled) {
        m_document.dropPreview();
        return {};
    }
    const double value = applied(*entry.change, m_fields[field].value().value_or(0));
    const std::optional<FinishedEdit> edit = edited(field, value);
    if (edit && !isOnTheMap(placedBounds(*edit->edit.level, edit->edit.selection.keys()))) {
        return tr("That would leave the map, which ends %1 m from the origin.")
            .arg(shortNumberText(limits::coordinate));
    }
    if (entry.phase == NumberEntry::Phase::Preview) {
        m_fields[field].setValue(value);
        if (edit) {
            m_document.preview(edit->edit);
        } else {
            m_document.dropPreview();
        }
        return {};
    }
    m_document.dropPreview();
    m_toolbox.finish(edit);
    refresh();
    return {};
}

std::optional<FinishedEdit> TransformBar::edited(Field field, double value) {
    const ToolContext context = m_toolbox.context();
    const HandleFrame frame = handleFrame(context);
    if (frame.box.isEmpty()) {
        return {};
    }
    const bool relative = m_relative.isChecked();
    if (field == Angle) {
        return value == 0 ? std::nullopt : rotateSelected(context, value * degreeOfTurn);
    }
    if (field == X || field == Y) {
        const int axis = field == X ? 0 : 1;
        Vec2 way(0, 0);
        way[axis] = relative ? value : value - cornerOf(context.edit)[axis];
        return mapSelected(context, "move", Affine::translation(way));
    }
    const int axis = field == Width ? 0 : 1;
    const double factor = relative ? value / 100 : value / frame.box.size()[axis];
    Vec2 factors(1, 1);
    factors[axis] = factor;
    return mapSelected(context, "scale",
                       scalingIn(frame, pointOf(frame, {-1, -1}), frame.keepsShape ? Vec2(factor, factor) : factors));
}

void TransformBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        shut();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace spacetow
