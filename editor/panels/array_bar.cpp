#include "editor/panels/array_bar.h"

#include "core/level/arrange.h"
#include "core/level/fields.h"
#include "editor/editing/verbs.h"

#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double degree = std::numbers::pi / 180;

} // namespace

ArrayBar::ArrayBar(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_column(this), m_copiesLabel({}, m_copies),
      m_xLabel({}, m_x), m_yLabel({}, m_y), m_angleLabel({}, m_angle) {
    layOut();
    for (NumberField* field : numbers()) {
        connect(field, &NumberField::faultChanged, this, &ArrayBar::showFaults);
    }
    connect(&m_copies, &NumberField::entered, this, [this](std::optional<double> value) {
        (m_kind == Kind::Linear ? m_linear.copies : m_radial.copies) = static_cast<int>(value.value_or(1));
        preview();
    });
    connect(&m_x, &NumberField::entered, this, [this](std::optional<double> value) {
        (m_kind == Kind::Linear ? m_linear.step : m_radial.center).x() = value.value_or(0);
        m_hasPlace = true;
        preview();
    });
    connect(&m_y, &NumberField::entered, this, [this](std::optional<double> value) {
        (m_kind == Kind::Linear ? m_linear.step : m_radial.center).y() = value.value_or(0);
        m_hasPlace = true;
        preview();
    });
    connect(&m_angle, &NumberField::entered, this, [this](std::optional<double> value) {
        m_radial.angle = value.value_or(0) * degree;
        preview();
    });
    connect(&m_turns, &QCheckBox::toggled, this, [this](bool on) {
        m_radial.turns = on;
        preview();
    });
    connect(&m_apply, &QToolButton::clicked, this, &ArrayBar::apply);
    connect(&m_cancel, &QToolButton::clicked, this, &ArrayBar::cancel);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &ArrayBar::follow);
    m_documentListener = m_document.changed.connect([this](const Change&) { followSoon(); });
    m_toolboxListener = m_toolbox.changed.connect([this] { followSoon(); }); // a drag has ended
}

ArrayBar::~ArrayBar() {
    m_document.changed.disconnect(m_documentListener);
    m_toolbox.changed.disconnect(m_toolboxListener);
}

void ArrayBar::layOut() {
    m_column.setContentsMargins(10, 4, 6, 4);
    m_column.setSpacing(4);
    m_column.addLayout(&m_row);
    m_column.addWidget(&m_refusal);
    m_row.setSpacing(6);
    m_row.addWidget(&m_title);
    m_copies.setSpec({.min = 1, .max = 1e6, .whole = true, .step = 1});
    add(m_copiesLabel, tr("Copies"), m_copies);
    for (NumberField* field : {&m_x, &m_y}) {
        field->setSpec({.unit = QStringLiteral("m"), .min = -limits::coordinate, .max = limits::coordinate});
    }
    m_angle.setSpec({.unit = QStringLiteral("°"), .step = 5});
    add(m_angleLabel, tr("Angle"), m_angle);
    add(m_xLabel, {}, m_x);
    add(m_yLabel, {}, m_y);
    m_turns.setText(tr("Turn copies"));
    m_row.addWidget(&m_turns);
    m_refusal.setObjectName(QStringLiteral("refusal"));
    m_apply.setText(tr("Apply"));
    m_apply.setToolTip(tr("Make the copies (Enter)"));
    m_cancel.setText(tr("Cancel"));
    m_cancel.setToolTip(tr("Make no copies (Escape)"));
    m_row.addAtEnd(&m_apply);
    m_row.addAtEnd(&m_cancel);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum); // grows with its lines
    hide();
}

void ArrayBar::add(ScrubLabel& label, const QString& text, NumberField& field) {
    label.setText(text);
    m_row.addWidget(&label);
    m_row.addBeside(&field);
}

void ArrayBar::begin(Kind kind) {
    cancel();
    m_toolbox.cancel();
    if (m_document.selection().empty()) {
        return;
    }
    m_kind = kind;
    m_hasPlace = false;
    takeSelection();
    show();
    m_copies.setFocus();
    m_copies.selectAll();
    preview();
}

