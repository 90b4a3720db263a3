#include "editor/panels/inspector.h"

#include "core/level/edits.h"
#include "editor/panels/names.h"

#include <QShowEvent>
#include <QStyle>

#include <algorithm>
#include <functional>

namespace spacetow {

namespace {

void dress(QScrollArea& page, Form& form) {
    page.setWidget(&form);
    page.setWidgetResizable(true);
    page.setFrameShape(QFrame::NoFrame);
    page.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // see minimumSizeHint
}

} // namespace

Inspector::Inspector(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_column(this), m_levelForm(levelRows()), m_objectForm(objectRows()) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_title.setContentsMargins(10, 8, 10, 2);
    m_title.setTextFormat(Qt::PlainText);
    m_title.setWordWrap(true);
    QFont font = m_title.font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    m_title.setFont(font);
    m_column.addWidget(&m_title);
    m_column.addWidget(&m_pages, 1);
    dress(m_levelPage, m_levelForm);
    dress(m_objectPage, m_objectForm);
    m_pages.addWidget(&m_levelPage);
    m_pages.addWidget(&m_objectPage);
    watch(m_levelForm);
    watch(m_objectForm);
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
    refresh();
}

Inspector::~Inspector() {
    m_document.changed.disconnect(m_listener);
    // The forms are members of this, not children of their pages.
    m_levelPage.takeWidget();
    m_objectPage.takeWidget();
}

void Inspector::watch(Form& form) {
    connect(&form, &Form::entered, this, &Inspector::enter);
    connect(&form, &Form::tagSwitched, this, &Inspector::switchTag);
    connect(&form, &Form::tagDefined, this, &Inspector::defineTag);
}

QSize Inspector::minimumSizeHint() const {
    const int form = std::max(m_levelForm.fullWidth(), m_objectForm.fullWidth());
    return {form + style()->pixelMetric(QStyle::PM_ScrollBarExtent), 120};
}

void Inspector::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void Inspector::refresh() {
    const Level& level = m_document.level();
    const Selection& selection = m_document.selection();
    if (selection.empty()) {
        m_title.setText(tr("Level"));
        m_levelForm.setThings({fieldsOf(level)}, level.tags);
        m_pages.setCurrentWidget(&m_levelPage);
        return;
    }
    std::vector<std::vector<FieldEntry>> things;
    const Object* last = nullptr;
    for (const Object& object : level.objects) {
        if (selection.contains(object.key)) {
            things.push_back(fieldsOf(object));
            last = &object;
        }
    }
    m_title.setText(things.size() == 1 ? displayName(*last)
                                       : tr("%n objects", nullptr, static_cast<int>(things.size())));
    m_objectForm.setThings(things, level.tags);
    m_pages.setCurrentWidget(&m_objectPage);
}

void Inspector::changeObjects(const QString& id, const std::function<void(Object&)>& change) {
    const Edit& current = m_document.current();
    auto level = std::make_shared<Level>(*current.level);
    for (int i = 0; i < level->objects.size(); ++i) {
        if (current.selection.contains(level->objects[i].key)) {
            Object object = level->objects[i];
            change(object);
            level->objects.replace(i, std::move(object));
        }
    }
    const Selection& selection = current.selection;
    const std::string mergeKey =
        "field " + id.toStdString() + ' ' + std::to_string(selection.empty() ? 0 : selection.keys().front());
    m_document.commit({"change", selection.size()}, {std::move(level), selection}, mergeKey);
    refresh();
}

void Inspector::enter(const QString& id, const FieldValue& value) {
    const std::string field = id.toStdString();
    if (!m_document.selection().empty()) {
        changeObjects(id, [&](Object& object) { setField(object, field, value); });
        return;
    }
    auto level = std::make_shared<Level>(*m_document.current().level);
    setField(*level, field, value);
    m_document.commit({"change-level", 1}, {std::move(level), m_document.selection()}, "level " + field);
    refresh();
}

void Inspector::switchTag(const QString& id, int index, bool on) {
    changeObjects(id, [&](Object& object) {
        for (const FieldEntry& entry : fieldsOf(object)) {
            const TagMask* mask = entry.id == id.toStdString() ? std::get_if<TagMask>(&entry.value) : nullptr;
            if (mask != nullptr) {
                const std::uint32_t bit = TagMask::bit(index).bits;
                setField(object, entry.id, TagMask{on ? mask->bits | bit : mask->bits & ~bit});
                return;
            }
        }
    });
}

void Inspector::defineTag(int index, const QString& name, const QColor& color) {
    const Edit& current = m_document.current();
    TagInfo info{name.toStdString(), color.rgb() & 0xffffffU};
    m_document.commit({"change-tag", 1},
                      {std::make_shared<Level>(withTag(*current.level, index, std::move(info))), current.selection});
    refresh();
}

} // namespace spacetow
