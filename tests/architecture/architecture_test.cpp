// Holds the sources against ARCHITECTURE.md: who may include whom, and what no file may contain.

#include "tests/architecture/cycle_rules.h"
#include "tests/architecture/name_rules.h"
#include "tests/architecture/source_rules.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace spacetow::test;

namespace {

const fs::path root = sourceFolder().toStdString();

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<Source> sourcesUnder(std::initializer_list<const char*> folders) {
    std::vector<Source> sources;
    for (const char* folder : folders) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path extension = entry.path().extension();
            if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp")) {
                sources.push_back({entry.path().lexically_relative(root).generic_string(), contentOf(entry.path())});
            }
        }
    }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

std::string joined(const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : problems) {
        text += "\n  " + problem;
    }
    return text;
}

void expectNone(const std::vector<std::string>& problems) {
    QVERIFY2(problems.empty(), ("see ARCHITECTURE.md:" + joined(problems)).c_str());
}

void append(std::vector<std::string>& all, std::vector<std::string> more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

class ArchitectureTest : public QObject {
    Q_OBJECT

  private slots:
    void theTableNamesEveryFolderOfSources();
    void everyIncludePointsDown();
    void everyFileKeepsItsForm();
    void noStageTakesAWholeWorld();
    void unitsOfTheEngineFormNoCycle();
    void unnamedNamesOfAFolderDiffer();
    void theRootHoldsOnlyWhatIsExpected();
    void aToolIsRegisteredOnceInALayer();

    void aForbiddenIncludeIsFound_data();
    void aForbiddenIncludeIsFound();
    void anAllowedIncludePasses_data();
    void anAllowedIncludePasses();
    void namesThatMeetAreFound_data();
    void namesThatMeetAreFound();
    void aFileOfBadFormIsFound_data();
    void aFileOfBadFormIsFound();

  private:
    Layers m_layers = layersIn(contentOf(root / "ARCHITECTURE.md"));
};

void ArchitectureTest::theTableNamesEveryFolderOfSources() {
    std::set<std::string> named;
    for (const auto& [folder, row] : m_layers) {
        named.insert(folder);
    }
    std::set<std::string> existing;
    for (const Source& source : sourcesUnder({"core", "editor", "app"})) {
        existing.insert(folderOf(source.path));
    }
    std::vector<std::string> differing;
    std::set_symmetric_difference(named.begin(), named.end(), existing.begin(), existing.end(),
                                  std::back_inserter(differing));
    QVERIFY2(
        differing.empty(),
        ("these are in the layer table of ARCHITECTURE.md or in the tree, not in both:" + joined(differing)).c_str());
}

void ArchitectureTest::everyIncludePointsDown() {
    const std::vector<Source> sources = sourcesUnder({"core", "editor", "app"});
    QVERIFY(sources.size() > 50);
    std::vector<std::string> problems;
    for (const Source& source : sources) {
        append(problems, includeProblems(source, m_layers));
    }
    expectNone(problems);
}

void ArchitectureTest::everyFileKeepsItsForm() {
    std::vector<std::string> problems;
    for (const Source& source : sourcesUnder({"core", "editor", "app", "tests"})) {
        append(problems, formProblems(source));
    }
    expectNone(problems);
}

void ArchitectureTest::noStageTakesAWholeWorld() {
    const std::string function = "\nvoid solve(WorldData& data);\n";
    QCOMPARE(wholeWorldProblems({"core/physics/solver/solve.h", function}).size(), std::size_t{1});
    QVERIFY(wholeWorldProblems({"core/physics/step/update.h", function}).empty());
    QVERIFY(wholeWorldProblems({"core/physics/solver/solve.h", "    SolverStage(WorldData& data)"}).empty());
    std::vector<std::string> problems;
    for (const Source& source : sourcesUnder({"core"})) {
        append(problems, wholeWorldProblems(source));
    }
    expectNone(problems);
}

void ArchitectureTest::unitsOfTheEngineFormNoCycle() {
    const Source header{"core/physics/query/a.h", "#include \"core/physics/query/b.h\"\n"};
    const Source source{"core/physics/query/b.cpp", "#include \"core/physics/query/c.h\"\n"};
    QVERIFY(unitCycles({header, source, {"core/physics/query/b.h", ""}, {"core/physics/query/c.h", ""}}).empty());
    const std::vector<std::string> found =
        unitCycles({header,
                    source,
                    {"core/physics/query/b.h", ""},
                    {"core/physics/query/c.cpp", "#include \"core/physics/query/a.h\""}});
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found.front(), std::string("core/physics/query/a includes core/physics/query/b includes "
                                        "core/physics/query/c includes core/physics/query/a"));
    const std::vector<Source> engine = sourcesUnder({"core/physics"});
    QVERIFY(engine.size() > 50);
    expectNone(unitCycles(engine));
}

