#include "editor/panels/transform_bar.h"

#include "editor/editing/handles.h"
#include "editor/editing/verbs.h"

#include <QKeyEvent>

#include <numbers>

namespace spacetow {

namespace {

constexpr double degreeOfTurn = std::numbers::pi / 180;
constexpr double flat = 1e-9; // m; what is no longer than this cannot be scaled

} // namespace

TransformBar::TransformBar(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_row(this) {
    layOut();
    for (int i = 0; i < fields; ++i) {
        connect(&m_fields[static_cast<std::size_t>(i)], &NumberField::entered, this,
                [this, i](std::optional<double> value) {
                    if (value) {
                        enter(static_cast<Field>(i), *value);
                    }
                });
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

void TransformBar::layOut() {
    m_row.setContentsMargins(10, 4, 6, 4);
    m_row.setSpacing(6);
    m_title.setText(tr("Transform"));
    m_row.addWidget(&m_title);
    const std::array<QString, fields> names{tr("X"), tr("Y"), tr("Width"), tr("Height"), tr("Turn by")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_labels[i].setText(names[i]);
        m_labels[i].setBuddy(&m_fields[i]);
        m_row.addWidget(&m_labels[i]);
        m_row.addWidget(&m_fields[i]);
    }
    m_relative.setText(tr("Relative"));
    m_relative.setToolTip(tr("Move by metres and scale by percent instead of to a place and size"));
    m_row.addWidget(&m_relative);
    m_row.addStretch(1);
    m_close.setText(tr("Close"));
    m_close.setToolTip(tr("Close this bar (Escape)"));
    m_row.addWidget(&m_close);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    dressFields();
    hide();
}

void TransformBar::dressFields() {
    const bool relative = m_relative.isChecked();
    for (const Field field : {X, Y}) {
        m_fields[field].setSpec({.unit = tr("m")});
    }
    for (const Field field : {Width, Height}) {
        m_fields[field].setSpec({.unit = relative ? QStringLiteral("%") : tr("m"),
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
    m_fields[X].selectAll();
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
    const Vec2 corner = none ? Vec2(0, 0) : frame.box.min;
    const Vec2 size = none ? Vec2(0, 0) : frame.box.size();
    const bool relative = m_relative.isChecked();
    m_fields[X].setValue(relative ? 0 : corner.x());
    m_fields[Y].setValue(relative ? 0 : corner.y());
    m_fields[Width].setValue(relative ? 100 : size.x());
    m_fields[Height].setValue(relative ? 100 : size.y());
    m_fields[Angle].setValue(0);
    for (NumberField& field : m_fields) {
        field.setEnabled(!none);
    }
    m_fields[Width].setEnabled(frame.scales && size.x() > flat);
    m_fields[Height].setEnabled(frame.scales && size.y() > flat);
}

void TransformBar::enter(Field field, double value) {
    const ToolContext context = m_toolbox.context();
    const HandleFrame frame = handleFrame(context);
    if (frame.box.isEmpty()) {
        return;
    }
    const bool relative = m_relative.isChecked();
    if (field == Angle) {
        m_toolbox.finish(value == 0 ? std::nullopt : rotateSelected(context, value * degreeOfTurn));
    } else if (field == X || field == Y) {
        const int axis = field == X ? 0 : 1;
        Vec2 way(0, 0);
        way[axis] = relative ? value : value - frame.box.min[axis];
        m_toolbox.finish(mapSelected(context, "move", Affine::translation(way)));
    } else {
        const int axis = field == Width ? 0 : 1;
        const double factor = relative ? value / 100 : value / frame.box.size()[axis];
        Vec2 factors(1, 1);
        factors[axis] = factor;
        m_toolbox.finish(mapSelected(
            context, "scale", Affine::scaling(frame.box.min, frame.keepsShape ? Vec2(factor, factor) : factors)));
    }
    refresh();
}

void TransformBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        shut();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace spacetow
