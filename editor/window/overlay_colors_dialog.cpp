#include "editor/window/overlay_colors_dialog.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/swatch.h"
#include "editor/window/screen_room.h"

#include <QCoreApplication>
#include <QGridLayout>

#include <array>

namespace spacetow {

namespace {

QString meaningOf(const OverlayInk& ink) {
    return QCoreApplication::translate("Legend", ink.meaning);
}

} // namespace

OverlayColorsDialog::OverlayColorsDialog(QWidget* parent)
    : QDialog(parent), m_column(this), m_setLabel(tr("&Set of colors:")), m_buttons(QDialogButtonBox::Close),
      m_forget(m_buttons.addButton(tr("&Forget Own Colors"), QDialogButtonBox::ResetRole)) {
    setWindowTitle(tr("Colors of the overlays"));
    m_set.addItem(tr("Standard"));
    m_set.addItem(tr("Okabe and Ito, safe with any color vision"));
    m_setLabel.setBuddy(&m_set);
    m_column.addWidget(&m_setLabel);
    m_column.addWidget(&m_set);
    auto* const content = new QWidget; // owned by the scroll area
    auto* const list = new QGridLayout(content);
    list->setColumnStretch(1, 1);
    for (int row = 0; row < static_cast<int>(overlayRows().size()); ++row) {
        addOverlay(*list, row);
    }
    m_scroll.setWidget(content);
    m_scroll.setWidgetResizable(true);
    m_scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_column.addWidget(&m_scroll, 1);
    m_column.addWidget(&m_buttons);
    connect(&m_set, &QComboBox::activated, this, [this](int set) {
        OverlayPalette palette = m_palette;
        palette.set = set == 1 ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard;
        Q_EMIT chosen(palette);
    });
    connect(m_forget, &QPushButton::clicked, this, [this] {
        OverlayPalette palette = m_palette;
        palette.own.clear();
        Q_EMIT chosen(palette);
    });
    connect(&m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resizeWithinScreen(*this, {460, 620});
}

void OverlayColorsDialog::addOverlay(QGridLayout& list, int index) {
    const OverlayRow& row = overlayRows()[static_cast<std::size_t>(index)];
    if (row.inks.empty()) {
        return;
    }
    auto* const title = new QLabel(QCoreApplication::translate("Actions", row.text).remove(QLatin1Char('&')));
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    title->setWordWrap(true);
    list.addWidget(title, list.rowCount(), 0, 1, 3);
    for (const OverlayInk& ink : row.inks) {
        addInk(list, static_cast<int>(&ink - overlayInks().data()));
    }
}

void OverlayColorsDialog::addInk(QGridLayout& list, int index) {
    const OverlayInk& ink = overlayInks()[static_cast<std::size_t>(index)];
    const int row = list.rowCount();
    auto* const color = new QToolButton;
    color->setToolTip(tr("Choose another color"));
    color->setAccessibleName(meaningOf(ink));
    color->setProperty("ink", QLatin1String(ink.name));
    auto* const label = new QLabel(meaningOf(ink));
    label->setWordWrap(true);
    label->setBuddy(color);
    auto* const reset = new QToolButton;
    reset->setAutoRaise(true);
    reset->setIcon(livingIcon(QStringLiteral("reset")));
    reset->setToolTip(tr("The color of the set again"));
    reset->setAccessibleName(tr("%1: the color of the set again").arg(meaningOf(ink)));
    reset->setProperty("reset", QLatin1String(ink.name));
    list.addWidget(color, row, 0);
    list.addWidget(label, row, 1);
    list.addWidget(reset, row, 2);
    connect(color, &QToolButton::clicked, this, [this, index] { Q_EMIT colorWanted(index); });
    connect(reset, &QToolButton::clicked, this, [this, name = std::string(ink.name)] {
        OverlayPalette palette = m_palette;
        palette.own.erase(name);
        Q_EMIT chosen(palette);
    });
    m_inks.push_back({color, reset});
}

void OverlayColorsDialog::showPalette(const OverlayPalette& palette, Shade ground) {
    m_palette = palette;
    m_set.setCurrentIndex(palette.set == OverlayColorSet::OkabeIto ? 1 : 0);
    m_forget->setEnabled(!palette.own.empty());
    const DebugColors colors = overlayColors(palette, ground);
    for (std::size_t i = 0; i < m_inks.size(); ++i) {
        const OverlayInk& ink = overlayInks()[i];
        m_inks[i].color->setIcon(swatch(std::array{colors.*ink.color}, 16));
        m_inks[i].reset->setEnabled(palette.own.contains(ink.name));
    }
}

} // namespace spacetow
