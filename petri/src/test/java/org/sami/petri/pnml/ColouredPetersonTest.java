package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.StringJoiner;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.model.MutualExclusionNets;
import org.sami.petri.net.PetriNet;

/** Peterson's algorithm as a symmetric net, with processes, tours and truths as colours, has the states of the net without colours. */
class ColouredPetersonTest {
    private static final int TOURS = 2;
    private final StringBuilder net = new StringBuilder();
    private int arcs;

    @Test
    void unfoldedItHasThePublishedNumberOfStates() {
        place("idle", "P", "<all><usersort declaration='P'/></all>");
        place("wants", "PB", sum("p0,no", "p1,no", "p2,no"));
        place("last", "TP", sum("t0,p0", "t1,p0"));
        place("critical", "P", "");
        for (String place : new String[] {"asks", "reads", "through"}) {
            place(place, "PT", "");
        }
        for (String place : new String[] {"begins", "compares", "tests", "looked"}) {
            place(place, "PTP", "");
        }
        move("ask", "", "idle: i; wants: i,no", "wants: i,yes; asks: i,t0");
        move("write", "", "asks: i,j; last: j,k", "last: j,i; reads: i,j");
        move("lastToCome", "", "reads: i,j; last: j,i", "last: j,i; begins: i,j,p0");
        move("after", "i!=k", "reads: i,j; last: j,k", "last: j,k; through: i,j");
        move("look", "", "begins: i,j,k", "compares: i,j,k");
        move("self", "", "compares: i,j,i", "looked: i,j,i");
        move("other", "i!=k", "compares: i,j,k", "tests: i,j,k");
        move("isAlone", "", "tests: i,j,k; wants: k,no", "looked: i,j,k; wants: k,no");
        move("isNotAlone", "", "tests: i,j,k; wants: k,yes", "reads: i,j; wants: k,yes");
        move("go", "k!=p2", "looked: i,j,k", "begins: i,j,+k");
        move("seen", "", "looked: i,j,p2", "through: i,j");
        move("next", "j!=t1", "through: i,j", "asks: i,+j");
        move("enter", "", "through: i,t1", "critical: i");
        move("leave", "", "critical: i; wants: i,yes", "idle: i; wants: i,no");

        SearchSettings whole = SearchSettings.within(SearchBudget.ofStates(100_000));
        ReachabilityGraph graph = ReachabilitySearch.explore(unfolded(), whole);
        ReachabilityGraph plain = ReachabilitySearch.explore(MutualExclusionNets.peterson(TOURS), whole);

        assertThat(graph.states()).isEqualTo(20_754).isEqualTo(plain.states());
        assertThat(graph.edges()).isEqualTo(plain.edges());
    }

    private PetriNet unfolded() {
        String text = "<pnml xmlns='http://www.pnml.org/version-2009/grammar/pnml'><net id='peterson'"
                + " type='http://www.pnml.org/version-2009/grammar/symmetricnet'><page id='page'>" + net + "</page>"
                + "<declaration><structure><declarations>"
                + sort("P", "p0", "p1", "p2")
                + sort("T", "t0", "t1")
                + sort("B", "no", "yes")
                + product("PB", "P", "B")
                + product("TP", "T", "P")
                + product("PT", "P", "T")
                + product("PTP", "P", "T", "P")
                + variable("i", "P")
                + variable("k", "P")
                + variable("j", "T")
                + "</declarations></structure></declaration></net></pnml>";
        PnmlReading reading =
                PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
        assertThat(reading.findings()).isEmpty();
        return reading.net().orElseThrow();
    }

    private static String sort(String id, String... colours) {
        StringJoiner text = new StringJoiner(
                "",
                "<namedsort id='" + id + "' name='" + id + "'><cyclicenumeration>",
                "</cyclicenumeration></namedsort>");
        for (String colour : colours) {
            text.add("<feconstant id='" + colour + "' name='" + colour + "'/>");
        }
        return text.toString();
    }

    private static String product(String id, String... sorts) {
        StringJoiner text = new StringJoiner(
                "", "<namedsort id='" + id + "' name='" + id + "'><productsort>", "</productsort></namedsort>");
        for (String sort : sorts) {
            text.add("<usersort declaration='" + sort + "'/>");
        }
        return text.toString();
    }

    private static String variable(String id, String sort) {
        return "<variabledecl id='" + id + "' name='" + id + "'><usersort declaration='" + sort + "'/></variabledecl>";
    }

    private void place(String id, String sort, String initial) {
        net.append("<place id='" + id + "'><type><structure><usersort declaration='" + sort + "'/></structure></type>"
                + (initial.isEmpty()
                        ? ""
                        : "<hlinitialMarking><structure>" + initial + "</structure></hlinitialMarking>")
                + "</place>\n");
    }

    /** A transition; arcs are {@code place: term; place: term}, a condition is {@code one!=other}. */
    private void move(String id, String condition, String from, String to) {
        String[] sides = condition.split("!=", 2);
        net.append("<transition id='" + id + "'>"
                + (condition.isEmpty()
                        ? ""
                        : "<condition><structure><inequality>" + sub(single(sides[0])) + sub(single(sides[1]))
                                + "</inequality></structure></condition>")
                + "</transition>\n");
        for (String arc : from.split("; ", -1)) {
            String[] parts = arc.split(": ", 2);
            arc(parts[0], id, parts[1]);
        }
        for (String arc : to.split("; ", -1)) {
            String[] parts = arc.split(": ", 2);
            arc(id, parts[0], parts[1]);
        }
    }

    private void arc(String source, String target, String term) {
        net.append("<arc id='a" + arcs++ + "' source='" + source + "' target='" + target
                + "'><hlinscription><structure>" + once(term) + "</structure></hlinscription></arc>\n");
    }

    private static String sum(String... terms) {
        StringJoiner text = new StringJoiner("", "<add>", "</add>");
        for (String term : terms) {
            text.add(sub(once(term)));
        }
        return text.toString();
    }

    private static String once(String term) {
        return "<numberof>" + sub("<numberconstant value='1'><positive/></numberconstant>") + sub(term(term))
                + "</numberof>";
    }

    private static String term(String term) {
        String[] parts = term.split(",", -1);
        if (parts.length == 1) {
            return single(term);
        }
        StringJoiner text = new StringJoiner("", "<tuple>", "</tuple>");
        for (String part : parts) {
            text.add(sub(single(part)));
        }
        return text.toString();
    }

    /** A variable, a colour, or {@code +variable} for the next colour. */
    private static String single(String term) {
        if (term.startsWith("+")) {
            return "<successor>" + sub(single(term.substring(1))) + "</successor>";
        }
        return term.matches("[ijk]")
                ? "<variable refvariable='" + term + "'/>"
                : "<useroperator declaration='" + term + "'/>";
    }

    private static String sub(String term) {
        return "<subterm>" + term + "</subterm>";
    }
}
