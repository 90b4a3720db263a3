#include "editor/panels/explain_rows.h"

#include "core/physics/query/explain.h"
#include "editor/canvas/figure_text.h"
#include "editor/canvas/tag_text.h"
#include "editor/panels/explain_codes.h"
#include "editor/panels/names.h"

#include <QCoreApplication>
#include <QLocale>

#include <bit>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Explain", text);
}

QString withUnit(double number, const char* unit) {
    return figureText(number) + QChar(0x00a0) + QString::fromUtf8(unit);
}

QString turnText(double torque) {
    const QString way = std::abs(torque) < 1e-9 ? QString() : torque > 0 ? QStringLiteral(" ↺") : QStringLiteral(" ↻");
    return withUnit(std::abs(torque), "N m") + way;
}

QString forceText(const ForceReading& force) {
    const QString linear = vectorText(force.force, QStringLiteral("N"));
    return std::abs(force.torque) < 1e-9 ? linear : linear + QStringLiteral(", ") + turnText(force.torque);
}

/// What is called in the level, or what it is in the game alone.
QString bodyName(const Session& session, BodyId body) {
    const Object* object = session.level().objects.find(session.keyOf(body));
    return object != nullptr ? displayName(*object) : words(QT_TRANSLATE_NOOP("Explain", "Debris"));
}

/// Without what the mouse pulls, which has a row of its own.
ForceReading appliedWithoutGrab(const Session& session, BodyId body, const ForceReading& applied) {
    const std::optional<GrabForce>& grab = session.grabForce();
    if (!grab || grab->body != body) {
        return applied;
    }
    const Vec2 arm = grab->anchor - session.world().body(body).massCenter;
    return {applied.force - grab->force, applied.torque - cross(arm, grab->force)};
}

ExplainSection forceSection(const Session& session, BodyId body, const BodyForces& forces) {
    ExplainSection section{words(QT_TRANSLATE_NOOP("Explain", "Forces")), {}};
    const auto add = [&section](const char* what, const ForceReading& force) {
        section.rows.push_back({words(what), forceText(force)});
    };
    add(QT_TRANSLATE_NOOP("Explain", "Gravity"), forces.gravity);
    add(QT_TRANSLATE_NOOP("Explain", "Thrust and steering"), appliedWithoutGrab(session, body, forces.applied));
    if (const std::optional<GrabForce>& grab = session.grabForce(); grab && grab->body == body) {
        add(QT_TRANSLATE_NOOP("Explain", "Pulled by the mouse"), {grab->force, 0});
    }
    add(QT_TRANSLATE_NOOP("Explain", "Connectors"), forces.connectors);
    add(QT_TRANSLATE_NOOP("Explain", "Contacts"), forces.contacts);
    add(QT_TRANSLATE_NOOP("Explain", "Damping"), forces.damping);
    add(QT_TRANSLATE_NOOP("Explain", "Total"), forces.sum());
    return section;
}

ExplainSection contactSection(const Session& session, BodyId body) {
    ExplainSection section{words(QT_TRANSLATE_NOOP("Explain", "Contacts")), {}};
    const double seconds = session.world().parameters().seconds;
    for (const ContactReading& contact : contactsOf(session.world(), body)) {
        const bool first = contact.a == body;
        const BodyId other = first ? contact.b : contact.a;
        const QString name = bodyName(session, other);
        const Key key = session.keyOf(other);
        if (!contact.solid) {
            section.rows.push_back({name, words(QT_TRANSLATE_NOOP("Explain", "felt, without a force")), key});
            continue;
        }
        const Vec2 force = (first ? -1 : 1) / seconds * contact.impulse;
        const QString text = words(QT_TRANSLATE_NOOP("Explain", "%1, of which friction %2"));
        section.rows.push_back(
            {name,
             text.arg(vectorText(force, QStringLiteral("N")), withUnit(std::abs(contact.friction) / seconds, "N")),
             key});
    }
    if (section.rows.empty()) {
        section.rows.push_back({words(QT_TRANSLATE_NOOP("Explain", "None")), {}});
    }
    return section;
}

ExplainSection tagSection(const Level& level, TagMask tags) {
    ExplainSection section{words(QT_TRANSLATE_NOOP("Explain", "Tags touched")), {}};
    QStringList names;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        if (tags.contains(tag)) {
            names << tagText(level.tags, tag);
        }
    }
    section.rows.push_back(
        {names.isEmpty() ? words(QT_TRANSLATE_NOOP("Explain", "None")) : names.join(QStringLiteral(", ")), {}});
    return section;
}

