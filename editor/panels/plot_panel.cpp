#include "editor/panels/plot_panel.h"

#include "core/physics/query/explain.h"
#include "editor/canvas/icons.h"
#include "editor/panels/names.h"
#include "editor/panels/plot_names.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr std::size_t mostCurves = 12;

QIcon dotIcon(const QColor& color) {
    QPixmap picture(32, 32);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(6, 6, 20, 20);
    return QIcon(picture);
}

QString shortFigure(double number) {
    return QLocale().toString(number, 'g', 4);
}

QString percentText(const std::optional<double>& share) {
    return share ? QLocale().toString(100 * *share, 'g', 3) + QStringLiteral(" %") : QStringLiteral("–");
}

} // namespace

PlotPanel::PlotPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_all(this), m_column(&m_page), m_row(new WrappingRow),
      m_curves(new WrappingRow), m_view(m_history) {
    layOut();
    m_history.watch({{0, PlotQuantity::Energy}, {0, PlotQuantity::Kinetic}, {0, PlotQuantity::Potential}});
    connect(&m_add, &QToolButton::clicked, this, [this] {
        const int row = m_quantities.currentIndex();
        if (row >= 0 && row < static_cast<int>(m_offered.size())) {
            add(m_offered[static_cast<std::size_t>(row)]);
        }
    });
    connect(&m_phase, &QToolButton::toggled, &m_view, &PlotView::setPhase);
    connect(&m_export, &QToolButton::clicked, this, [this] {
        std::vector<std::string> columns;
        for (std::size_t i = 0; i < m_history.sources().size(); ++i) {
            columns.push_back((names()[static_cast<qsizetype>(i)] + QStringLiteral(" (") +
                               QString::fromUtf8(unitOf(m_history.sources()[i].quantity)) + QLatin1Char(')'))
                                  .toStdString());
        }
        Q_EMIT exportWanted(QByteArray::fromStdString(m_history.csv(columns)));
    });
    connect(&m_clear, &QToolButton::clicked, this, [this] {
        m_history.watch({});
        showCurves();
    });
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (isVisible() && (!(change.before.selection == change.after.selection) ||
                            change.before.level->objects.size() != change.after.level->objects.size())) {
            offerQuantities();
        }
    });
    offerQuantities();
    showCurves();
}

PlotPanel::~PlotPanel() {
    m_document.changed.disconnect(m_listener);
}

void PlotPanel::layOut() {
    m_all.setContentsMargins(0, 0, 0, 0);
    m_all.addWidget(&m_scroll);
    m_scroll.setFrameShape(QFrame::NoFrame);
    m_scroll.setFocusPolicy(Qt::NoFocus);
    m_scroll.setWidgetResizable(true);
    m_scroll.setWidget(&m_page);
    m_column.setContentsMargins(4, 4, 4, 4);
    m_column.setSpacing(4);
    m_column.addLayout(m_row);
    m_column.addLayout(m_curves);
    m_column.addWidget(&m_view, 1);
    m_column.addWidget(&m_totals);
    m_quantities.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_quantities.setMinimumContentsLength(14);
    m_quantities.setAccessibleName(tr("Quantity of the selection"));
    m_quantities.setToolTip(tr("What of the selected body or connector, or of everything, is to be plotted"));
    m_add.setText(tr("Add curve"));
    m_phase.setText(tr("x against y"));
    m_phase.setCheckable(true);
    m_phase.setToolTip(tr("The second curve against the first, in place of all over time"));
    m_export.setText(tr("CSV…"));
    m_export.setToolTip(tr("Write what is plotted into a file that spreadsheets read"));
    m_clear.setText(tr("Clear"));
    m_clear.setToolTip(tr("Remove all curves"));
    m_row->addWidget(&m_quantities);
    for (QToolButton* button : {&m_add, &m_phase, &m_export, &m_clear}) {
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        m_row->addWidget(button);
    }
    m_totals.setWordWrap(true);
    m_totals.setTextFormat(Qt::PlainText);
    m_totals.setToolTip(plainToolTip(tr("Drift: how far energy has come from its first value, as a share of the most "
                                        "that was ever in motion or in springs; and momentum, as a share of the most "
                                        "that all bodies had")));
    m_view.setEmptyText(tr("Select a body or a connector, choose a quantity and add its curve. It grows while the "
                           "level is played or simulated."));
}

Key PlotPanel::selected() const {
    const std::vector<Key>& keys = m_document.selection().keys();
    return keys.size() == 1 ? keys.front() : 0;
}

