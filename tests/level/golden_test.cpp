#include "core/level/file.h"

#include "core/level/describe.h"
#include "core/level/field_reader.h"
#include "core/level/fields.h"
#include "core/level/fixes.h"
#include "tests/support/folders.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString folder() {
    return sourceFolder() + "/tests/golden";
}

/// "LINE: severity: code: arguments (pointer)" for each problem.
std::string problemLines(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        text += std::to_string(problem.line) +
                (problem.severity == Severity::Error     ? ": error: "
                 : problem.severity == Severity::Warning ? ": warning: "
                                                         : ": note: ") +
                std::string(problem.code.text()) + ':';
        for (const std::string& argument : problem.arguments) {
            text += ' ' + argument;
        }
        text += " (" + problem.pointer + ")\n";
    }
    return text;
}

/// What documentation has to say about a field.
struct Described {
    std::string owner; // "body", "circle", "rules", "level"…
    std::string name;
    double min = 0, max = 0;
    bool hasRange = false, openMin = false, required = false;
    std::string meaning;
};

/// The visitor of core/level/fields.h that lists the fields.
class FieldLister {
  public:
    FieldLister(std::vector<Described>& out, std::string owner) : m_out(out), m_owner(std::move(owner)) {}

    void number(const Field& f, double, double) { add(f, true); }
    void integer(const Field& f, int, int) { add(f, true); }
    void optionalNumber(const Field& f, const std::optional<double>&) { add(f, true); }
    void depth(const Field& f, double, double) { add(f, true); }
    void point(const Field& f, const Vec2&, const Vec2&) { add(f, true); }
    void points(const Field& f, const std::vector<Vec2>&) { add(f, true); }
    void flag(const Field& f, bool, bool) { add(f, false); }
    void text(const Field& f, const std::string&, const std::string&) { add(f, false); }
    void tags(const Field& f, TagMask, TagMask) { add(f, false); }
    void touches(const Field& f, TagMask) { add(f, false); }
    void key(const Field& f, Key) { add(f, false); }
    void optionalKey(const Field& f, Key) { add(f, false); }
    void optionalColor(const Field& f, const std::optional<std::uint32_t>&) { add(f, false); }
    void shapes(const Field& f, const std::vector<LevelShape>&) { add(f, false); }
    template <class Enum, std::size_t n>
    void choice(const Field& f, Enum, Enum, const Spellings<n>&) {
        add(f, false);
    }

  private:
    void add(const Field& field, bool hasRange) {
        m_out.push_back({m_owner, field.name, field.min, field.max, hasRange, field.openMin,
                         field.presence == Presence::Required, field.meaning});
    }

    std::vector<Described>& m_out;
    std::string m_owner;
};

template <class T>
void list(std::vector<Described>& out, const char* owner) {
    FieldLister lister(out, owner);
    visitFields(lister, static_cast<const T&>(T()));
}

std::vector<Described> allFields() {
    std::vector<Described> out;
    list<Level>(out, "level");
    list<Rules>(out, "rules");
    list<RopeRules>(out, "rope");
    list<BodyObject>(out, "body");
    list<ShipObject>(out, "ship");
    list<PayloadObject>(out, "payload");
    list<FinishObject>(out, "finish");
    list<ConnectorObject>(out, "connector");
    list<GroupObject>(out, "group");
    list<Object>(out, "object");
    list<Guide>(out, "guide");
    list<HiddenProblem>(out, "hidden-problem");
    list<EdgeChain>(out, "edges");
    list<LineChain>(out, "lines");
    list<Polygon>(out, "polygon");
    list<Circle>(out, "circle");
    return out;
}

/// The definition in the schema of what is called `owner` here.
QJsonObject definitionOf(const QJsonObject& schema, const std::string& owner) {
    if (owner == "level") {
        return schema;
    }
    if (owner == "rules") {
        return schema["properties"]["rules"].toObject();
    }
    if (owner == "rope") {
        return schema["properties"]["rules"]["properties"]["rope"].toObject();
    }
    if (owner == "guide") {
        return schema["properties"]["guides"]["items"].toObject();
    }
    if (owner == "hidden-problem") {
        return schema["properties"]["hiddenProblems"]["items"].toObject();
    }
    // What every object has stands in each of their definitions.
    return schema["$defs"][QString::fromStdString(owner == "object" ? "group" : owner)].toObject();
}

