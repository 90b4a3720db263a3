#include "editor/play/hud.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {
namespace {

constexpr double bannerSeconds = 1.5;
constexpr double smallest = 5; // pixels; below that a window shows nothing anybody could read

struct HudWords {
    Q_DECLARE_TR_FUNCTIONS(Hud)
};

struct Message {
    QString title, advice;
};

/// A key in words, and what it does.
using KeyMeaning = std::pair<QString, QString>;

KeyMeaning escape() {
    return {QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText), HudWords::tr("menu")};
}

/// "Space: fly again · Esc: menu", without what no key leads to.
QString keyAdvice(std::initializer_list<KeyMeaning> meanings) {
    QStringList parts;
    for (const auto& [key, meaning] : meanings) {
        if (!key.isEmpty()) {
            parts << HudWords::tr("%1: %2", "a key and what it does").arg(key, meaning);
        }
    }
    return parts.join(QStringLiteral(" · "));
}

/// All keys that do it: "A/Left".
QString allKeys(const PlayKeys& keys, PlayKey meaning) {
    QStringList shown;
    for (const QKeySequence& key : keys.of(meaning)) {
        shown << key.toString(QKeySequence::NativeText);
    }
    return shown.join(QLatin1Char('/'));
}

/// "A/Left, D/Right: turn · W/Up: thrust · Space: tow"
QString flyingAdvice(const PlayKeys& keys) {
    QStringList turning{allKeys(keys, PlayKey::Left), allKeys(keys, PlayKey::Right)};
    turning.removeAll(QString());
    return keyAdvice({{turning.join(QStringLiteral(", ")), HudWords::tr("turn")},
                      {allKeys(keys, PlayKey::Thrust), HudWords::tr("thrust")},
                      {allKeys(keys, PlayKey::Tow), HudWords::tr("tow")}});
}

/// What a crash has cost, and why.
QString loss(const HudInput& input) {
    if (!input.cause.isEmpty()) {
        const bool isAll = input.shipLost && input.payloadLost;
        return isAll ? input.cause + QLatin1Char(' ') + HudWords::tr("Ship and payload are lost.") : input.cause;
    }
    if (input.shipLost) {
        return input.payloadLost ? HudWords::tr("Ship and payload are lost.") : HudWords::tr("The ship is lost.");
    }
    return input.payloadLost ? HudWords::tr("The payload is lost.") : QString();
}

Message messageOf(const HudInput& input) {
    if (input.paused) {
        return {}; // nothing covers what one paused to look at; see addPaused
    }
    switch (input.phase) {
    case Phase::AwaitingInput:
        return {HudWords::tr("Ready"),
                (input.goal.isEmpty() ? HudWords::tr("Take the payload in tow and carry it across the finish.")
                                      : input.goal) +
                    QLatin1Char('\n') + HudWords::tr("Press a direction to start")};
    case Phase::Crashed:
        return {HudWords::tr("Crashed"),
                (loss(input) + QLatin1Char('\n') + HudWords::tr("Press any key to try again")).trimmed()};
    case Phase::GameOver:
        return {HudWords::tr("Game over"), (loss(input) + QLatin1Char('\n') +
                                            HudWords::tr("No life is left. Press any key to start the level over"))
                                               .trimmed()};
    case Phase::Won:
        return {HudWords::tr("You made it!"),
                HudWords::tr("The payload is home.") + QLatin1Char(' ') +
                    keyAdvice({{input.keys.shown(PlayKey::Tow), HudWords::tr("fly again")}, escape()})};
    case Phase::Sandbox:
    case Phase::Flying:
    case Phase::Towing:
        break;
    }
    return {};
}

QSizeF extent(const QString& text, const QFont& font, double width) {
    const QRectF wide(0, 0, width, 1e6);
    const QSizeF size = QFontMetricsF(font).boundingRect(wide, Qt::AlignCenter | Qt::TextWordWrap, text).size();
    // Rounded up, so that the box that is painted into breaks the lines where the measured one did.
    return {std::ceil(size.width()) + 1, std::ceil(size.height())};
}

