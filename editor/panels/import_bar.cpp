#include "editor/panels/import_bar.h"

#include "core/base/whole_file.h"
#include "core/level/bounds.h"
#include "core/level/file.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QScopedValueRollback>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int pace = 100;         // ms between looks at how far the work is
constexpr int fewReportLines = 5; // as many as the bar shows

Result<Drawing> drawingIn(const QString& path, const Watch& watch) {
    const Result<ReadText> bytes = readFile(path.toStdU16String(), maxLevelBytes);
    if (!bytes) {
        return bytes.error();
    }
    return readDrawing(bytes.value().text, watch);
}

} // namespace

/// What a piece of work has come to.
struct ImportBar::Outcome {
    std::shared_ptr<const Drawing> drawing;
    std::optional<Error> error;
    std::optional<Edit> edit;
    Aabb box; // of what came
    int objects = 0;
    int vertices = 0;
    std::vector<Error> notes;
};

ImportBar::ImportBar(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_column(this), m_scaleLabel({}, m_scale),
      m_toleranceLabel({}, m_tolerance) {
    layOut();
    for (NumberField* const field : {&m_scale, &m_tolerance}) {
        connect(field, &NumberField::entered, this, &ImportBar::refresh);
        connect(field, &NumberField::faultChanged, this,
                [this] { m_fault.say(m_scale.fault().isEmpty() ? m_tolerance.fault() : m_scale.fault()); });
    }
    for (QComboBox* const box : {&m_walls, &m_fills}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ImportBar::refresh);
    }
    for (QCheckBox* const box : {&m_layer, &m_center}) {
        connect(box, &QCheckBox::toggled, this, &ImportBar::refresh);
    }
    connect(&m_apply, &QToolButton::clicked, this, &ImportBar::apply);
    connect(&m_cancel, &QToolButton::clicked, this, &ImportBar::cancel);
    m_tick.setInterval(pace);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        m_progress.show();
        m_progress.setValue(m_percent);
    });
    m_connection = m_document.changed.connect([this](const Change&) {
        if (isOpen() && !m_updating && !m_document.hasPreview()) {
            shut();
        }
    });
}

ImportBar::~ImportBar() {
    m_stop.request_stop();
    m_document.changed.disconnect(m_connection);
}

void ImportBar::layOut() {
    m_column.setContentsMargins(10, 4, 6, 4);
    m_column.setSpacing(4);
    m_column.addLayout(&m_top);
    m_column.addLayout(&m_fields);
    m_column.addLayout(&m_choices);
    m_column.addWidget(&m_fault);
    m_column.addWidget(&m_report);
    m_top.setSpacing(6);
    m_top.addWidget(&m_title, 1);
    m_top.addWidget(&m_progress);
    m_top.addWidget(&m_apply);
    m_top.addWidget(&m_cancel);
    for (QLabel* const label : {&m_title, &m_summary, &m_report}) {
        label->setTextFormat(Qt::PlainText); // names may hold anything
    }
    m_title.setMinimumWidth(1); // however long the name of the file is
    m_report.setWordWrap(true);
    m_fault.setObjectName(QStringLiteral("refusal"));
    m_progress.setRange(0, 100);
    m_progress.setMaximumWidth(140);
    m_progress.setAccessibleName(tr("Progress of the import"));
    m_apply.setText(tr("Import"));
    m_apply.setToolTip(tr("Add what is shown to the level (Enter)"));
    m_cancel.setText(tr("Cancel"));
    m_cancel.setToolTip(tr("Leave the level as it was (Escape)"));
    layOutFields();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum); // grows with its lines
    hide();
}