void ArrayBar::takeSelection() {
    m_context = m_toolbox.context();
    if (m_hasPlace) {
        return;
    }
    const std::vector<Key>& keys = m_context->edit.selection.keys();
    const Aabb box = placedBounds(*m_context->edit.level, keys);
    if (!box.isEmpty()) {
        const double step = m_context->snap.step;
        const double width = box.size().x();
        m_linear.step = Vec2(step > 0 ? step * std::ceil(width / step + 1) : width, 0);
    }
    m_radial.center = turningPoint(*m_context).value_or(Vec2(0, 0));
    setNumbers();
}

bool ArrayBar::isBehind() const {
    const Edit& now = m_document.current();
    return now.level != m_context->edit.level || now.selection != m_context->edit.selection;
}

void ArrayBar::followSoon() {
    if (m_context && !m_toolbox.isDragging() && (isBehind() || (m_isShown && !m_document.hasPreview()))) {
        m_soon.start(0);
    }
}

void ArrayBar::follow() {
    if (m_context && !m_toolbox.isDragging()) {
        if (isBehind()) {
            takeSelection();
        }
        preview();
    }
}

void ArrayBar::setNumbers() {
    const bool radial = m_kind == Kind::Radial;
    const Vec2& place = radial ? m_radial.center : m_linear.step;
    m_title.setText(radial ? tr("Radial array") : tr("Linear array"));
    m_xLabel.setText(radial ? tr("Center x") : tr("Step x"));
    m_yLabel.setText(tr("y", "of a center or step"));
    m_copies.setValue(radial ? m_radial.copies : m_linear.copies);
    m_x.setValue(place.x());
    m_y.setValue(place.y());
    m_angle.setValue(m_radial.angle / degree);
    m_turns.setChecked(m_radial.turns);
    m_angle.setVisible(radial);
    m_angleLabel.setVisible(radial);
    m_turns.setVisible(radial);
}

ArraySpec ArrayBar::spec() const {
    if (m_kind == Kind::Linear) {
        return m_linear;
    }
    return m_radial;
}

void ArrayBar::setWords(const std::function<QString(const Error&)>& words) {
    for (NumberField* field : numbers()) {
        field->words = words;
    }
}

void ArrayBar::showFaults() {
    QString fault = m_objection;
    for (const NumberField* field : numbers()) {
        fault = field->fault().isEmpty() ? fault : field->fault();
    }
    m_refusal.say(fault);
}

void ArrayBar::preview() {
    if (!m_context) {
        return;
    }
    const bool isNothing = m_context->edit.selection.empty();
    const std::optional<FinishedEdit> edit = arraySelected(*m_context, spec());
    const std::int64_t size = arraySize(*m_context->edit.level, m_context->edit.selection.keys(), spec());
    const QLocale locale;
    m_objection = edit        ? QString()
                  : isNothing ? tr("Select what is to be copied.")
                  : size == 0
                      ? tr("Of a ship, a payload and a finish a level has one: there is nothing to copy.")
                      : tr("That would be %1 objects; an array may have %2. Make fewer copies.")
                            .arg(locale.toString(static_cast<qlonglong>(size)), locale.toString(maxArrayObjects));
    showFaults();
    m_apply.setEnabled(edit.has_value());
    m_isShown = edit.has_value();
    if (edit) {
        m_document.preview(edit->edit);
    } else {
        m_document.dropPreview();
    }
}

void ArrayBar::apply() {
    // A click on the button leaves the focus, and what is typed, where they are.
    const auto fields = numbers();
    if (!m_context || !std::ranges::all_of(fields, &NumberField::enterTyped)) {
        return;
    }
    if (isBehind()) {
        takeSelection();
    }
    const std::optional<FinishedEdit> edit = arraySelected(*m_context, spec());
    if (!edit) {
        return;
    }
    shut();
    m_toolbox.finish(edit);
}

void ArrayBar::cancel() {
    if (m_context) {
        shut();
        m_document.dropPreview();
    }
}

void ArrayBar::shut() {
    m_context.reset();
    m_isShown = false;
    m_soon.stop();
    hide();
    Q_EMIT closed();
}

void ArrayBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        cancel();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        apply();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace spacetow
