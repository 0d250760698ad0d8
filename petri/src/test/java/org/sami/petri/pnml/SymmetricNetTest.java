package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;

/** Symmetric nets are unfolded to nets of the same behaviour. */
class SymmetricNetTest {
    private static final String HEAD = """
        <?xml version="1.0"?>
        <pnml xmlns="http://www.pnml.org/version-2009/grammar/pnml">
        <net id="n" type="http://www.pnml.org/version-2009/grammar/symmetricnet"><page id="g">
        """;

    /** Processors 0 to 4; pairs of them; variables x and y. */
    private static final String DECLARATIONS = """
        </page><declaration><text>for people</text><structure><declarations>
        <namedsort id="P" name="Processor"><cyclicenumeration>
        <feconstant id="p0" name="0"/><feconstant id="p1" name="1"/><feconstant id="p2" name="2"/><feconstant id="p3" name="3"/><feconstant id="p4" name="4"/>
        </cyclicenumeration></namedsort>
        <namedsort id="PP" name="Pair"><productsort><usersort declaration="P"/><usersort declaration="P"/></productsort></namedsort>
        <namedsort id="dot" name="dot"><dot/></namedsort>
        <variabledecl id="x" name="x"><usersort declaration="P"/></variabledecl>
        <variabledecl id="y" name="y"><usersort declaration="P"/></variabledecl>
        </declarations></structure></declaration></net></pnml>
        """;

    private static final String X = "<variable refvariable='x'/>";
    private static final String Y = "<variable refvariable='y'/>";
    private static final String DOT = "<dotconstant/>";
    private static final String ALL = "<all><usersort declaration='P'/></all>";
    private static final String PAIR = "<tuple><subterm>" + X + "</subterm><subterm>" + Y + "</subterm></tuple>";

    private int arcs;

    private static String place(String id, String sort, String initial) {
        String marking = initial.isEmpty()
                ? ""
                : "<hlinitialMarking><text>m</text><structure>" + initial + "</structure></hlinitialMarking>";
        return "<place id='" + id + "'><type><structure><usersort declaration='" + sort + "'/></structure></type>"
                + marking + "</place>\n";
    }

    private static String transition(String id, String condition) {
        return "<transition id='" + id + "'>"
                + (condition.isEmpty() ? "" : "<condition><structure>" + condition + "</structure></condition>")
                + "</transition>\n";
    }

    private String arc(String source, String target, String term) {
        return "<arc id='a" + arcs++ + "' source='" + source + "' target='" + target + "'><hlinscription><structure>"
                + term + "</structure></hlinscription></arc>\n";
    }

    private static String two(String operator, String first, String second) {
        return "<" + operator + "><subterm>" + first + "</subterm><subterm>" + second + "</subterm></" + operator + ">";
    }

    private static PnmlReading read(String content) {
        byte[] bytes = (HEAD + content + DECLARATIONS).getBytes(StandardCharsets.UTF_8);
        return PnmlReader.read(new ByteArrayInputStream(bytes), PnmlLimits.STANDARD);
    }

    private static PetriNet net(PnmlReading reading) {
        assertThat(reading.findings()).isEmpty();
        return reading.net().orElseThrow();
    }

    @Test
    void sharedMemoryHasThePublishedNumberOfStates() {
        String text = place("active", "P", ALL)
                + place("memory", "P", ALL)
                + place("queue", "P", "")
                + place("own", "P", "")
                + place("access", "PP", "")
                + place("bus", "dot", DOT)
                + transition("ask", "")
                + arc("active", "ask", X)
                + arc("ask", "queue", X)
                + transition("beginOwn", "")
                + arc("active", "beginOwn", X)
                + arc("memory", "beginOwn", X)
                + arc("beginOwn", "own", X)
                + transition("endOwn", "")
                + arc("own", "endOwn", X)
                + arc("endOwn", "active", X)
                + arc("endOwn", "memory", X)
                + transition("begin", two("inequality", X, Y))
                + arc("queue", "begin", X)
                + arc("memory", "begin", Y)
                + arc("bus", "begin", DOT)
                + arc("begin", "memory", Y)
                + arc("begin", "access", PAIR)
                + transition("end", "")
                + arc("access", "end", PAIR)
                + arc("end", "active", X)
                + arc("end", "bus", DOT);

        PetriNet net = net(read(text));

        assertThat(net.placeCount()).isEqualTo(4 * 5 + 25 + 1);
        assertThat(net.transitionCount()).isEqualTo(3 * 5 + 20 + 25);
        assertThat(net.place("access(3,4)")).isPresent();
        assertThat(net.place("bus")).isPresent();
        assertThat(net.transition("begin(x=3,y=4)")).isPresent();
        assertThat(ReachabilitySearch.explore(net, SearchSettings.within(SearchBudget.ofStates(100_000)))
                        .states())
                .isEqualTo(1863);
    }

