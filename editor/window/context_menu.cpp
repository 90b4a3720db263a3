#include "editor/window/context_menu.h"

#include "editor/canvas/icons.h"
#include "editor/editing/group_picking.h"
#include "editor/editing/node_pick.h"
#include "editor/panels/names.h"
#include "editor/window/main_window.h"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

namespace spacetow {

namespace {

struct Rule {}; // between two parts of a menu
using Item = std::variant<Rule, ActionId, MenuId>;

constexpr Item objectItems[] = {
    Act::Cut,      Act::Copy,         Act::Paste,   Act::Duplicate, Act::Delete,  Rule(),       Act::Rename,
    ToolId::Nodes, Act::InsertNode,   Act::Reverse, Rule(),         Act::Group,   Act::Ungroup, MenuId::Order,
    MenuId::Align, MenuId::Transform, Rule(),       Act::Hide,      Act::Isolate, Act::Lock,    Rule(),
    Act::Frame,    Act::PlayFromHere,
};
constexpr Item nodeItems[] = {
    Act::InsertNode, Act::InsertMidpoints, Act::Delete,     Act::DeleteSegments,  Rule(),
    Act::JoinNodes,  Act::JoinBySegment,   Act::BreakNodes, Act::StraightenNodes, Act::Reverse,
    Rule(),          Act::SelectAll,       Act::Frame,      Act::PlayFromHere,
};
constexpr Item groundItems[] = {
    Act::Paste,    Act::PasteInPlace,    Rule(), Act::SelectAll,    Act::ShowAll, Act::UnlockAll, Rule(),
    Act::FitLevel, Act::LevelProperties, Rule(), Act::PlayFromHere,
};
constexpr Item outlinerItems[] = {
    Act::Cut,          Act::Copy,         Act::Paste,   Act::Duplicate, Act::Delete,  Rule(),
    Act::Rename,       Act::Group,        Act::Ungroup, MenuId::Order,  Rule(),       Act::NewLayer,
    Act::ToLayerAbove, Act::ToLayerBelow, Rule(),       Act::Hide,      Act::Isolate, Act::Lock,
    Act::ShowAll,      Act::UnlockAll,    Rule(),       Act::Frame,
};

template <class IsSo>
bool any(const Level& level, IsSo isSo) {
    for (const Object& object : level.objects) {
        if (isSo(object)) {
            return true;
        }
    }
    return false;
}

/// Of what is always possible: whether it would change nothing in this level.
bool isIdle(ActionId id, const Level& level) {
    return (id == ActionId(Act::ShowAll) && !any(level, [](const Object& object) { return !object.visible; })) ||
           (id == ActionId(Act::UnlockAll) && !any(level, [](const Object& object) { return object.locked; }));
}

/// Leaves out what is not possible, and rules that would part nothing.
class ContextMenu {
  public:
    ContextMenu(MainWindow& window, QMenu& menu) : m_window(window), m_menu(menu) {}

    /// What lies on each other there, to be selected.
    void addPile(const std::vector<GroupPick>& pile);
    void add(std::span<const Item> items, bool onEdge);

  private:
    void add(QAction& action);
    void add(const Item& item, bool onEdge);
    QAction* nodesEntry();

