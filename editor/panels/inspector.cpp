#include "editor/panels/inspector.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/rectangles.h"
#include "editor/editing/collisions.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <QShowEvent>

#include <algorithm>
#include <functional>

namespace spacetow {

namespace {

/// Why the objects cannot be put into the group, or an empty text.
QString objectionToParent(const Level& level, std::span<const Key> keys, const FieldEdit& edit) {
    const std::optional<FieldValue> value = edit.change(Unset{});
    const KeyValue* parent = value ? std::get_if<KeyValue>(&*value) : nullptr;
    const Object* group = parent == nullptr ? nullptr : level.objects.find(parent->key);
    if (group == nullptr) {
        return {};
    }
    const GroupTree tree(level);
    const bool isCircle =
        std::ranges::any_of(keys, [&](Key key) { return key == group->key || tree.isWithin(*group, key); });
    return isCircle ? Inspector::tr("A group cannot be put into itself.") : QString();
}

/// Of so many objects all are looked at during a gesture; of more only some, evenly spread, until it ends.
constexpr int mostLive = 2000;

QString counted(const std::vector<int>& kinds) {
    QStringList parts;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        if (kinds[kind] > 0) {
            parts << QStringLiteral("%1 × %2").arg(kinds[kind]).arg(kindName(static_cast<int>(kind)));
        }
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace

Inspector::Inspector(Document& document, Words words, QWidget* parent)
    : QWidget(parent), m_document(document), m_words(std::move(words)), m_column(this), m_level(document, m_words),
      m_objectPage(objectRows(), target()) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    for (QLabel* label : {&m_title, &m_subtitle}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        m_column.addWidget(label);
    }
    m_title.setContentsMargins(10, 8, 10, 0);
    m_subtitle.setContentsMargins(10, 0, 10, 4);
    m_subtitle.setForegroundRole(QPalette::PlaceholderText);
    QFont font = m_title.font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    m_title.setFont(font);
    m_shapeBox.setAccessibleName(tr("Shape"));
    m_shapeBox.setToolTip(tr("Which shape the fields of shapes speak of"));
    m_shapeBox.setFocusPolicy(Qt::StrongFocus);
    m_shapeBox.hide();
    connect(&m_shapeBox, &QComboBox::activated, this, [this](int index) {
        m_shape = index - 1;
        m_objectPage.form().revert();
        refresh();
    });
    m_column.addWidget(&m_motion);
    m_motion.hide();
    m_column.addLayout(&m_shapeRow);
    m_shapeRow.setContentsMargins(10, 0, 10, 0);
    m_shapeRow.addWidget(&m_shapeBox);
    m_column.addWidget(&m_pages, 1);
    m_pages.addWidget(&m_level);
    m_pages.addWidget(&m_objectPage);
    connect(&m_level.form(), &Form::sectionsFolded, this, &Inspector::sectionsFolded);
    connect(&m_objectPage.form(), &Form::sectionsFolded, this, &Inspector::sectionsFolded);
    m_listener = m_document.changed.connect([this](const Change&) {
        if (isVisible()) {
            refresh();
        }
    });
    refresh();
}

Inspector::~Inspector() {
    m_document.changed.disconnect(m_listener);
}

FormTarget Inspector::target() {
    FormTarget target;
    target.edit = [this](const FormEdit& edit) { return make(edit); };
    target.words = m_words;
    target.level = [this]() -> const Level& { return m_document.level(); };
    target.defineTag = [this](int index, const TagInfo& info, const FormEdit& edit) { defineTag(index, info, edit); };
    target.selectTagged = [this](int tag) {
        m_document.select(Selection(keysTagged(*m_document.current().level, tag)));
    };
    target.showObject = [this](Key key) { Q_EMIT objectWanted(key); };
    return target;
}

/// Nothing stands for a body that is gone.
void Inspector::showMotion(const std::optional<Motion>& motion) {
    if (motion) {
        m_motion.showMotion(*motion);
    } else {
        m_motion.showGone();
    }
    m_motion.show();
}

void Inspector::showTension(double distance, double length, double tension) {
    m_motion.showTension(distance, length, tension);
    m_motion.show();
}

QStringList Inspector::foldedSections() const {
    QStringList titles = m_objectPage.form().foldedSections();
    for (const QString& title : m_level.form().foldedSections()) {
        titles << QStringLiteral("level/") + title;
    }
    return titles;
}

void Inspector::foldSections(const QStringList& titles) {
    QStringList ofLevel;
    for (const QString& title : titles) {
        if (title.startsWith(QLatin1String("level/"))) {
            ofLevel << title.mid(6);
        }
    }
    m_objectPage.form().foldSections(titles);
    m_level.form().foldSections(ofLevel);
}

QSize Inspector::minimumSizeHint() const {
    return {std::max(m_level.minimumSizeHint().width(), m_objectPage.narrowWidth()), 120};
}

QSize Inspector::sizeHint() const {
    return {std::max(m_level.sizeHint().width(), m_objectPage.fullWidth()), 480};
}

void Inspector::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void Inspector::refresh() {
    const Edit& shown = m_document.shown();
    if (!(shown.selection == m_shown)) {
        m_shown = shown.selection;
        m_shape = -1;
        m_places.clear();
        m_objectPage.form().revert();
        m_level.form().revert();
    }
    if (shown.selection.empty()) {
        m_shapeBox.hide();
        m_title.setText(tr("Level"));
        m_subtitle.setText(tr("Nothing is selected."));
        m_level.refresh();
        m_pages.setCurrentWidget(&m_level);
        return;
    }
    showObjects(shown);
    m_pages.setCurrentWidget(&m_objectPage);
}

const Object* Inspector::selected(const Edit& shown, int index) {
    const ObjectList& objects = shown.level->objects;
    const std::vector<Key>& keys = shown.selection.keys();
    if (static_cast<int>(keys.size()) == objects.size()) {
        return &objects[index]; // all of them, and their order does not matter
    }
    const auto i = static_cast<std::size_t>(index);
    m_places.resize(keys.size(), -1);
    int& place = m_places[i];
    if (place < 0 || place >= objects.size() || objects[place].key != keys[i]) {
        place = objects.indexOf(keys[i]);
    }
    return place < 0 ? nullptr : &objects[place];
}

void Inspector::showObjects(const Edit& shown) {
    const bool isLive = m_document.hasPreview();
    const int count = shown.selection.size();
    const int stride = isLive && count > mostLive ? count / mostLive : 1;
    FieldSurvey survey;
    SizeSurvey sizes;
    const std::vector<ShapeRef> meant = shapes(shown.selection);
    std::vector<int> kinds(static_cast<std::size_t>(kindCount()));
    const Object* last = nullptr;
    for (int i = 0; i < count; i += stride) {
        if (const Object* object = selected(shown, i)) {
            survey.add(*object, meant.empty() ? std::vector<int>() : shapesOf(meant, object->key));
            sizes.add(*object);
            ++kinds[static_cast<std::size_t>(kindOf(*object))];
            last = object;
        }
    }
    if (last == nullptr) {
        return;
    }
    if (stride == 1) {
        showTitle(kinds, *last);
        showShapes(*last);
    }
    std::vector<FieldSummary> fields = survey.summaries();
    std::ranges::move(sizes.summaries(), std::back_inserter(fields));
    m_objectPage.form().setContent({std::move(fields), survey.objects(), isLive});
}

std::vector<ShapeRef> Inspector::shapes(const Selection& selection) const {
    if (m_shape >= 0 && selection.size() == 1 && selection.nodes().empty()) {
        return {{selection.keys().front(), m_shape}};
    }
    return shapesOf(selection);
}

void Inspector::showShapes(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    const bool isChoice = m_shown.size() == 1 && m_shown.nodes().empty() && body != nullptr && body->shapes.size() > 1;
    if (isChoice) {
        QStringList texts{tr("All %n shapes", nullptr, static_cast<int>(body->shapes.size()))};
        for (std::size_t i = 0; i < body->shapes.size(); ++i) {
            texts << tr("Shape %1: %2").arg(i + 1).arg(kindName(static_cast<int>(body->shapes[i].index())));
        }
        m_shape = std::min(m_shape, static_cast<int>(body->shapes.size()) - 1);
        QStringList before;
        for (int i = 0; i < m_shapeBox.count(); ++i) {
            before << m_shapeBox.itemText(i);
        }
        if (texts != before) {
            m_shapeBox.clear();
            m_shapeBox.addItems(texts);
        }
        m_shapeBox.setCurrentIndex(m_shape + 1);
    }
    m_shapeBox.setVisible(isChoice);
}

void Inspector::showTitle(const std::vector<int>& kinds, const Object& last) {
    if (m_shown.size() == 1) {
        const auto nodes = static_cast<int>(m_shown.nodes().size());
        m_title.setText(displayName(last));
        m_subtitle.setText(nodes == 0
                               ? placedKind(last)
                               : counted(tr("%1, %n nodes selected", nullptr, nodes), nodes).arg(placedKind(last)));
    } else {
        m_title.setText(counted(tr("%n objects", nullptr, m_shown.size()), m_shown.size()));
        m_subtitle.setText(counted(kinds));
    }
}

QString Inspector::make(const FormEdit& edit) {
    if (edit.phase == NumberEntry::Phase::Cancelled) {
        m_document.dropPreview();
        return {};
    }
    const Edit current = m_document.current();
    const Selection& selection = current.selection;
    const std::vector<ShapeRef> meant = shapes(selection);
    Level level = *current.level;
    int refused = 0;
    for (const FieldEdit& field : edit.fields) {
        if (const QString objection =
                field.id == "parent" ? objectionToParent(level, selection.keys(), field) : QString();
            !objection.isEmpty()) {
            return objection;
        }
        FieldEditResult result = isSizeField(field.id)
                                     ? withSizeEdited(std::move(level), selection.keys(), field)
                                     : withFieldEdited(std::move(level), {selection.keys(), meant}, field);
        level = std::move(result.level);
        refused += result.refused;
    }
    if (refused > 0) {
        return selection.size() == 1
                   ? tr("That would leave the range of the field, so nothing has changed.")
                   : counted(tr("%n of the values would leave the range of the field, so nothing has changed.", nullptr,
                                refused),
                             refused);
    }
    Edit made{std::make_shared<const Level>(std::move(level)), selection};
    if (edit.phase == NumberEntry::Phase::Preview) {
        m_document.preview(std::move(made));
        return {};
    }
    std::string mergeKey;
    if (edit.mayMerge && !edit.fields.empty()) {
        mergeKey =
            "field " + edit.fields.front().id + ' ' + std::to_string(selection.empty() ? 0 : selection.keys().front());
    }
    m_document.commit({"change", std::max(1, selection.size()), changedField(edit)}, std::move(made), mergeKey);
    refresh();
    return {};
}

void Inspector::defineTag(int index, const TagInfo& info, const FormEdit& edit) {
    const Edit current = m_document.current();
    Level level = withTag(*current.level, index, info);
    const std::vector<ShapeRef> meant = shapes(current.selection);
    for (const FieldEdit& field : edit.fields) {
        level = withFieldEdited(std::move(level), {current.selection.keys(), meant}, field).level;
    }
    m_document.commit({"change-tag", 1}, {std::make_shared<const Level>(std::move(level)), current.selection});
    refresh();
}

} // namespace spacetow