void PlotPanel::offerQuantities() {
    const QString before = m_quantities.currentText();
    m_offered.clear();
    m_quantities.clear();
    const Object* object = m_document.level().objects.find(selected());
    const auto offer = [this](PlotSubject subject, Key key) {
        for (const PlotQuantity quantity : quantitiesOf(subject)) {
            m_offered.push_back({key, quantity});
            m_quantities.addItem(curveName(m_document.level(), m_offered.back()));
        }
    };
    if (object != nullptr && !std::holds_alternative<GroupObject>(object->data)) {
        const bool connects = std::holds_alternative<ConnectorObject>(object->data);
        offer(connects ? PlotSubject::Connector : PlotSubject::Body, object->key);
    }
    offer(PlotSubject::World, 0);
    m_quantities.setCurrentIndex(std::max(0, m_quantities.findText(before)));
}

void PlotPanel::add(const PlotSource& source) {
    std::vector<PlotSource> sources = m_history.sources();
    if (std::ranges::find(sources, source) == sources.end() && sources.size() < mostCurves) {
        sources.push_back(source);
        m_history.watch(std::move(sources));
        showCurves();
    }
}

void PlotPanel::remove(std::size_t curve) {
    std::vector<PlotSource> sources = m_history.sources();
    sources.erase(sources.begin() + static_cast<std::ptrdiff_t>(curve));
    m_history.watch(std::move(sources));
    showCurves();
}

QStringList PlotPanel::names() const {
    QStringList all;
    for (const PlotSource& source : m_history.sources()) {
        all << curveName(m_document.level(), source);
    }
    return all;
}

std::vector<QToolButton*> PlotPanel::curveButtons() const {
    std::vector<QToolButton*> all;
    for (const std::unique_ptr<QToolButton>& button : m_buttons) {
        all.push_back(button.get());
    }
    return all;
}

void PlotPanel::showCurves() {
    for (std::unique_ptr<QToolButton>& button : m_buttons) {
        m_curves->removeWidget(button.get());
        button->hide();
        button.release()->deleteLater(); // a click on it may be what led here
    }
    m_buttons.clear();
    const QStringList all = names();
    for (std::size_t i = 0; i < m_history.sources().size(); ++i) {
        auto button = std::make_unique<QToolButton>();
        button->setIcon(dotIcon(PlotView::curveColor(i, palette())));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        const QString& name = all[static_cast<qsizetype>(i)];
        button->setText(menuSafe(fontMetrics().elidedText(name, Qt::ElideMiddle, 190)) + QStringLiteral(" ×"));
        button->setAccessibleName(tr("Remove the curve “%1”").arg(name));
        button->setToolTip(plainToolTip(button->accessibleName()));
        button->setAutoRaise(true);
        connect(button.get(), &QToolButton::clicked, this, [this, i] { remove(i); });
        m_curves->addWidget(button.get());
        m_buttons.push_back(std::move(button));
    }
    m_phase.setEnabled(all.size() >= 2);
    m_export.setEnabled(!all.isEmpty());
    m_clear.setEnabled(!all.isEmpty());
    m_view.setNames(all);
    showTotals();
}

void PlotPanel::showSession(std::shared_ptr<const Session> session, bool runs) {
    if (runs && !m_runs) {
        m_history.clear();
    }
    m_runs = runs && session != nullptr;
    m_session = std::move(session);
    if (m_runs && !m_inUpdate) {
        m_history.sample(*m_session);
    }
    if (isVisible()) {
        m_view.refresh();
        showTotals();
    }
}

void PlotPanel::showTimeline(const TimelineSummary& timeline) {
    if (std::exchange(m_futures, timeline.futures) != timeline.futures) {
        m_history.forgetAfter(timeline.begun);
    }
    m_inUpdate = timeline.iteration > 0;
}

void PlotPanel::showTotals() {
    if (!m_session) {
        m_totals.setText(tr("Nothing runs."));
        return;
    }
    const WorldReading sum = spacetow::totals(m_session->world());
    const double change = m_history.energyChange().value_or(0);
    m_totals.setText(tr("Energy %1 J, %2 J since the start (drift %3) · momentum %4 kg m/s (drift %5)")
                         .arg(shortFigure(sum.energy()),
                              (change > 0 ? QStringLiteral("+") : QString()) + shortFigure(change),
                              percentText(m_history.energyDrift()), shortFigure(sum.momentum.norm()),
                              percentText(m_history.momentumDrift())));
}

void PlotPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    offerQuantities();
    showCurves();
}

void PlotPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        showCurves();
    }
    QWidget::changeEvent(event);
}

} // namespace spacetow
