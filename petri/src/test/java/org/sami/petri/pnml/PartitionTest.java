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

/** Partitions of symmetric nets are unfolded: their elements, to which element a colour belongs, and the order of elements. */
class PartitionTest {
    /** Five boats of three ranks, two scouts, two carriers and a leader, and a second partition into near and far ones. */
    private static final String BOATS = """
        <namedsort id="Boat" name="Boat"><finiteenumeration>
        <feconstant id="b1" name="b1"/><feconstant id="b2" name="b2"/><feconstant id="b3" name="b3"/><feconstant id="b4" name="b4"/><feconstant id="b5" name="b5"/>
        </finiteenumeration></namedsort>
        <namedsort id="BoatRank" name="BoatRank"><productsort><usersort declaration="Boat"/><usersort declaration="Rank"/></productsort></namedsort>
        <namedsort id="BoatBoat" name="BoatBoat"><productsort><usersort declaration="Boat"/><usersort declaration="Boat"/></productsort></namedsort>
        <variabledecl id="x" name="x"><usersort declaration="Boat"/></variabledecl>
        <variabledecl id="y" name="y"><usersort declaration="Boat"/></variabledecl>
        <variabledecl id="r" name="r"><usersort declaration="Rank"/></variabledecl>
        """;

    private static final String RANKS = partition("Rank", "Boat", "scout: b1 b3", "carrier: b2 b4", "leader: b5");
    private static final String DISTANCES = partition("Distance", "Boat", "near: b1 b2 b3", "far: b4 b5");
    private static final String X = "<variable refvariable='x'/>";
    private static final String Y = "<variable refvariable='y'/>";

    private static String partition(String id, String sort, String... elements) {
        StringBuilder text = new StringBuilder(
                "<partition id='" + id + "' name='" + id + "'><usersort declaration='" + sort + "'/>\n");
        for (String element : elements) {
            String[] parts = element.split(": ", 2);
            text.append("<partitionelement id='" + parts[0] + "' name='" + parts[0] + "'>");
            for (String colour : parts[1].split(" ")) {
                text.append(colour(colour));
            }
            text.append("</partitionelement>\n");
        }
        return text.append("</partition>\n").toString();
    }

    private static String colour(String id) {
        return "<useroperator declaration='" + id + "'/>";
    }

    private static String of(String partition, String term) {
        return "<partitionelementof refpartition='" + partition + "'><subterm>" + term
                + "</subterm></partitionelementof>";
    }

    private static String two(String operator, String first, String second) {
        return "<" + operator + "><subterm>" + first + "</subterm><subterm>" + second + "</subterm></" + operator + ">";
    }

    private static String place(String id, String sort, String initial) {
        return "<place id='" + id + "'><type><structure><usersort declaration='" + sort + "'/></structure></type>"
                + (initial.isEmpty()
                        ? ""
                        : "<hlinitialMarking><structure>" + initial + "</structure></hlinitialMarking>")
                + "</place>\n";
    }

    private static String transition(String id, String condition) {
        return "<transition id='" + id + "'>"
                + (condition.isEmpty() ? "" : "<condition><structure>" + condition + "</structure></condition>")
                + "</transition>\n";
    }

    private static String arc(String source, String target, String term) {
        return "<arc id='" + source + target + "' source='" + source + "' target='" + target
                + "'><hlinscription><structure>" + term + "</structure></hlinscription></arc>\n";
    }

    private static PnmlReading read(String content, String partitions) {
        String text = """
                <?xml version="1.0"?>
                <pnml xmlns="http://www.pnml.org/version-2009/grammar/pnml">
                <net id="n" type="http://www.pnml.org/version-2009/grammar/symmetricnet"><page id="g">
                """
                + content
                + "</page><declaration><structure><declarations>"
                + BOATS
                + partitions
                + "</declarations></structure></declaration></net></pnml>";
        return PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
    }

    private static PetriNet net(String content) {
        PnmlReading reading = read(content, RANKS + DISTANCES);
        assertThat(reading.findings()).isEmpty();
        return reading.net().orElseThrow();
    }

    @ParameterizedTest
    @CsvSource({"gtp, 8", "ltp, 8", "equality, 9", "inequality, 16"})
    void elementsAreComparedInTheirOrder(String relation, int count) {
        PetriNet net = net(place("p", "BoatBoat", "")
                + transition("t", two(relation, of("Rank", X), of("Rank", Y)))
                + arc("t", "p", "<tuple><subterm>" + X + "</subterm><subterm>" + Y + "</subterm></tuple>"));

        assertThat(net.transitionCount()).isEqualTo(count);
        assertThat(net.transition("t(x=b5,y=b4)").isPresent())
                .isEqualTo(relation.equals("gtp") || relation.equals("inequality"));
        assertThat(net.transition("t(x=b1,y=b3)").isPresent()).isEqualTo(relation.equals("equality"));
    }

    @Test
    void anElementIsAConstantOfItsPartition() {
        PetriNet net = net(place("p", "Boat", "")
                + transition("t", two("equality", of("Rank", X), colour("carrier")))
                + arc("t", "p", X));

        assertThat(net.transitionCount()).isEqualTo(2);
        assertThat(net.transition("t(x=b2)")).isPresent();
        assertThat(net.transition("t(x=b4)")).isPresent();
    }