void ArchitectureTest::unnamedNamesOfAFolderDiffer() {
    const std::vector<Source> sources = sourcesUnder({"core", "editor", "app", "tests"});
    std::size_t names = 0;
    for (const Source& source : sources) {
        names += localNamesIn(source.text).size();
    }
    QVERIFY(names > 500);
    std::vector<Source> grouped;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(grouped),
                 [](const Source& source) { return folderOf(source.path) != "tests/bench"; });
    expectNone(nameProblems(grouped));
}

void ArchitectureTest::theRootHoldsOnlyWhatIsExpected() {
    static const std::set<std::string> expected{
        ".ci",         ".clang-format", ".clang-tidy",     ".gitignore",   ".github",        "app",
        "core",        "editor",        "levels",          "resources",    "tests",          "dev",
        "LICENSE",     "README.md",     "ARCHITECTURE.md", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json",
        "translations"};
    // Not part of the repository: see .gitignore.
    static const std::set<std::string> ignored{".git", ".cache", "build"};
    std::vector<std::string> problems;
    for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!expected.contains(name) && !ignored.contains(name) && !name.ends_with(".user")) {
            problems.push_back(name + " does not belong at the top of the tree");
        }
    }
    expectNone(problems);
}

/// A row in editor/editing/tools.cpp, and one among the actions: nobody else needs to hear of a tool.
void ArchitectureTest::aToolIsRegisteredOnceInALayer() {
    // What the editor comes back to, what shows nodes, and what has numbers to copy.
    static const std::set<std::string> special{"Select", "Nodes", "Measure"};
    const std::string table = contentOf(root / "editor/editing/tools.h");
    const std::size_t start = table.find('{', table.find("enum class ToolId"));
    std::istringstream names(table.substr(start + 1, table.find('}', start) - start - 1));
    int tools = 0;
    std::vector<std::string> problems;
    for (std::string name; std::getline(names >> std::ws, name, ',');) {
        ++tools;
        std::map<std::string, int> mentions;
        for (const Source& source : sourcesUnder({"editor", "app"})) {
            const std::string whole = "ToolId::" + name;
            for (auto at = source.text.find(whole); at != std::string::npos; at = source.text.find(whole, at + 1)) {
                const char after = source.text[at + whole.size()];
                // Of those that share a key, and of the keys of other programs.
                const bool isList =
                    source.path == "editor/editing/tools.h" || source.path == "editor/window/key_presets.cpp";
                mentions[folderOf(source.path)] += std::isalnum(after) == 0 && !isList ? 1 : 0;
            }
        }
        for (const auto& [folder, count] : mentions) {
            if (count > 1 && !special.contains(name)) {
                problems.push_back(folder + " names the tool " + name + " in " + std::to_string(count) + " places");
            }
        }
    }
    QVERIFY(tools >= 14);
    expectNone(problems);
}

