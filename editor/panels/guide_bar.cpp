#include "editor/panels/guide_bar.h"

#include "core/level/guides.h"
#include "editor/canvas/icons.h"
#include "editor/editing/guide_verbs.h"

#include <QKeyEvent>

#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double oneDegree = std::numbers::pi / 180;
constexpr double farthest = 1e6; // m, as the file allows

} // namespace

GuideBar::GuideBar(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_column(this), m_xLabel(tr("X"), m_x), m_yLabel(tr("Y"), m_y),
      m_angleLabel(QStringLiteral("∠"), m_angle) {
    layOut();
    enterInto(m_x, [](Guide& guide, double value) { guide.point.x() = value; });
    enterInto(m_y, [](Guide& guide, double value) { guide.point.y() = value; });
    enterInto(m_angle, [](Guide& guide, double value) { guide.angle = value * oneDegree; });
    connect(&m_name, &QLineEdit::editingFinished, this, [this] {
        change([this](Guide& guide) { guide.name = m_name.text().toStdString(); }, NumberEntry::Phase::Final);
    });
    connect(&m_delete, &QToolButton::clicked, this, [this] {
        if (const std::optional<FinishedEdit> edit = deleteGuide(m_document.current(), m_index.value_or(0))) {
            m_document.commit(edit->label, edit->edit);
        }
        dismiss();
    });
    connect(&m_close, &QToolButton::clicked, this, &GuideBar::dismiss);
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
    hide();
}

GuideBar::~GuideBar() {
    m_document.changed.disconnect(m_listener);
}

void GuideBar::layOut() {
    constexpr double steps = 0.25; // m
    for (NumberField* field : {&m_x, &m_y}) {
        field->setSpec({.unit = QStringLiteral("m"), .min = -farthest, .max = farthest, .step = steps});
    }
    m_angle.setSpec({.unit = QStringLiteral("°"), .min = -360, .max = 360, .step = 5});
    for (NumberField* field : {&m_x, &m_y, &m_angle}) {
        connect(field, &NumberField::faultChanged, this, [this] {
            const QString& fault = m_x.fault();
            m_fault.say(!fault.isEmpty() ? fault : !m_y.fault().isEmpty() ? m_y.fault() : m_angle.fault());
        });
    }
    m_name.setMinimumWidth(50);
    m_name.setMaximumWidth(240);
    m_name.setPlaceholderText(tr("Name"));
    m_column.setContentsMargins(8, 5, 4, 5);
    m_column.setSpacing(4);
    m_column.addLayout(&m_row);
    m_column.addWidget(&m_fault);
    m_row.setSpacing(4); // the bar stands between two panels in a window of 800 pixels
    const std::initializer_list<std::pair<ScrubLabel*, NumberField*>> fields{
        {&m_xLabel, &m_x}, {&m_yLabel, &m_y}, {&m_angleLabel, &m_angle}};
    for (const auto& [label, field] : fields) {
        m_row.addWidget(label);
        m_row.addWidget(field, 1);
    }
    m_x.setAccessibleName(tr("X of the guide"));
    m_y.setAccessibleName(tr("Y of the guide"));
    m_angle.setAccessibleName(tr("Angle of the guide"));
    m_name.setAccessibleName(tr("Name of the guide"));
    m_row.addWidget(&m_name, 1);
    m_row.addStretch(1);
    const std::initializer_list<std::pair<QToolButton*, QString>> buttons{{&m_delete, tr("Delete this guide")},
                                                                          {&m_close, tr("Close")}};
    for (const auto& [button, name] : buttons) {
        button->setAutoRaise(true);
        button->setToolTip(name);
        button->setAccessibleName(name);
        m_row.addWidget(button);
    }
    tint();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void GuideBar::setWords(const std::function<QString(const Error&)>& words) {
    for (NumberField* field : {&m_x, &m_y, &m_angle}) {
        field->words = words;
    }
}

void GuideBar::tint() {
    m_delete.setIcon(icon(QStringLiteral("delete"), palette()));
    m_close.setIcon(icon(QStringLiteral("close"), palette()));
}

void GuideBar::open(std::size_t index) {
    m_index = index;
    refresh();
    if (m_index) {
        show();
        const Vec2 along = directionOf(m_document.level().guides[index]);
        NumberField& first = std::abs(along.x()) > std::abs(along.y()) ? m_y : m_x;
        first.setFocus();
        first.selectAll();
    }
}

void GuideBar::dismiss() {
    if (!isHidden()) {
        hide();
        m_index.reset();
        Q_EMIT dismissed();
    }
}

void GuideBar::refresh() {
    if (!m_index) {
        return;
    }
    const std::vector<Guide>& guides = m_document.level().guides;
    if (*m_index >= guides.size()) {
        dismiss();
        return;
    }
    const Guide& guide = guides[*m_index];
    m_x.setValue(guide.point.x());
    m_y.setValue(guide.point.y());
    // What was typed in degrees comes back as it was typed.
    constexpr double finest = 1e9;
    m_angle.setValue(std::round(guide.angle / oneDegree * finest) / finest);
    if (!(m_name.hasFocus() && m_name.isModified())) {
        m_name.setText(QString::fromStdString(guide.name));
    }
}

void GuideBar::enterInto(NumberField& field, const std::function<void(Guide&, double)>& set) {
    field.enter = [this, &field, set](const NumberEntry& entry) {
        if (entry.change && entry.phase != NumberEntry::Phase::Cancelled) {
            const double value = applied(*entry.change, field.value().value_or(0));
            change([&set, value](Guide& guide) { set(guide, value); }, entry.phase);
        } else {
            m_document.dropPreview();
        }
        return QString();
    };
}

void GuideBar::change(const std::function<void(Guide&)>& how, NumberEntry::Phase phase) {
    if (!m_index || *m_index >= m_document.current().level->guides.size()) {
        return;
    }
    Guide guide = m_document.current().level->guides[*m_index];
    how(guide);
    const std::optional<FinishedEdit> edit = changeGuide(m_document.current(), *m_index, guide);
    if (!edit) {
        m_document.dropPreview();
    } else if (phase == NumberEntry::Phase::Preview) {
        m_document.preview(edit->edit);
    } else {
        m_document.commit(edit->label, edit->edit, edit->mergeKey);
    }
}

void GuideBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        dismiss();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void GuideBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