QFont sized(const QFont& base, double pixels, QFont::Weight weight) {
    QFont font = base;
    font.setPixelSize(static_cast<int>(std::max(smallest, std::round(pixels))));
    font.setWeight(weight);
    return font;
}

/// The largest font up to the one given in which the text fits.
QFont fitted(const QString& text, const QSizeF& room, QFont font) {
    while (font.pixelSize() > smallest) {
        const QSizeF needed = extent(text, font, room.width());
        if (needed.width() <= room.width() && needed.height() <= room.height()) {
            break;
        }
        font.setPixelSize(font.pixelSize() - 1);
    }
    return font;
}

QString minutes(double seconds) {
    const auto tenths = static_cast<long long>(std::floor(seconds * 10 + 1e-6));
    return QStringLiteral("%1:%2%3%4")
        .arg(tenths / 600)
        .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
        .arg(QLocale().decimalPoint())
        .arg(tenths % 10);
}

class Layout {
  public:
    Layout(const QSizeF& size, const QFont& base)
        : m_size(size), m_base(base), m_unit(std::min(size.width() / 13.333, size.height() / 10)) {}

    /// Three columns of equal width along the top.
    void addReadings(const Hud& hud) {
        const double margin = 0.25 * m_unit;
        const double height = 0.55 * m_unit;
        const double width = (m_size.width() - 4 * margin) / 3;
        const std::array<std::pair<HudText::Role, QString>, 3> readings{
            std::pair(HudText::Role::Lives, HudWords::tr("Lives %1").arg(hud.lives)),
            std::pair(HudText::Role::Time, HudWords::tr("Time %1").arg(minutes(hud.time))),
            std::pair(HudText::Role::Fuel, HudWords::tr("Fuel used %1 s").arg(QLocale().toString(hud.fuel, 'f', 2)))};
        double x = margin;
        for (const auto& [role, text] : readings) {
            const QSizeF room(width, height);
            const double pixels = std::clamp(0.34 * m_unit, 9.0, 26.0);
            const QFont font = fitted(text, room, sized(m_base, pixels, QFont::DemiBold));
            const QSizeF needed = extent(text, font, width);
            double left = x;
            if (role == HudText::Role::Time) {
                left += (width - needed.width()) / 2;
            } else if (role == HudText::Role::Fuel) {
                left += width - needed.width();
            }
            m_texts.push_back({role, text, QRectF(QPointF(left, margin), needed), font});
            x += width + margin;
        }
    }

    /// A band across the view.
    struct Band {
        double top, height; // as shares of it
    };

    /// Title and advice where they do not cover the ship: above the middle if they can.
    void addMessage(const Message& message, const QRectF& ship) {
        const double title = std::clamp(0.75 * m_unit, 12.0, 56.0);
        const double advice = std::clamp(0.36 * m_unit, 10.0, 28.0);
        const HudText above[] = {placed(HudText::Role::Title, message.title, {0.13, 0.13}, title),
                                 placed(HudText::Role::Advice, message.advice, {0.27, 0.12}, advice)};
        const bool covers = std::ranges::any_of(above, [&](const HudText& text) { return text.box.intersects(ship); });
        addCentred(HudText::Role::Title, message.title, {covers ? 0.44 : 0.13, covers ? 0.12 : 0.13}, title);
        addCentred(HudText::Role::Advice, message.advice, {covers ? 0.565 : 0.27, 0.12}, advice);
    }

    /// One text near the lower edge, or above it where the ship is there.
    void addBelow(HudText::Role role, const QString& text, const QRectF& ship) {
        const double pixels = std::clamp(0.4 * m_unit, 10.0, 30.0);
        const bool covers = placed(role, text, {0.84, 0.12}, pixels).box.intersects(ship);
        addCentred(role, text, {covers ? 0.55 : 0.84, 0.12}, pixels);
    }