/// The part of the schema in which a field's limits stand.
QJsonObject limitsIn(QJsonObject field) {
    while (field["type"] == "array") {
        const QJsonArray items = field["prefixItems"].toArray();
        field = items.isEmpty() ? field["items"].toObject() : items[0].toObject();
    }
    return field;
}

QJsonObject schemaDocument() {
    return QJsonDocument::fromJson(contents(sourceFolder() + "/resources/level.schema.json")).object();
}

/// Every field name in a piece of JSON.
void collectNames(const QJsonValue& value, std::set<QString>& names) {
    if (value.isArray()) {
        for (const QJsonValue& item : value.toArray()) {
            collectNames(item, names);
        }
    }
    const QJsonObject object = value.toObject();
    for (auto i = object.begin(); i != object.end(); ++i) {
        names.insert(i.key());
        collectNames(i.value(), names);
    }
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

  private slots:
    void aFileIsReadAndWrittenAsLaidDown_data() {
        QTest::addColumn<QString>("path");
        for (const QString& name : QDir(folder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            if (name == "import") {
                continue; // files of other programs: tests/exchange
            }
            QTest::newRow(qPrintable(name)) << folder() + '/' + name;
        }
    }
    void aFileIsReadAndWrittenAsLaidDown() {
        QFETCH(QString, path);
        const LevelFile file = parseLevel(contents(path + "/in.json").toStdString());
        // A folder holds what is written, or what is wrong, or both.
        const bool hasOut = QFile::exists(path + "/out.json");
        const bool hasError = QFile::exists(path + "/error.txt");
        QVERIFY(hasOut || hasError);
        QCOMPARE(QByteArray::fromStdString(problemLines(file.problems)), contents(path + "/error.txt"));
        QCOMPARE(file.level.has_value(), hasOut);
        if (hasOut) {
            QCOMPARE(QByteArray::fromStdString(levelText(*file.level)), contents(path + "/out.json"));
            QCOMPARE(
                QByteArray::fromStdString(levelText(*parseLevel(contents(path + "/out.json").toStdString()).level)),
                contents(path + "/out.json"));
        }
    }

    void whatCanBeCuredSafelyIsCuredAsLaidDown_data() { aFileIsReadAndWrittenAsLaidDown_data(); }
    void whatCanBeCuredSafelyIsCuredAsLaidDown() {
        QFETCH(QString, path);
        const LevelFile file = parseLevel(contents(path + "/in.json").toStdString());
        if (file.level && QFileInfo(path).fileName().startsWith("lint_")) {
            const FixedLevel cured = withSafeFixes(*file.level);
            QCOMPARE(QFile::exists(path + "/fixed.json"), !cured.cured.empty());
            if (!cured.cured.empty()) {
                QCOMPARE(QByteArray::fromStdString(levelText(cured.level)), contents(path + "/fixed.json"));
            }
        }
    }

    void everyFieldWithItsRangeIsInTheSchema_data() {
        QTest::addColumn<int>("index");
        const std::vector<Described> fields = allFields();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            QTest::newRow((fields[i].owner + '.' + fields[i].name).c_str()) << static_cast<int>(i);
        }
    }
    void everyFieldWithItsRangeIsInTheSchema() {
        QFETCH(int, index);
        const Described field = allFields()[static_cast<std::size_t>(index)];
        const QJsonObject definition = definitionOf(schemaDocument(), field.owner);
        const QString name = QString::fromStdString(field.name);
        QVERIFY2(definition["properties"].toObject().contains(name), "is not in the schema");
        QCOMPARE(definition["required"].toArray().contains(name), field.required);
        if (field.hasRange) {
            const QJsonObject limits = limitsIn(definition["properties"][name].toObject());
            QCOMPARE(limits["maximum"].toDouble(-1), field.max);
            QCOMPARE(limits[field.openMin ? "exclusiveMinimum" : "minimum"].toDouble(-1), field.min);
        }
    }

    void theSchemaHasNoFieldThatTheCodeDoesNotKnow() {
        std::set<std::pair<std::string, QString>> known;
        for (const Described& field : allFields()) {
            known.emplace(field.owner, QString::fromStdString(field.name));
        }
        const QJsonObject schema = schemaDocument();
        std::vector<std::string> owners{"rules", "rope"};
        for (const QString& owner : schema["$defs"].toObject().keys()) {
            owners.push_back(owner.toStdString());
        }
        for (const std::string& owner : owners) {
            for (const QString& name : definitionOf(schema, owner)["properties"].toObject().keys()) {
                const bool structural = name == "key" || name == "type" || known.contains({"object", name}) ||
                                        (owner == "rules" && name == "rope");
                QVERIFY2(structural || known.contains({owner, name}), qPrintable(name));
            }
        }
    }

    void theSchemaIsTheOneThatLevelcPrints() {
        QCOMPARE(contents(sourceFolder() + "/resources/level.schema.json"),
                 QByteArray::fromStdString(levelSchemaText()));
    }

    void theReadmeHoldsTheTablesThatLevelcPrints() {
        const QString readme = contents(sourceFolder() + "/levels/README.md");
        QVERIFY(describedParts().size() >= 15);
        for (const std::string_view part : describedParts()) {
            QVERIFY2(readme.contains(QString::fromStdString(fieldTable(part)) + '\n'), std::string(part).c_str());
        }
    }

    void everyFieldIsExplained() {
        for (const Described& field : allFields()) {
            QVERIFY2(!field.meaning.empty(), (field.owner + '.' + field.name).c_str());
        }
    }

    void everyFieldOfAFullLevelIsInBothDocuments() {
        std::set<QString> names;
        collectNames(QJsonDocument::fromJson(QByteArray::fromStdString(levelText(populatedLevel()))).object(), names);
        QVERIFY(names.size() > 45);
        const QString schema = contents(sourceFolder() + "/resources/level.schema.json");
        const QString readme = contents(sourceFolder() + "/levels/README.md");
        for (const QString& name : names) {
            QVERIFY2(schema.contains('"' + name + "\":"), qPrintable(name));
            QVERIFY2(readme.contains('`' + name + '`'), qPrintable(name));
        }
    }

    void theReadmeGivesEveryRange() {
        const QString readme = contents(sourceFolder() + "/levels/README.md");
        for (const Described& field : allFields()) {
            if (!field.hasRange) {
                continue;
            }
            const QString name = QString::fromStdString(field.name);
            const QString limit = QString::number(field.max, 'g', 12);
            const QRegularExpression row("\\| `" + name + "` \\|[^\n]*[ ≤]" + QRegularExpression::escape(limit) +
                                         "\\b");
            QVERIFY2(readme.contains(row), qPrintable(name + " up to " + limit));
        }
    }

    void theReadmeAndTheSchemaNameEverySpelling() {
        const QString schema = contents(sourceFolder() + "/resources/level.schema.json");
        const QString readme = contents(sourceFolder() + "/levels/README.md");
        std::vector<std::string_view> names(objectTypeNames.begin(), objectTypeNames.end());
        names.insert(names.end(), shapeTypeNames.begin(), shapeTypeNames.end());
        names.insert(names.end(), bodyKindNames.begin(), bodyKindNames.end());
        names.insert(names.end(), truncationNames.begin(), truncationNames.end());
        for (const std::string_view name : names) {
            const QString spelling = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
            QVERIFY2(schema.contains('"' + spelling + '"'), qPrintable(spelling));
            QVERIFY2(readme.contains('`' + spelling + '`') || readme.contains('"' + spelling + '"'),
                     qPrintable(spelling));
        }
    }

    void theLevelsThatAreShippedAreCanonicalAndSound() {
        const QString root = sourceFolder() + "/levels";
        for (const QString& place : {root, root + "/sandbox"}) {
            for (const QString& name : QDir(place).entryList({"*.json"})) {
                const std::string text = contents(place + '/' + name).toStdString();
                const LevelFile file = parseLevel(text);
                QVERIFY2(file.problems.empty(), (name.toStdString() + '\n' + problemLines(file.problems)).c_str());
                QVERIFY2(levelText(*file.level) == text, qPrintable(name));
            }
        }
    }
};

SPACETOW_TEST(GoldenTest)
#include "golden_test.moc"