void ArchitectureTest::aForbiddenIncludeIsFound_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("line");

    QTest::newRow("up to the editor") << "core/level/a.cpp"
                                      << "#include \"editor/editing/tool.h\"";
    QTest::newRow("up within the core") << "core/physics/query/a.h"
                                        << "#include \"core/level/level.h\"";
    QTest::newRow("geometry knows no time") << "core/geometry/a.cpp"
                                            << "#include \"core/physics/def/body.h\"";
    QTest::newRow("arrays know no world") << "core/physics/state/a.h"
                                          << "#include \"core/physics/world/world.h\"";
    QTest::newRow("the broad phase knows no contacts") << "core/physics/broad_phase/a.cpp"
                                                       << "#include \"core/physics/contacts/constraint_list.h\"";
    QTest::newRow("the broad phase wakes nobody") << "core/physics/broad_phase/a.cpp"
                                                  << "#include \"core/physics/sleep/sleep.h\"";
    QTest::newRow("lanes know no arrays") << "core/physics/lanes/a.h"
                                          << "#include \"core/physics/state/contact_data.h\"";
    QTest::newRow("no file outside of the engine's rooms") << "core/physics/a.cpp"
                                                           << "#include \"core/math/vec.h\"";
    QTest::newRow("panels beside play") << "editor/panels/a.cpp"
                                        << "#include \"editor/play/hud.h\"";
    QTest::newRow("play beside panels") << "editor/play/a.cpp"
                                        << "#include \"editor/panels/field.h\"";
    QTest::newRow("exchange beside editing") << "editor/exchange/a.cpp"
                                             << "#include \"editor/editing/document.h\"";
    QTest::newRow("canvas below panels") << "editor/canvas/a.h"
                                         << "#include \"editor/panels/field.h\"";
    QTest::newRow("canvas below play") << "editor/canvas/a.h"
                                       << "#include \"editor/play/hud.h\"";
    QTest::newRow("messages are above panels") << "editor/panels/a.cpp"
                                               << "#include \"editor/window/messages.h\"";
    QTest::newRow("the tests") << "core/base/a.cpp"
                               << "#include \"tests/support/drive.h\"";
    QTest::newRow("beside the file") << "core/base/a.cpp"
                                     << "#include \"contract.h\"";
    QTest::newRow("spaces") << "core/base/a.cpp"
                            << "  #  include   \"core/math/vec.h\"";
    QTest::newRow("unknown folder") << "core/extra/a.cpp"
                                    << "#include \"core/base/hash.h\"";
    QTest::newRow("Qt in the core") << "core/game/a.cpp"
                                    << "#include <QString>";
    QTest::newRow("Qt module in the core") << "core/game/a.cpp"
                                           << "#include <QtCore/qglobal.h>";
    QTest::newRow("Qt in the tools") << "editor/editing/a.h"
                                     << "#include <QPointF>";
    QTest::newRow("Eigen elsewhere") << "core/physics/solver/a.cpp"
                                     << "#include <Eigen/Dense>";
    QTest::newRow("json in a header") << "core/level/a.h"
                                      << "#include <nlohmann/json.hpp>";
    QTest::newRow("all widgets in a header") << "editor/panels/a.h"
                                             << "#include <QtWidgets>";
}

void ArchitectureTest::aForbiddenIncludeIsFound() {
    QFETCH(QString, path);
    QFETCH(QString, line);
    const Source source{path.toStdString(), "#pragma once\n// What it is for.\n" + line.toStdString() + "\n"};
    const std::vector<std::string> problems = includeProblems(source, m_layers);
    QCOMPARE(problems.size(), std::size_t{1});
    QVERIFY2(problems.front().starts_with(source.path + ":3: "), problems.front().c_str());
}