    MainWindow& m_window;
    QMenu& m_menu;
    bool m_isNewPart = false;
};

void ContextMenu::addPile(const std::vector<GroupPick>& pile) {
    if (pile.size() < 2) {
        return;
    }
    QMenu* const under = m_menu.addMenu(MainWindow::tr("Select &Under Pointer"));
    Document& document = m_window.document();
    for (const GroupPick& pick : pile) {
        const Object& object = *document.level().objects.find(pick.key);
        QAction* const action = under->addAction(icon(kindIcon(object), m_window.palette()),
                                                 menuSafe(listedName(document.level(), object)));
        action->setCheckable(true);
        action->setChecked(document.selection().contains(pick.key));
        QObject::connect(action, &QAction::triggered, &m_window,
                         [&document, pick] { document.select(Selection({pick.key}).entering(pick.entered)); });
    }
    m_isNewPart = true;
}

void ContextMenu::add(std::span<const Item> items, bool onEdge) {
    for (const Item& item : items) {
        add(item, onEdge);
    }
}

void ContextMenu::add(QAction& action) {
    if (std::exchange(m_isNewPart, false) && !m_menu.isEmpty()) {
        m_menu.addSeparator();
    }
    m_menu.addAction(&action);
}

void ContextMenu::add(const Item& item, bool onEdge) {
    const auto* const id = std::get_if<ActionId>(&item);
    if (std::holds_alternative<Rule>(item)) {
        m_isNewPart = true;
    } else if (const auto* const submenu = std::get_if<MenuId>(&item)) {
        QMenu& menu = m_window.menu(*submenu);
        if (std::ranges::any_of(menu.actions(),
                                [](const QAction* action) { return action->isEnabled() && !action->isSeparator(); })) {
            add(*menu.menuAction());
        }
    } else if (*id == ActionId(ToolId::Nodes)) {
        if (m_window.toolbox().current() != ToolId::Nodes && selectedKinds(m_window.document().shown()).nodes) {
            add(*nodesEntry());
        }
    } else if (m_window.actions()[*id].isEnabled() && (onEdge || *id != ActionId(Act::InsertNode)) &&
               !isIdle(*id, m_window.document().level())) {
        add(m_window.actions()[*id]);
    }
}

/// The tool, called what it does with an object, and without the mark of one that is in the hand or not.
QAction* ContextMenu::nodesEntry() {
    QAction& tool = m_window.actions()[ToolId::Nodes];
    const QString key = tool.shortcut().toString(QKeySequence::NativeText);
    auto* const entry = new QAction(tool.icon(), MainWindow::tr("Edit N&odes") + QLatin1Char('\t') + key, &m_menu);
    entry->setStatusTip(tool.statusTip());
    QObject::connect(entry, &QAction::triggered, &tool, &QAction::trigger);
    return entry;
}

} // namespace

void fillMenuAtPointer(MainWindow& window, QMenu& menu) {
    Document& document = window.document();
    const Pointer pointer{.world = window.canvas().pointerPosition(), .pixel = window.canvas().view().pixel()};
    const std::vector<GroupPick> pile =
        window.isPlaying() ? window.liveView().hand().under(pointer) : pickedMembers(document.current(), pointer);
    const bool isSelected =
        std::ranges::any_of(pile, [&](const GroupPick& pick) { return document.selection().contains(pick.key); });
    if (!pile.empty() && !isSelected) {
        document.select(Selection({pile.front().key}).entering(pile.front().entered));
    }
    // What runs is not where the level has it.
    const std::vector<Key> outlines = window.isPlaying() ? std::vector<Key>() : keysInEdit(document.current());
    const std::optional<Hit> part = nodeHit(document.level(), {pointer.world, grabPixels * pointer.pixel, outlines});
    const bool onEdge = part && part->kind == HitKind::Segment;
    const bool ofNodes = part && window.toolbox().current() == ToolId::Nodes && !document.selection().nodes().empty();
    ContextMenu filler(window, menu);
    filler.addPile(pile);
    if (ofNodes) {
        filler.add(nodeItems, onEdge);
    } else if (pile.empty()) {
        filler.add(groundItems, false);
    } else {
        filler.add(objectItems, onEdge);
    }
}

void fillMenuOfSelection(MainWindow& window, QMenu& menu) {
    const Selection& selection = window.document().selection();
    const bool ofNodes = window.toolbox().current() == ToolId::Nodes && !selection.nodes().empty();
    if (selection.empty()) {
        ContextMenu(window, menu).add(groundItems, false);
    } else if (ofNodes) {
        ContextMenu(window, menu).add(nodeItems, false);
    } else {
        ContextMenu(window, menu).add(objectItems, false);
    }
}

void fillMenuOfOutliner(MainWindow& window, QMenu& menu) {
    ContextMenu(window, menu).add(outlinerItems, false);
}

} // namespace spacetow
