#include "editor/panels/explain_panel.h"

#include "editor/panels/list_keys.h"
#include "editor/panels/names.h"

#include <QHeaderView>

namespace spacetow {

namespace {

constexpr int pauseBetweenLooks = 90; // ms: what changes faster cannot be read
constexpr int targetRole = Qt::UserRole;

void setText(QTreeWidgetItem& item, int column, const QString& text) {
    if (item.text(column) != text) {
        item.setText(column, text);
        item.setToolTip(column, plainToolTip(text));
    }
}

/// So many children, those that stay unchanged.
void resizeTo(QTreeWidgetItem& item, int count) {
    while (item.childCount() > count) {
        delete item.takeChild(item.childCount() - 1);
    }
    while (item.childCount() < count) {
        item.addChild(new QTreeWidgetItem); // owned by the item
    }
}

} // namespace

ExplainPanel::ExplainPanel(Document& document, Words words, QWidget* parent)
    : QWidget(parent), m_document(document), m_words(std::move(words)), m_column(this) {
    layOut();
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseBetweenLooks);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_stale) {
            refresh();
        }
    });
    connect(&m_cure, &QPushButton::clicked, this, &ExplainPanel::carryOut);
    connect(&m_rows, &QTreeWidget::itemClicked, this, &ExplainPanel::follow);
    connect(&m_rows, &QTreeWidget::itemActivated, this, &ExplainPanel::follow);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (!(change.before.selection == change.after.selection) || change.before.level != change.after.level) {
            refreshSoon();
        }
    });
}

ExplainPanel::~ExplainPanel() {
    m_document.changed.disconnect(m_listener);
}

void ExplainPanel::layOut() {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(2);
    for (QLabel* label : {&m_title, &m_answer}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 6, 8, 2);
        m_column.addWidget(label);
    }
    m_answer.setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_column.addWidget(&m_cure);
    m_column.addWidget(&m_rows, 1);
    m_column.addStretch(); // below the answer about two
    m_cure.hide();
    m_answer.hide();
    m_rows.setColumnCount(2);
    m_rows.setHeaderLabels({tr("What"), tr("How much")});
    m_rows.header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_rows.header()->setStretchLastSection(true);
    m_rows.setFrameShape(QFrame::NoFrame);
    m_rows.setRootIsDecorated(true);
    m_rows.setUniformRowHeights(true);
    m_rows.setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_rows.setAccessibleName(tr("Explanation of the selection"));
    m_rows.installEventFilter(this);
}

void ExplainPanel::showSession(std::shared_ptr<const Session> session) {
    m_session = std::move(session);
    refreshSoon();
}

void ExplainPanel::refreshSoon() {
    m_stale = true;
    if (!m_pause.isActive() && isVisible()) {
        refresh();
    }
}

void ExplainPanel::refresh() {
    m_stale = false;
    m_pause.start();
    const std::vector<Key> keys(m_document.selection().keys().begin(), m_document.selection().keys().end());
    const Key object = keys.size() == 1 ? keys.front() : 0;
    const Object* found = m_document.level().objects.find(object);
    m_title.setText(found != nullptr ? listedName(m_document.level(), *found)
                    : keys.empty()   ? tr("Everything. Select one object to see what moves it, or two to hear why they "
                                            "do not collide.")
                    : keys.size() == 2 ? tr("Why do these two not collide?")
                                       : tr("Select one object, or two."));
    showAnswer(keys);
    const bool anything = m_session != nullptr && keys.size() <= 1;
    showSections(anything ? explainSections(*m_session, object) : std::vector<ExplainSection>{});
    if (found != nullptr && m_session != nullptr && m_rows.topLevelItemCount() == 0) {
        m_title.setText(tr("“%1” is not part of the simulation.").arg(listedName(m_document.level(), *found)));
    }
    if (object != m_object) {
        m_object = object;
        Q_EMIT explainedChanged();
    }
}

void ExplainPanel::showAnswer(const std::vector<Key>& keys) {
    m_offered.reset();
    QString text;
    if (keys.size() == 2 && m_session != nullptr) {
        const Level& level = *m_document.current().level;
        if (const std::optional<ApartObjects> apart = apartObjects(*m_session, keys[0], keys[1])) {
            text = m_words(apartCode(level, *apart));
            m_offered = cureOf(level, *apart);
            if (m_offered) {
                m_cure.setText(menuSafe(m_words(cureCode(level, *m_offered))));
                m_cure.setToolTip(plainToolTip(m_words(cureCode(level, *m_offered))));
            }
        } else {
            text = tr("At least one of them is no body in the simulation.");
        }
    }
    m_answer.setText(text);
    m_answer.setVisible(!text.isEmpty());
    m_cure.setVisible(m_offered.has_value());
}

void ExplainPanel::showSections(const std::vector<ExplainSection>& sections) {
    m_rows.setVisible(!sections.empty());
    while (m_rows.topLevelItemCount() > static_cast<int>(sections.size())) {
        delete m_rows.takeTopLevelItem(m_rows.topLevelItemCount() - 1);
    }
    for (int i = 0; i < static_cast<int>(sections.size()); ++i) {
        const ExplainSection& section = sections[static_cast<std::size_t>(i)];
        const bool isNew = i >= m_rows.topLevelItemCount();
        if (isNew) {
            m_rows.addTopLevelItem(new QTreeWidgetItem); // owned by the tree
        }
        QTreeWidgetItem& head = *m_rows.topLevelItem(i);
        setText(head, 0, section.title);
        resizeTo(head, static_cast<int>(section.rows.size()));
        for (int k = 0; k < head.childCount(); ++k) {
            const ExplainRow& row = section.rows[static_cast<std::size_t>(k)];
            QTreeWidgetItem& item = *head.child(k);
            setText(item, 0, row.what);
            setText(item, 1, row.value);
            item.setData(0, targetRole, QVariant::fromValue<quint64>(row.target));
        }
        if (isNew) {
            head.setFirstColumnSpanned(true);
            head.setExpanded(true);
        }
    }
}

void ExplainPanel::carryOut() {
    if (m_offered) {
        const Edit& current = m_document.current();
        m_document.commit({"change-tags", 1},
                          {std::make_shared<const Level>(cured(*current.level, *m_offered)), current.selection});
    }
}

void ExplainPanel::follow(QTreeWidgetItem* item) {
    const Key target = item->data(0, targetRole).toULongLong();
    if (target != 0) {
        Q_EMIT objectWanted(target);
    }
}

void ExplainPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
    Q_EMIT explainedChanged();
}

void ExplainPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    Q_EMIT explainedChanged();
}

bool ExplainPanel::eventFilter(QObject* watched, QEvent* event) {
    return (watched == &m_rows && keepsListKey(*event)) || QWidget::eventFilter(watched, event);
}

} // namespace spacetow
