#include "editor/window/fuzzy_query.h"

#include "tests/support/test_main.h"

#include <QStringList>

#include <algorithm>

using namespace spacetow;

namespace {

/// The texts that are found, the best first, as the palette ranks them.
QStringList ranked(const QString& typed, const QStringList& texts) {
    const FuzzyQuery query(typed);
    QList<std::pair<int, QString>> found;
    for (const QString& text : texts) {
        if (const std::optional<int> score = query.score(text)) {
            found.append({*score, text});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    QStringList result;
    for (const auto& [score, text] : found) {
        result << text;
    }
    return result;
}

QString marked(const QString& typed, QString text) {
    for (const int place : FuzzyQuery(typed).places(text)) {
        text[place] = u'*';
    }
    return text;
}

} // namespace

class FuzzyQueryTest : public QObject {
    Q_OBJECT

  private slots:
    void lettersAreFoundInTheirOrderOnly() {
        QVERIFY(FuzzyQuery(u"zin").score(u"Zoom In"));
        QVERIFY(!FuzzyQuery(u"niz").score(u"Zoom In"));
        QVERIFY(!FuzzyQuery(u"zoom inn").score(u"Zoom In"));
        QVERIFY(!FuzzyQuery(u"z").score(u""));
    }

    void nothingTypedFindsEverything() {
        QVERIFY(FuzzyQuery(u"  ").isEmpty());
        QVERIFY(FuzzyQuery(u"").score(u"Zoom In"));
    }

    void startsOfWordsComeFirst() {
        QCOMPARE(ranked("zi", {"Resize Image", "Pizzicato", "Zoom In"}).front(), QString("Zoom In"));
        QCOMPARE(ranked("save", {"Unsaved work", "Save"}).front(), QString("Save"));
        QCOMPARE(marked("rl", "Tool, Rotate Left"), QString("Tool, *otate *eft"));
    }

    void capitalsWithinAWordAreStartsToo() {
        QCOMPARE(ranked("cw", {"sawcow", "caveWall"}).front(), QString("caveWall"));
        QCOMPARE(marked("cw", "cowCaveWall"), QString("*owCave*all"));
    }

    void lettersInARowComeBeforeScatteredOnes() {
        QCOMPARE(ranked("rect", {"Rotate each tile", "Rectangle"}).front(), QString("Rectangle"));
        QCOMPARE(marked("over", "Cover over"), QString("Cover ****"));
    }

    void theWholeWordComesBeforeItsBeginning() {
        QCOMPARE(ranked("line", {"Lineage", "A line"}).size(), 2);
        QCOMPARE(ranked("cut", {"Cutter", "Cut"}).front(), QString("Cut"));
    }

    void theShorterNameComesFirst() {
        QCOMPARE(ranked("rock", {"rock with a long name behind", "rock"}).front(), QString("rock"));
    }

    void caseAndAccentsDoNotMatter() {
        QVERIFY(FuzzyQuery(u"grosse").score(QStringLiteral("Größe")) == std::nullopt); // a letter for a letter
        QVERIFY(FuzzyQuery(u"grose").score(QStringLiteral("Größe")));
        QVERIFY(FuzzyQuery(u"GRÖßE").score(u"Grosse"));
        QVERIFY(FuzzyQuery(u"ecran").score(QStringLiteral("Plein écran")));
        QVERIFY(FuzzyQuery(QStringLiteral("ёлка")).score(QStringLiteral("Елка")));
        QVERIFY(FuzzyQuery(u"lodz").score(QStringLiteral("Łódź")));
        QVERIFY(FuzzyQuery(u"墙").score(QStringLiteral("单向墙")));
    }

    void wordsMayComeInAnyOrder() {
        QVERIFY(FuzzyQuery(u"in zoom").score(u"Zoom In"));
        QCOMPARE(marked("left rot", "Rotate Left"), QString("***ate ****"));
    }

    void equalScoresKeepTheirOrder() {
        const QStringList texts{"rock a", "rock b", "rock c", "rock d"};
        QCOMPARE(ranked("rock", texts), texts);
    }

    void aLongTextIsNoBurden() {
        const QString text(100'000, u'a');
        QVERIFY(FuzzyQuery(QString(50'000, u'a')).score(text));
        QVERIFY(!FuzzyQuery(u"b").score(text));
    }
};

SPACETOW_TEST(FuzzyQueryTest)
#include "fuzzy_query_test.moc"