    @Test
    void placesHoldElements() {
        PetriNet net = net(place("boats", "Boat", "<all><usersort declaration='Boat'/></all>")
                + place("ranks", "Rank", "")
                + transition("land", "")
                + arc("boats", "land", X)
                + arc("land", "ranks", of("Rank", X)));

        assertThat(net.place("ranks(leader)")).isPresent();
        assertThat(net.place("ranks(b1)")).isEmpty();
        // 0 to 2 scouts, 0 to 2 carriers, each of them one or the other, a leader or none: 2^5 states of boats
        assertThat(ReachabilitySearch.explore(net, SearchSettings.within(SearchBudget.ofStates(1000)))
                        .states())
                .isEqualTo(32);
        int scout = net.place("ranks(scout)").orElseThrow();
        assertThat(ReachabilitySearch.explore(net, SearchSettings.within(SearchBudget.ofStates(1000)))
                        .mostTokens(scout))
                .isEqualTo(2);
    }

    @Test
    void anElementWhereAColourIsExpectedStandsForAllItsColours() {
        PetriNet net = net(place("boats", "Boat", two("add", colour("scout"), colour("leader")))
                + place(
                        "pairs",
                        "BoatBoat",
                        "<tuple><subterm>" + colour("b2") + "</subterm><subterm>" + colour("carrier")
                                + "</subterm></tuple>")
                + transition("go", "")
                + arc("boats", "go", colour("scout")));

        assertThat(net.initial(net.place("boats(b1)").orElseThrow())).isEqualTo(1);
        assertThat(net.initial(net.place("boats(b2)").orElseThrow())).isZero();
        assertThat(net.initial(net.place("boats(b5)").orElseThrow())).isEqualTo(1);
        assertThat(net.initial(net.place("pairs(b2,b4)").orElseThrow())).isEqualTo(1);
        assertThat(net.initial(net.place("pairs(b4,b2)").orElseThrow())).isZero();
        assertThat(net.consumed().weight(0, net.place("boats(b3)").orElseThrow()))
                .isEqualTo(1);
    }

    @Test
    void variablesAndProductsAreOfPartitionsToo() {
        PetriNet net = net(place("p", "BoatRank", "")
                + transition("t", two("equality", of("Rank", X), "<variable refvariable='r'/>"))
                + arc(
                        "t",
                        "p",
                        "<tuple><subterm>" + X + "</subterm><subterm><variable refvariable='r'/></subterm></tuple>"));

        assertThat(net.placeCount()).isEqualTo(15);
        assertThat(net.transitionCount()).isEqualTo(5);
        assertThat(net.transition("t(x=b5,r=leader)")).isPresent();
    }

    @Test
    void aRangeOfNumbersIsDividedToo() {
        String numbers = "<namedsort id='Lane' name='Lane'><finiteintrange start='1' end='3'/></namedsort>"
                + "<variabledecl id='l' name='l'><usersort declaration='Lane'/></variabledecl>"
                + "<partition id='Side' name='Side'><usersort declaration='Lane'/>"
                + "<partitionelement id='left' name='left'>" + number(1) + number(2) + "</partitionelement>"
                + "<partitionelement id='right' name='right'>" + number(3) + "</partitionelement></partition>";
        String lane = "<variable refvariable='l'/>";

        PetriNet net = read(
                        place("p", "Lane", "")
                                + transition("t", two("equality", of("Side", lane), colour("left")))
                                + arc("t", "p", lane),
                        RANKS + numbers)
                .net()
                .orElseThrow();

        assertThat(net.transitionCount()).isEqualTo(2);
        assertThat(net.transition("t(l=3)")).isEmpty();
    }

    private static String number(int value) {
        return "<finiteintrangeconstant value='" + value
                + "'><finiteintrange start='1' end='3'/></finiteintrangeconstant>";
    }

    @Test
    void whatIsNoPartitionIsNamed() {
        String compared = place("p", "Boat", "")
                + transition("t", two("gtp", of("Rank", X), of("Distance", Y)))
                + arc("t", "p", X);
        assertError(compared, RANKS + DISTANCES, "the sorts of the parts differ");
        assertError(
                "",
                RANKS + partition("Some", "Boat", "a: b1 b2", "b: b4 b5"),
                "colour (b3) is in no element of partition Some");
        assertError(
                "",
                RANKS + partition("Some", "Boat", "a: b1 b2 b3", "b: b3 b4 b5"),
                "colour (b3) is in two elements of partition Some");
        assertError("", RANKS + partition("Some", "Rank", "a: b1"), "a colour in partition Some is not of its sort");
        assertError("", RANKS + partition("Some", "Some", "a: b1"), "sort Some contains itself");
        assertError(
                "",
                RANKS + "<partition id='Some' name='Some'><usersort declaration='Boat'/><dot/></partition>",
                "partition Some has other parts than one sort and its elements");
        assertError(
                place("p", "Boat", "") + transition("t", two("equality", of("Rink", X), colour("leader"))),
                RANKS,
                "there is no partition 'Rink'");
        assertError(
                place("p", "Boat", "") + transition("t", two("equality", of("Rank", colour("near")), colour("leader"))),
                RANKS + DISTANCES,
                "partition Rank is of another sort than its argument");
    }

    private static void assertError(String content, String partitions, String message) {
        PnmlReading reading = read(content, partitions);

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo("E-TERM");
        assertThat(reading.findings().get(0).message()).isEqualTo(message);
        assertThat(reading.findings().get(0).line()).isGreaterThan(3);
    }
}