ExplainSection motionSection(const BodyState& state, const BodyReading& reading) {
    ExplainSection section{words(QT_TRANSLATE_NOOP("Explain", "Motion")), {}};
    const auto add = [&section](const char* what, const QString& value) {
        section.rows.push_back({words(what), value});
    };
    add(QT_TRANSLATE_NOOP("Explain", "Speed"), vectorText(state.velocity, QStringLiteral("m/s")));
    add(QT_TRANSLATE_NOOP("Explain", "Turns"), withUnit(state.angularVelocity * 180 / std::numbers::pi, "°/s"));
    if (state.kind == BodyKind::Dynamic) {
        add(QT_TRANSLATE_NOOP("Explain", "Kinetic energy"), withUnit(reading.energy.kinetic, "J"));
        add(QT_TRANSLATE_NOOP("Explain", "Potential energy"), withUnit(reading.energy.potential, "J"));
        add(QT_TRANSLATE_NOOP("Explain", "Momentum"), vectorText(reading.momentum, QStringLiteral("kg m/s")));
        add(QT_TRANSLATE_NOOP("Explain", "Spin"), withUnit(reading.spin, "kg m²/s"));
        add(QT_TRANSLATE_NOOP("Explain", "Angular momentum"), withUnit(reading.angularMomentum, "kg m²/s"));
    }
    if (state.asleep) {
        add(QT_TRANSLATE_NOOP("Explain", "Sleeps"), {});
    }
    return section;
}

std::vector<ExplainSection> bodySections(const Session& session, BodyId body) {
    const BodyReading reading = explained(session.world(), body);
    const BodyState state = session.world().body(body);
    std::vector<ExplainSection> sections;
    if (state.kind == BodyKind::Dynamic) {
        sections.push_back(forceSection(session, body, reading.forces));
    }
    sections.push_back(contactSection(session, body));
    sections.push_back(tagSection(session.level(), reading.touchedTags));
    if (state.kind != BodyKind::Static) {
        sections.push_back(motionSection(state, reading));
    }
    return sections;
}

std::vector<ExplainSection> connectorSections(const Session& session, ConnectorId connector) {
    const ConnectorReading reading = explained(session.world(), connector);
    const ConnectorState state = session.world().connector(connector);
    ExplainSection pull{words(QT_TRANSLATE_NOOP("Explain", "Pull")), {}};
    const auto add = [&pull](const char* what, const QString& value) { pull.rows.push_back({words(what), value}); };
    add(QT_TRANSLATE_NOOP("Explain", "Distance of its ends"), withUnit(reading.distance, "m"));
    add(QT_TRANSLATE_NOOP("Explain", "Natural length"), withUnit(reading.length, "m"));
    add(reading.tension < 0 ? QT_TRANSLATE_NOOP("Explain", "Pushes with") : QT_TRANSLATE_NOOP("Explain", "Pulls with"),
        withUnit(std::abs(reading.tension), "N"));
    add(QT_TRANSLATE_NOOP("Explain", "Elastic energy"), withUnit(reading.energy, "J"));
    ExplainSection ends{words(QT_TRANSLATE_NOOP("Explain", "Between")), {}};
    for (const BodyId body : {state.a, state.b}) {
        ends.rows.push_back({bodyName(session, body), {}, session.keyOf(body)});
    }
    return {pull, ends};
}

std::vector<ExplainSection> worldSections(const Session& session) {
    const WorldReading sum = totals(session.world());
    ExplainSection energy{words(QT_TRANSLATE_NOOP("Explain", "All bodies")), {}};
    const auto add = [&energy](const char* what, const QString& value) { energy.rows.push_back({words(what), value}); };
    add(QT_TRANSLATE_NOOP("Explain", "Kinetic energy"), withUnit(sum.kinetic, "J"));
    add(QT_TRANSLATE_NOOP("Explain", "Potential energy"), withUnit(sum.potential, "J"));
    add(QT_TRANSLATE_NOOP("Explain", "Elastic energy"), withUnit(sum.elastic, "J"));
    add(QT_TRANSLATE_NOOP("Explain", "Total energy"), withUnit(sum.energy(), "J"));
    add(QT_TRANSLATE_NOOP("Explain", "Momentum"), vectorText(sum.momentum, QStringLiteral("kg m/s")));
    add(QT_TRANSLATE_NOOP("Explain", "Angular momentum"), withUnit(sum.angularMomentum, "kg m²/s"));
    return {energy};
}