void ArchitectureTest::anAllowedIncludePasses_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("line");

    QTest::newRow("own folder") << "editor/play/a.cpp"
                                << "#include \"editor/play/hud.h\"";
    QTest::newRow("play above canvas") << "editor/play/a.cpp"
                                       << "#include \"editor/canvas/theme.h\"";
    QTest::newRow("panels above canvas") << "editor/panels/a.cpp"
                                         << "#include \"editor/canvas/theme.h\"";
    QTest::newRow("down within the engine") << "core/physics/solver/a.cpp"
                                            << "#include \"core/physics/contacts/contact_rules.h\"";
    QTest::newRow("skipping rows") << "app/a.cpp"
                                   << "#include \"core/base/hash.h\"";
    QTest::newRow("json in a source") << "core/level/a.cpp"
                                      << "#include <nlohmann/json.hpp>";
    QTest::newRow("Eigen in its place") << "core/math/vec.h"
                                        << "#include <Eigen/Core>";
    QTest::newRow("Qt in a panel") << "editor/panels/a.h"
                                   << "#include <QWidget>";
    QTest::newRow("generated") << "editor/panels/a.cpp"
                               << "#include \"moc_a.cpp\"";
    QTest::newRow("no include") << "core/base/a.cpp"
                                << "// to include \"editor/window/actions.h\" would be wrong";
}

void ArchitectureTest::anAllowedIncludePasses() {
    QFETCH(QString, path);
    QFETCH(QString, line);
    expectNone(includeProblems({path.toStdString(), line.toStdString() + "\n"}, m_layers));
}

void ArchitectureTest::namesThatMeetAreFound_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<bool>("meet");

    QTest::newRow("constants") << "constexpr double slack = 1e-6; // m"
                               << "const int slack = 3;" << true;
    QTest::newRow("types") << "struct Shot {"
                           << "enum class Shot { Near, Far };" << true;
    QTest::newRow("a type with a base") << "struct Drawer : Drive {"
                                        << "using Drawer = std::function<void(int)>;" << true;
    QTest::newRow("functions") << "bool isSame(const Vec2& a, const Vec2& b) {"
                               << "int isSame(const Vec2& a, const Vec2& b) {" << true;
    QTest::newRow("a function and a table") << "int scenes() {"
                                            << "const char* const scenes[] = {" << true;
    QTest::newRow("overloads") << "bool isSame(const Vec2& a, const Vec2& b) {"
                               << "bool isSame(const Rot& a, const Rot& b) {" << false;
    QTest::newRow("different names") << "struct Shot {"
                                     << "struct Shots {" << false;
    QTest::newRow("inside a function") << "    const int count = 1;"
                                       << "    const int count = 2;" << false;
    QTest::newRow("words of comments") << "// the same = twice"
                                       << "// the same = twice" << false;
}

void ArchitectureTest::namesThatMeetAreFound() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(bool, meet);
    const auto source = [](const char* path, const QString& line) {
        return Source{path, "namespace {\n" + line.toStdString() + "\n} // namespace\n"};
    };
    QCOMPARE(nameProblems({source("core/math/a.cpp", first), source("core/math/b.cpp", second)}).size(),
             std::size_t{meet ? 1U : 0U});
    expectNone(nameProblems({source("core/math/a.cpp", first), source("core/base/b.cpp", second)}));
}

void ArchitectureTest::aFileOfBadFormIsFound_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("text");

    QTest::newRow("too long") << "core/base/a.cpp" << QString("\n").repeated(401);
    QTest::newRow("unfinished") << "core/base/a.cpp" << QString("// TO") + "DO: later\n";
    QTest::newRow("header without a word") << "core/base/a.h"
                                           << "#pragma once\n#include <vector>\n";
    QTest::newRow("empty header") << "core/base/a.h"
                                  << "";
    QTest::newRow("answers with a subrange") << "core/base/a.cpp"
                                             << "std::ranges::unique(all);\n";
    QTest::newRow("vague name") << "core/base/string_utils.cpp"
                                << "\n";
}

void ArchitectureTest::aFileOfBadFormIsFound() {
    QFETCH(QString, path);
    QFETCH(QString, text);
    QCOMPARE(formProblems({path.toStdString(), text.toStdString()}).size(), std::size_t{1});
}

SPACETOW_TEST(ArchitectureTest)
#include "architecture_test.moc"
