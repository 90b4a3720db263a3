#include "editor/canvas/palette.h"

namespace spacetow {

namespace {

struct Tones {
    QColor window, base, alternate, button, hover, border, edge, shadow;
    QColor text, faint, off; // faint: placeholders; off: disabled
    QColor accent, onAccent, link, visited;
    QColor tip, onTip;
};

const Tones& tones(Shade shade) {
    static const Tones dark{
        QColor(33, 37, 44),    QColor(24, 27, 33),    QColor(29, 33, 39),    QColor(45, 50, 59),
        QColor(56, 62, 73),    QColor(66, 73, 86),    QColor(92, 101, 117),  QColor(12, 14, 17),
        QColor(226, 230, 238), QColor(150, 159, 175), QColor(112, 120, 134), QColor(46, 107, 214),
        QColor(255, 255, 255), QColor(122, 175, 255), QColor(189, 160, 255), QColor(53, 59, 70),
        QColor(240, 243, 248),
    };
    static const Tones light{
        QColor(243, 245, 248), QColor(255, 255, 255), QColor(248, 249, 251), QColor(252, 253, 254),
        QColor(227, 232, 240), QColor(201, 207, 217), QColor(150, 160, 176), QColor(120, 130, 145),
        QColor(30, 36, 47),    QColor(98, 107, 122),  QColor(152, 160, 173), QColor(38, 99, 214),
        QColor(255, 255, 255), QColor(26, 86, 196),   QColor(104, 58, 183),  QColor(46, 53, 66),
        QColor(244, 246, 250),
    };
    return shade == Shade::Dark ? dark : light;
}

} // namespace

QPalette panelPalette(Shade shade) {
    const Tones& t = tones(shade);
    QPalette palette;
    using Role = QPalette::ColorRole;
    const std::initializer_list<std::pair<Role, QColor>> colors{
        {Role::Window, t.window},
        {Role::WindowText, t.text},
        {Role::Base, t.base},
        {Role::AlternateBase, t.alternate},
        {Role::Text, t.text},
        {Role::Button, t.button},
        {Role::ButtonText, t.text},
        {Role::BrightText, t.onAccent},
        {Role::Light, t.hover},
        {Role::Midlight, t.hover},
        {Role::Mid, t.border},
        {Role::Dark, t.edge},
        {Role::Shadow, t.shadow},
        {Role::Highlight, t.accent},
        {Role::HighlightedText, t.onAccent},
        {Role::Link, t.link},
        {Role::LinkVisited, t.visited},
        {Role::ToolTipBase, t.tip},
        {Role::ToolTipText, t.onTip},
        {Role::PlaceholderText, t.faint},
    };
    for (const auto& [role, color] : colors) {
        palette.setColor(QPalette::All, role, color);
    }
    for (const Role role : {Role::WindowText, Role::Text, Role::ButtonText, Role::PlaceholderText}) {
        palette.setColor(QPalette::Disabled, role, t.off);
    }
    palette.setColor(QPalette::Disabled, Role::Base, t.window);
    palette.setColor(QPalette::Disabled, Role::Highlight, t.border);
    palette.setColor(QPalette::Disabled, Role::HighlightedText, t.text);
    return palette;
}

Shade shadeOf(const QPalette& palette) {
    const QColor window = palette.color(QPalette::Active, QPalette::Window);
    const QColor text = palette.color(QPalette::Active, QPalette::WindowText);
    return window.lightness() < text.lightness() ? Shade::Dark : Shade::Light;
}

MarkColors markColors(Shade shade) {
    return shade == Shade::Dark ? MarkColors{QColor(255, 128, 116), QColor(255, 200, 80), QColor(120, 220, 150)}
                                : MarkColors{QColor(186, 32, 24), QColor(138, 84, 0), QColor(20, 116, 58)};
}

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto between = [share](float a, float b) { return a + (b - a) * static_cast<float>(share); };
    return QColor::fromRgbF(between(from.redF(), to.redF()), between(from.greenF(), to.greenF()),
                            between(from.blueF(), to.blueF()), between(from.alphaF(), to.alphaF()));
}

} // namespace spacetow
