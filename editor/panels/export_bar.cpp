#include "editor/panels/export_bar.h"

#include <QKeyEvent>
#include <QLocale>

namespace spacetow {

ExportBar::ExportBar(QWidget* parent) : QWidget(parent), m_column(this), m_scaleLabel({}, m_scale) {
    m_column.setContentsMargins(10, 4, 6, 4);
    m_column.setSpacing(4);
    m_column.addLayout(&m_top);
    m_column.addLayout(&m_fields);
    m_column.addWidget(&m_fault);
    m_top.setSpacing(6);
    m_fields.setSpacing(6);
    m_title.setText(tr("Export picture"));
    m_area.addItems({tr("Whole level"), tr("What is in view")});
    m_area.setToolTip(tr("What of the level the picture shows"));
    m_area.setAccessibleName(m_area.toolTip());
    constexpr double finest = 20000; // px a metre, as far as the canvas zooms in
    m_scale.setSpec({.unit = QStringLiteral("px/m"),
                     .min = 0,
                     .max = finest,
                     .openMin = true,
                     .step = 10,
                     .meaning = tr("Pixels of the picture for a metre of the level.")});
    m_scale.setValue(m_settings.pixelsPerMetre);
    m_scaleLabel.setText(tr("Scale"));
    m_transparent.setText(tr("Transparent"));
    m_transparent.setToolTip(tr("Leave the ground of the picture out"));
    m_grid.setText(tr("Grid"));
    m_grid.setToolTip(tr("Draw the grid as well"));
    m_apply.setText(tr("Export…"));
    m_apply.setToolTip(tr("Choose a file, PNG or SVG (Enter)"));
    m_cancel.setText(tr("Cancel"));
    m_cancel.setToolTip(tr("Write no picture (Escape)"));
    for (QWidget* const widget : std::initializer_list<QWidget*>{&m_title, &m_size}) {
        m_top.addWidget(widget);
    }
    m_top.addAtEnd(&m_apply);
    m_top.addAtEnd(&m_cancel);
    m_fields.addWidget(&m_area);
    m_fields.addWidget(&m_scaleLabel);
    m_fields.addBeside(&m_scale);
    m_fields.addWidget(&m_transparent);
    m_fields.addWidget(&m_grid);
    m_fault.setObjectName(QStringLiteral("refusal"));
    connect(&m_scale, &NumberField::entered, this, &ExportBar::refresh);
    connect(&m_scale, &NumberField::faultChanged, this, &ExportBar::refresh);
    connect(&m_area, &QComboBox::currentIndexChanged, this, &ExportBar::refresh);
    connect(&m_transparent, &QCheckBox::toggled, this, &ExportBar::refresh);
    connect(&m_grid, &QCheckBox::toggled, this, &ExportBar::refresh);
    connect(&m_apply, &QToolButton::clicked, this, &ExportBar::apply);
    connect(&m_cancel, &QToolButton::clicked, this, &ExportBar::cancel);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum); // grows with its lines
    hide();
}

void ExportBar::begin() {
    show();
    refresh();
    m_scale.setFocus();
    m_scale.selectAll();
}

void ExportBar::refresh() {
    m_settings.wholeLevel = m_area.currentIndex() == 0;
    m_settings.pixelsPerMetre = m_scale.value().value_or(m_settings.pixelsPerMetre);
    m_settings.transparent = m_transparent.isChecked();
    m_settings.grid = m_grid.isChecked();
    const std::optional<QSize> size = m_measure ? m_measure(m_settings) : std::nullopt;
    const QLocale locale;
    m_size.setText(size ? tr("%1 × %2 pixels").arg(locale.toString(size->width()), locale.toString(size->height()))
                        : QString());
    m_fault.say(!m_scale.fault().isEmpty() ? m_scale.fault()
                : size                     ? QString()
                       : tr("There is nothing to be seen, or the picture would be too large: at most "
                            "16,384 pixels a side and 67 million in all. Choose another scale."));
    m_apply.setEnabled(size.has_value());
}

void ExportBar::apply() {
    if (m_scale.enterTyped() && m_measure && m_measure(m_settings)) {
        hide();
        Q_EMIT closed();
        Q_EMIT wanted();
    }
}

void ExportBar::cancel() {
    if (isVisible()) {
        hide();
        Q_EMIT closed();
    }
}

void ExportBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        cancel();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        apply();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace spacetow