void ImportBar::layOutFields() {
    constexpr double largest = 1e6; // m
    m_scale.setSpec({.unit = QStringLiteral("m"),
                     .min = 0,
                     .max = largest,
                     .openMin = true,
                     .step = 0.01,
                     .meaning = tr("What a unit of the file is: a pixel of a drawing, a pixel of a map.")});
    m_tolerance.setSpec({.unit = QStringLiteral("m"),
                         .min = leastTolerance,
                         .max = 1000,
                         .step = 0.01,
                         .meaning = tr("How far straight segments may stray from a curve.")});
    m_tolerance.setValue(ImportOptions().tolerance);
    m_scaleLabel.setText(tr("Scale"));
    m_toleranceLabel.setText(tr("Tolerance"));
    m_walls.addItems({tr("Two-way walls"), tr("One-way walls")});
    m_walls.setToolTip(tr("What lines without a fill become"));
    m_walls.setAccessibleName(m_walls.toolTip());
    m_fills.addItems({tr("Fills as polygons"), tr("Fills as walls")});
    m_fills.setToolTip(tr("What filled shapes become"));
    m_fills.setAccessibleName(m_fills.toolTip());
    m_layer.setText(tr("New layer"));
    m_layer.setToolTip(tr("Put all of it into a new layer, named like the file"));
    m_center.setText(tr("Center in view"));
    m_center.setToolTip(tr("Put it into the middle of the view, else where the file has it"));
    m_center.setChecked(true);
    m_fields.setSpacing(6);
    m_fields.addWidget(&m_scaleLabel);
    m_fields.addBeside(&m_scale);
    m_fields.addWidget(&m_toleranceLabel);
    m_fields.addBeside(&m_tolerance);
    m_fields.addWidget(&m_summary);
    m_choices.setSpacing(6);
    for (QWidget* const widget : std::initializer_list<QWidget*>{&m_walls, &m_fills, &m_layer, &m_center}) {
        m_choices.addWidget(widget);
    }
}

void ImportBar::setWords(const std::function<QString(const Error&)>& words) {
    m_words = words;
    m_scale.words = words;
    m_tolerance.words = words;
}

void ImportBar::begin(const QString& path) {
    cancel();
    m_toolbox.cancel();
    m_context = m_toolbox.context();
    m_path = path;
    m_place = m_middle ? m_middle() : Vec2(0, 0);
    m_drawing.reset();
    m_edit.reset();
    m_lines.clear();
    m_hasAppeared = m_isWanted = false;
    m_scale.setValue({});
    m_title.setText(tr("Import %1").arg(QFileInfo(path).fileName()));
    m_title.setToolTip(plainToolTip(path));
    m_summary.setText(tr("Reading…"));
    m_report.hide();
    m_progress.hide();
    m_fault.say({});
    m_apply.setEnabled(false);
    QWidget::show();
    m_tolerance.setFocus();
    m_tolerance.selectAll();
    refresh();
}

ImportOptions ImportBar::options() const {
    ImportOptions options;
    if (m_drawing) {
        options.scale = m_scale.value();
    }
    options.tolerance = m_tolerance.value().value_or(options.tolerance);
    options.walls = m_walls.currentIndex() == 1 ? ImportedWalls::OneWay : ImportedWalls::TwoWay;
    options.fillsAsWalls = m_fills.currentIndex() == 1;
    return options;
}

void ImportBar::refresh() {
    if (!isOpen()) {
        return;
    }
    m_isStale = true;
    if (m_task.isRunning()) {
        m_stop.request_stop(); // it begins anew as soon as it has ended
    } else {
        start();
    }
}

void ImportBar::start() {
    m_isStale = false;
    m_stop = std::stop_source();
    m_percent = 0;
    m_tick.start();
    ImportPlace place;
    if (m_center.isChecked()) {
        place.middle = m_place;
        place.step = m_context->snap.grid ? m_context->snap.step : 0;
    }
    if (m_layer.isChecked()) {
        place.layer = QFileInfo(m_path).completeBaseName().toStdString();
    }
    place.seed = m_context->seed;
    m_task.start([this, place, path = m_path, known = m_drawing, wanted = options(), base = m_context->edit.level,
                  watch = Watch{m_stop.get_token(), &m_percent}](const std::stop_token&) -> BackgroundTask::Then {
        Outcome outcome;
        outcome.drawing = known;
        if (!known) {
            Result<Drawing> drawing = drawingIn(path, watch);
            if (!drawing) {
                outcome.error = drawing.error();
            } else {
                outcome.drawing = std::make_shared<const Drawing>(std::move(drawing).value());
            }
        }
        if (outcome.drawing) {
            Result<Import> import = importOf(*outcome.drawing, wanted, watch, &outcome.notes);
            if (!import) {
                outcome.error = import.error();
            } else {
                Import made = std::move(import).value();
                outcome.vertices = made.vertices;
                outcome.notes = std::move(made.notes);
                outcome.objects = static_cast<int>(std::ranges::count_if(made.foreign.objects, [](const Object& one) {
                    return !std::holds_alternative<GroupObject>(one.data);
                }));
                Imported result = spacetow::imported(*base, std::move(made.foreign), place);
                std::ranges::move(result.notes, std::back_inserter(outcome.notes));
                outcome.box = boundsOf(result.level, result.keys);
                outcome.edit =
                    Edit{std::make_shared<const Level>(std::move(result.level)), Selection(std::move(result.keys))};
            }
        }
        return [this, outcome] { take(outcome); };
    });
}