std::string nameIn(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object == nullptr ? std::string() : listedName(level, *object).toStdString();
}

std::string tagsIn(const Level& level, TagMask tags) {
    QStringList names;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        if (tags.contains(tag)) {
            names << tagText(level.tags, tag);
        }
    }
    return names.join(QStringLiteral(", ")).toStdString();
}

ExplainCode codeFor(const CollisionAnswer& answer) {
    switch (answer.why) {
    case WhyApart::Touch:
        return "apart-touch";
    case WhyApart::SameBody:
        return "apart-same-body";
    case WhyApart::Inactive:
        return "apart-inactive";
    case WhyApart::Unmovable:
        return "apart-unmovable";
    case WhyApart::Mask:
        return answer.missing.bits == 0 ? ExplainCode("apart-no-tags")
               : answer.bothMasks       ? ExplainCode("apart-both-masks")
                                        : "apart-mask";
    case WhyApart::Connected:
        return "apart-connected";
    case WhyApart::Intangible:
        return answer.sensed ? ExplainCode("apart-felt") : "apart-intangible";
    case WhyApart::Walls:
        return "apart-walls";
    case WhyApart::Passing:
        return "apart-passing";
    case WhyApart::Behind:
        return "apart-behind";
    case WhyApart::Distance:
        return "apart-distance";
    case WhyApart::NextUpdate:
        break;
    }
    return "apart-next-update";
}

std::string metersText(double meters) {
    return QLocale().toString(meters, 'g', 4).toStdString();
}

} // namespace

QString vectorText(const Vec2& v, const QString& unit) {
    static const QString arrows = QStringLiteral("→↗↑↖←↙↓↘");
    const double length = v.norm();
    const QString text = figureText(length) + QChar(0x00a0) + unit;
    if (!(length >= 1e-9) || !std::isfinite(length)) {
        return text;
    }
    const int eighth = static_cast<int>(std::lround(std::atan2(v.y(), v.x()) * 4 / std::numbers::pi));
    return text + QLatin1Char(' ') + arrows[(eighth + 8) % 8];
}

std::vector<ExplainSection> explainSections(const Session& session, Key object) {
    if (object == 0) {
        return worldSections(session);
    }
    if (const std::optional<BodyId> body = session.bodyOf(object)) {
        return bodySections(session, *body);
    }
    if (const std::optional<ConnectorId> connector = session.connectorOf(object)) {
        return connectorSections(session, *connector);
    }
    return {};
}

std::optional<ApartObjects> apartObjects(const Session& session, Key a, Key b) {
    const std::optional<BodyId> first = session.bodyOf(a);
    const std::optional<BodyId> second = session.bodyOf(b);
    if (!first || !second) {
        return std::nullopt;
    }
    ApartObjects apart{a, b, false, 0, whyNotColliding(session.world(), *first, *second)};
    apart.isAboutB = apart.answer.body == *second;
    for (const ConnectorId connector : apart.answer.connectors) {
        apart.connector = apart.connector != 0 ? apart.connector : session.keyOf(connector);
    }
    return apart;
}

Error apartCode(const Level& level, const ApartObjects& apart) {
    const Key about = apart.isAboutB ? apart.b : apart.a;
    const Key other = apart.isAboutB ? apart.a : apart.b;
    const CollisionAnswer& answer = apart.answer;
    const std::string connector = nameIn(level, apart.connector);
    switch (answer.why) {
    case WhyApart::Connected:
        return {connector.empty() ? ExplainCode("apart-rope") : codeFor(answer),
                {nameIn(level, about), nameIn(level, other), connector}};
    case WhyApart::Distance:
        return {codeFor(answer), {nameIn(level, about), nameIn(level, other), metersText(answer.distance)}};
    case WhyApart::Passing:
    case WhyApart::Behind:
        return {codeFor(answer),
                {nameIn(level, about), nameIn(level, other), metersText(answer.from.x()), metersText(answer.from.y()),
                 metersText(answer.to.x()), metersText(answer.to.y())}};
    default:
        return {codeFor(answer), {nameIn(level, about), nameIn(level, other), tagsIn(level, answer.missing)}};
    }
}

Error cureCode(const Level& level, const CollisionCure& cure) {
    static constexpr ExplainCode codes[] = {"cure-tick-tag", "cure-give-tag", "cure-make-solid", "cure-let-collide"};
    return {codes[static_cast<std::size_t>(cure.kind)],
            {nameIn(level, cure.object), tagText(level.tags, cure.tag).toStdString()}};
}

} // namespace spacetow