    @Test
    void philosophersTakeTheForkAfterTheirs() {
        String next = "<successor><subterm>" + X + "</subterm></successor>";
        String text = place("thinks", "P", ALL)
                + place("fork", "P", ALL)
                + place("left", "P", "")
                + place("right", "P", "")
                + place("eats", "P", "")
                + transition("takeLeft", "")
                + arc("thinks", "takeLeft", X)
                + arc("fork", "takeLeft", X)
                + arc("takeLeft", "left", X)
                + transition("takeRight", "")
                + arc("thinks", "takeRight", X)
                + arc("fork", "takeRight", next)
                + arc("takeRight", "right", X)
                + transition("thenRight", "")
                + arc("left", "thenRight", X)
                + arc("fork", "thenRight", next)
                + arc("thenRight", "eats", X)
                + transition("thenLeft", "")
                + arc("right", "thenLeft", X)
                + arc("fork", "thenLeft", X)
                + arc("thenLeft", "eats", X)
                + transition("layDown", "")
                + arc("eats", "layDown", X)
                + arc("layDown", "thinks", X)
                + arc("layDown", "fork", two("add", X, next));

        assertThat(ReachabilitySearch.explore(net(read(text)), SearchSettings.within(SearchBudget.ofStates(100_000)))
                        .states())
                .isEqualTo(243);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        equality | 5
        inequality | 20
        lessthan | 10
        lessthanorequal | 15
        greaterthan | 10
        greaterthanorequal | 15
        """)
    void conditionsChooseColours(String relation, int count) {
        String text = place("p", "PP", "") + transition("t", two(relation, X, Y)) + arc("t", "p", PAIR);

        assertThat(net(read(text)).transitionCount()).isEqualTo(count);
    }

    @Test
    void conditionsAreCombined() {
        String first = two("equality", X, "<useroperator declaration='p0'/>");
        String second = two("equality", Y, "<predecessor><subterm>" + X + "</subterm></predecessor>");
        String text = place("p", "PP", "")
                + transition("t", two("and", first, second))
                + arc("t", "p", PAIR)
                + transition("u", two("or", first, "<not><subterm>" + second + "</subterm></not>"))
                + arc("u", "p", PAIR);

        PetriNet net = net(read(text));

        assertThat(net.transition("t(x=0,y=4)")).isPresent();
        assertThat(net.transition("t(x=0,y=3)")).isEmpty();
        assertThat(net.transitionCount()).isEqualTo(1 + 25 - 4);
    }

    @Test
    void multiplesAndDifferencesOfColoursAreWeights() {
        String two = two("numberof", "<numberconstant value='2'><positive/></numberconstant>", X);
        String text = place("p", "P", two("subtract", two("add", ALL, ALL), "<useroperator declaration='p3'/>"))
                + transition("t", "")
                + arc("p", "t", two);

        PetriNet net = net(read(text));

        assertThat(net.initialMarking()).containsExactly(2, 2, 2, 1, 2);
        assertThat(net.consumed().weight(0, 0)).isEqualTo(2);
    }

    @Test
    void constantsThatAllHaveTheNameOfTheirSortAreToldApartByTheirIds() {
        String text = HEAD + place("p", "P", ALL) + DECLARATIONS.replaceAll("name=\"[0-4]\"", "name=\"Processor\"");

        PnmlReading reading =
                PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);

        assertThat(net(reading).place("p(p3)")).isPresent();
    }

    @Test
    void whatIsWrongOrNotKnownIsNamedWithItsLine() {
        assertError(place("p", "Q", ""), "E-TERM", "there is no sort 'Q'");
        assertError(place("p", "P", DOT), "E-TERM", "the initial marking is not of the sort of the place");
        assertError(place("p", "P", X), "E-TERM", "a variable has no value here: x");
        assertError(place("p", "P", "<magic/>"), "E-TERM", "terms of the kind magic are not read");
        assertError(place("p", "P", two("add", DOT, ALL)), "E-TERM", "the sorts of the parts differ");
        assertError(
                place("p", "P", two("subtract", "<useroperator declaration='p0'/>", ALL)),
                "E-NUMBER",
                "-1 tokens cannot be there");
        assertError(
                place("p", "P", "") + transition("t", "") + arc("t", "p", "<variable refvariable='z'/>"),
                "E-TERM",
                "there is no variable 'z'");
    }

    private static void assertError(String content, String code, String message) {
        PnmlReading reading = read(content);

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo(code);
        assertThat(reading.findings().get(0).message()).isEqualTo(message);
        assertThat(reading.findings().get(0).line()).isGreaterThan(3);
    }

    @Test
    void labelsWithoutAStructureAreErrors() {
        assertError(
                place("p", "P", ALL) + "<transition id='t'><condition><text>x&lt;y</text></condition></transition>",
                "E-TERM",
                "condition 'x<y' has no structure: texts are not read");
        assertError(
                "<place id='p'><hlinitialMarking><text>1'p0</text></hlinitialMarking></place>",
                "E-TERM",
                "hlinitialMarking '1'p0' has no structure: texts are not read");
        assertError(
                "<place id='p'><type><text>P</text></type></place>",
                "E-TERM",
                "type 'P' has no structure: texts are not read");
        assertError(
                place("p", "dot", DOT) + transition("t", "")
                        + "<arc id='a' source='p' target='t'><hlinscription><text>x</text></hlinscription></arc>",
                "E-TERM",
                "hlinscription 'x' has no structure: texts are not read");
    }

    @Test
    void theTypeOfAnArcMayBeAText() {
        PetriNet net = net(read(place("p", "dot", DOT) + transition("t", "")
                + "<arc id='a' source='p' target='t'><type><text>inhibitor</text></type></arc>"));

        assertThat(net.inhibitors().weight(0, 0)).isEqualTo(1);
        assertThat(net.consumed().weight(0, 0)).isZero();
    }

    private static PnmlReading declared(String sorts) {
        String text = HEAD + "</page><declaration><structure><declarations>" + sorts
                + "</declarations></structure></declaration></net></pnml>";
        return PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
    }

    private static String sort(String id, String of) {
        return "<namedsort id='" + id + "'>" + of + "</namedsort>\n";
    }

    private static String use(String sort) {
        return "<usersort declaration='" + sort + "'/>";
    }

    @Test
    void productsThatGrowByThemselvesAreRefused() {
        StringBuilder sorts = new StringBuilder(sort("s0", "<dot/>"));
        for (int i = 1; i <= 40; i++) {
            sorts.append(sort("s" + i, "<productsort>" + use("s" + (i - 1)).repeat(2) + "</productsort>"));
        }

        PnmlReading reading = declared(sorts.toString());

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo("E-SIZE");
        assertThat(reading.findings().get(0).message()).isEqualTo("a product of more than 64 sorts is not read");
        assertThat(reading.findings().get(0).line()).isEqualTo(3 + 8);
    }

    @Test
    void longChainsOfSortsAreRefused() {
        StringBuilder sorts = new StringBuilder(sort("s0", "<dot/>"));
        for (int i = 1; i <= 100_000; i++) {
            sorts.append(sort("s" + i, use("s" + (i - 1))));
        }

        PnmlReading reading = declared(sorts.toString());

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo("E-DEPTH");
        assertThat(reading.findings().get(0).line()).isGreaterThan(3);
    }

    @Test
    void arcsFollowLongChainsOfReferences() {
        StringBuilder text = new StringBuilder(place("p", "dot", DOT) + transition("t", ""));
        for (int i = 0; i < 20_000; i++) {
            String target = i == 0 ? "p" : "r" + (i - 1);
            text.append("<referencePlace id='r" + i + "' ref='" + target + "'/>");
            if (i % 10 == 9) {
                text.append(arc("r" + i, "t", DOT));
            }
        }

        assertThat(net(read(text.toString())).consumed().weight(0, 0)).isEqualTo(2000);
    }

    @Test
    void plainNumbersOfASymmetricNetAreNamedAndLeftOut() {
        String text = "<place id='p'><initialMarking><text>5</text></initialMarking></place>"
                + "<transition id='t'/><arc id='a' source='p' target='t'><inscription><text>3</text></inscription></arc>";

        PnmlReading reading = read(text);

        assertThat(reading.net()).isPresent();
        assertThat(reading.findings())
                .extracting(finding -> finding.code() + " " + finding.element() + ": " + finding.message())
                .containsExactly(
                        "W-ELEMENT place p: the element initialMarking is not known, and left out",
                        "W-ELEMENT arc a: the element inscription is not known, and left out");
    }

    private static String times(int number, String term) {
        return two("numberof", "<numberconstant value='" + number + "'><positive/></numberconstant>", term);
    }

    @Test
    void countsThatExceedALongAreRefused() {
        String large = times(1 << 29, times(1 << 29, DOT));
        String words = " has more tokens of a colour than can be counted";

        assertError(place("p", "dot", times(1 << 29, large)), "E-NUMBER", "numberof" + words);
        assertError(
                place("p", "dot", "") + transition("t", "") + arc("t", "p", times(1 << 29, large)),
                "E-NUMBER",
                "numberof" + words);
        String most = times(31, large);
        assertError(place("p", "dot", two("add", most, most)), "E-NUMBER", "add" + words);
        String less = two("subtract", "<empty><usersort declaration='dot'/></empty>", most);
        assertError(place("p", "dot", two("subtract", less, most)), "E-NUMBER", "subtract" + words);
        assertError(
                place("p", "dot", "") + transition("t", two("contains", less, most)), "E-NUMBER", "contains" + words);
    }
}