void ImportBar::finishWork() {
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

void ImportBar::take(Outcome outcome) {
    m_tick.stop();
    m_progress.hide();
    if (!isOpen()) {
        return;
    }
    if (outcome.drawing && !m_drawing) {
        m_drawing = outcome.drawing;
        m_scale.setValue(m_drawing->metresPerUnit);
    }
    if (m_isStale) {
        start();
        return;
    }
    if (!m_drawing) { // no file that can be imported, whatever the options
        shut();
        m_document.dropPreview();
        Q_EMIT refused(m_path, *outcome.error);
        return;
    }
    show(outcome);
    if (m_isWanted && m_edit) {
        apply();
    }
    m_isWanted = false;
}

void ImportBar::show(const Outcome& outcome) {
    const QScopedValueRollback<bool> guard(m_updating, true);
    m_edit = outcome.edit;
    m_count = outcome.objects;
    m_apply.setEnabled(m_edit.has_value());
    m_fault.say(outcome.error && m_words ? m_words(*outcome.error) : QString());
    say(outcome.notes);
    if (!m_edit) {
        m_summary.clear();
        m_document.dropPreview();
        return;
    }
    const QLocale locale;
    const Vec2 size = outcome.box.isEmpty() ? Vec2(0, 0) : outcome.box.size();
    m_summary.setText(tr("%1 objects, %2 vertices, %3 × %4 m")
                          .arg(countText(m_count), countText(outcome.vertices), locale.toString(size.x(), 'g', 4),
                               locale.toString(size.y(), 'g', 4)));
    m_document.preview(*m_edit);
    if (!m_hasAppeared) {
        m_hasAppeared = true;
        Q_EMIT appeared(outcome.box);
    }
}

void ImportBar::say(const std::vector<Error>& notes) {
    m_lines.clear();
    for (const Error& note : notes) {
        m_lines << (m_words ? m_words(note) : QString::fromUtf8(note.code.text()));
    }
    QStringList shown = m_lines.mid(0, fewReportLines);
    if (m_lines.size() > fewReportLines) {
        shown << tr("… and %1 more").arg(countText(m_lines.size() - fewReportLines));
    }
    m_report.setText(shown.join(QLatin1Char('\n')));
    m_report.setVisible(!shown.isEmpty());
}

void ImportBar::apply() {
    // A click on the button leaves the focus, and what is typed, where they are.
    if (!isOpen() || !m_scale.enterTyped() || !m_tolerance.enterTyped()) {
        return;
    }
    if (m_task.isRunning()) {
        m_isWanted = true;
        return;
    }
    if (!m_edit) {
        return;
    }
    const Edit edit = *m_edit;
    const int count = m_count;
    const QString name = QFileInfo(m_path).fileName();
    const QStringList lines = m_lines;
    shut();
    m_document.commit({"import", count}, edit);
    Q_EMIT imported(name, lines);
}

void ImportBar::cancel() {
    if (isOpen()) {
        shut();
        m_document.dropPreview();
    }
}

void ImportBar::shut() {
    m_context.reset();
    m_stop.request_stop();
    finishWork();
    m_tick.stop();
    m_drawing.reset();
    m_edit.reset();
    hide();
    Q_EMIT closed();
}

void ImportBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        cancel();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        apply();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace spacetow