    void addCentred(HudText::Role role, const QString& text, const Band& band, double pixels) {
        if (!text.isEmpty()) {
            m_texts.push_back(placed(role, text, band, pixels));
        }
    }

    /// One text centred in the band, at most `pixels` high.
    HudText placed(HudText::Role role, const QString& text, const Band& band, double pixels) const {
        const QSizeF room(0.92 * m_size.width(), band.height * m_size.height());
        const QFont font = fitted(text, room, sized(m_base, pixels, QFont::Bold));
        const QSizeF needed = extent(text, font, room.width());
        const QPointF corner((m_size.width() - needed.width()) / 2,
                             band.top * m_size.height() + (room.height() - needed.height()) / 2);
        return {role, text, QRectF(corner, needed), font};
    }

    /// One line along the lower edge.
    void addPaused(const PlayKeys& keys) {
        const QString advice = keyAdvice({{keys.shown(PlayKey::Pause), HudWords::tr("go on")},
                                          {keys.shown(PlayKey::Step), HudWords::tr("one step")},
                                          escape()});
        addCentred(HudText::Role::Paused, HudWords::tr("Paused") + QStringLiteral(" · ") + advice, {0.94, 0.05},
                   std::clamp(0.3 * m_unit, 9.0, 20.0));
    }

    double unit() const { return m_unit; }
    std::vector<HudText> take() { return std::move(m_texts); }

  private:
    QSizeF m_size;
    QFont m_base;
    double m_unit; // pixels a metre in the classic view
    std::vector<HudText> m_texts;
};

QColor colorOf(HudText::Role role) {
    switch (role) {
    case HudText::Role::Title:
        return {255, 255, 255};
    case HudText::Role::Banner:
        return {255, 190, 120};
    case HudText::Role::Hint:
        return {255, 226, 150};
    default:
        return {226, 232, 242};
    }
}

} // namespace

std::vector<HudText> hudLayout(const HudInput& input, const QSizeF& size, const QFont& base) {
    if (size.width() < 1 || size.height() < 1) {
        return {};
    }
    Layout layout(size, base);
    if (input.phase != Phase::Sandbox) {
        layout.addReadings(input.hud);
    }
    layout.addMessage(messageOf(input), input.ship);
    if (input.hud.gravityFlippedFor >= 0 && input.hud.gravityFlippedFor < bannerSeconds) {
        layout.addCentred(HudText::Role::Banner, HudWords::tr("Gravity is upside down!"), {0.70, 0.12},
                          std::clamp(0.5 * layout.unit(), 11.0, 38.0));
    }
    if (input.paused) {
        layout.addPaused(input.keys);
    } else if (input.phase == Phase::AwaitingInput) {
        layout.addBelow(HudText::Role::Keys, flyingAdvice(input.keys), input.ship);
    } else if (input.hud.towInRange) {
        const QString advice = keyAdvice({{input.keys.shown(PlayKey::Tow), HudWords::tr("tow")}});
        layout.addBelow(HudText::Role::Hint, HudWords::tr("In range.") + QLatin1Char(' ') + advice, input.ship);
    }
    return layout.take();
}

void paintHud(QPainter& painter, const std::vector<HudText>& texts) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const HudText& text : texts) {
        painter.setFont(text.font);
        // A dark copy all round keeps the words apart from whatever is behind them.
        const double reach = std::max(1.0, text.font.pixelSize() / 14.0);
        const int flags = Qt::AlignCenter | Qt::TextWordWrap;
        painter.setPen(QColor(6, 14, 26, 110));
        for (int i = 0; i < 16; ++i) {
            const double angle = i * 0.39269908169872414;
            const double far = reach * (i % 2 == 0 ? 1.0 : 1.8);
            painter.drawText(text.box.translated(far * std::cos(angle), far * std::sin(angle)), flags, text.text);
        }
        painter.setPen(colorOf(text.role));
        painter.drawText(text.box, flags, text.text);
    }
    painter.restore();
}

} // namespace spacetow
