package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.petri.pnml.SymmetricNetText.all;
import static org.sami.petri.pnml.SymmetricNetText.colour;
import static org.sami.petri.pnml.SymmetricNetText.dot;
import static org.sami.petri.pnml.SymmetricNetText.none;
import static org.sami.petri.pnml.SymmetricNetText.one;
import static org.sami.petri.pnml.SymmetricNetText.op;
import static org.sami.petri.pnml.SymmetricNetText.v;

import org.junit.jupiter.api.Test;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;

/**
 * Symmetric nets of the kind that tools are compared with have the numbers of states that others have published (philosophers, token ring, referendum), or that a
 * plain explorer written for each of them has counted (database, bus, election).
 */
class WellKnownSymmetricNetsTest {
    private static ReachabilityGraph explored(SymmetricNetText text) {
        PnmlReading reading = text.read();
        assertThat(reading.findings())
                .allSatisfy(finding -> assertThat(finding.code()).startsWith("N-"));
        return ReachabilitySearch.explore(
                reading.net().orElseThrow(), SearchSettings.within(SearchBudget.ofStates(100_000)));
    }

    private static String pair(String first, String second) {
        return one(op("tuple", first, second));
    }

    @Test
    void fivePhilosophersHaveThePublishedStates() {
        String x = one(v("x"));
        String next = one(op("successor", v("x")));
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("cyclicenumeration", "P", 5)
                .variables("P", "x")
                .place("think", "P", all("P"))
                .place("fork", "P", all("P"))
                .place("left", "P", "")
                .place("right", "P", "")
                .place("eat", "P", "")
                .transition("takeLeft", "")
                .arc("think", "takeLeft", x)
                .arc("fork", "takeLeft", x)
                .arc("takeLeft", "left", x)
                .transition("takeRight", "")
                .arc("think", "takeRight", x)
                .arc("fork", "takeRight", next)
                .arc("takeRight", "right", x)
                .transition("eatFromLeft", "")
                .arc("left", "eatFromLeft", x)
                .arc("fork", "eatFromLeft", next)
                .arc("eatFromLeft", "eat", x)
                .transition("eatFromRight", "")
                .arc("right", "eatFromRight", x)
                .arc("fork", "eatFromRight", x)
                .arc("eatFromRight", "eat", x)
                .transition("end", "")
                .arc("eat", "end", x)
                .arc("end", "think", x)
                .arc("end", "fork", op("add", x, next));

        assertThat(explored(net).states()).isEqualTo(243);
    }

    @Test
    void aTokenRingOfSixHasThePublishedStates() {
        String own = pair(v("x"), v("y"));
        String firstAndLast = op("add", pair(colour("P0"), v("x")), pair(colour("P5"), v("x")));
        String moved = op("add", pair(colour("P0"), op("successor", v("x"))), pair(colour("P5"), v("x")));
        String[] equal = new String[6];
        for (int i = 0; i < equal.length; i++) {
            equal[i] = pair(colour("P" + i), colour("P" + i));
        }
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("cyclicenumeration", "P", 6)
                .product("PP", "P", "P")
                .variables("P", "x", "y", "z")
                .place("state", "PP", op("add", equal))
                .transition("first", "")
                .arc("state", "first", firstAndLast)
                .arc("first", "state", moved)
                .transition(
                        "other", op("and", op("inequality", v("y"), v("z")), op("inequality", v("x"), colour("P5"))))
                .arc("state", "other", op("add", own, pair(op("successor", v("x")), v("z"))))
                .arc("other", "state", op("add", own, pair(op("successor", v("x")), v("y"))));

        assertThat(explored(net).states()).isEqualTo(166);
    }

    @Test
    void aReferendumOfTenHasThePublishedStates() {
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("finiteenumeration", "V", 10)
                .sort("dot", "<dot/>")
                .variables("V", "v")
                .place("ready", "dot", dot())
                .place("voting", "V", "")
                .place("yes", "V", "")
                .place("no", "V", "")
                .transition("start", "")
                .arc("ready", "start", dot())
                .arc("start", "voting", one(all("V")))
                .transition("voteYes", "")
                .arc("voting", "voteYes", one(v("v")))
                .arc("voteYes", "yes", one(v("v")))
                .transition("voteNo", "")
                .arc("voting", "voteNo", one(v("v")))
                .arc("voteNo", "no", one(v("v")));

        assertThat(explored(net).states()).isEqualTo(59_050);
    }

    @Test
    void aDatabaseTellsAllSitesButTheSender() {
        String waiting = pair(v("s"), v("f"));
        String message = one(op("tuple", v("s"), v("r"), v("f")));
        String others =
                op("subtract", one(op("tuple", v("s"), all("S"), v("f"))), one(op("tuple", v("s"), v("s"), v("f"))));
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("finiteenumeration", "S", 3)
                .enumeration("finiteenumeration", "F", 3)
                .product("SF", "S", "F")
                .product("SSF", "S", "S", "F")
                .variables("S", "s", "r")
                .variables("F", "f")
                .place("active", "S", all("S"))
                .place("lock", "F", all("F"))
                .place("waiting", "SF", "")
                .place("message", "SSF", "")
                .place("received", "SSF", "")
                .place("answer", "SSF", "")
                .transition("send", "")
                .arc("active", "send", one(v("s")))
                .arc("lock", "send", one(v("f")))
                .arc("send", "waiting", waiting)
                .arc("send", "message", others)
                .transition("receive", op("not", op("equality", v("s"), v("r"))))
                .arc("active", "receive", one(v("r")))
                .arc("message", "receive", message)
                .arc("receive", "received", message)
                .transition("done", "")
                .arc("received", "done", message)
                .arc("done", "active", one(v("r")))
                .arc("done", "answer", message)
                .transition("end", "")
                .arc("waiting", "end", waiting)
                .arc("answer", "end", others)
                .arc("end", "active", one(v("s")))
                .arc("end", "lock", one(v("f")));

        ReachabilityGraph space = explored(net);

        assertThat(space.states()).isEqualTo(664);
        assertThat(space.edges()).isEqualTo(1152);
    }

    @Test
    void aBusThatAllOthersHearBeginsWithAnEmptyMultiset() {
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("cyclicenumeration", "P", 3)
                .sort("dot", "<dot/>")
                .product("PP", "P", "P")
                .variables("P", "i", "j")
                .place("free", "dot", dot())
                .place("idle", "P", op("subtract", all("P"), one(colour("P0"))))
                .place("ask", "P", one(colour("P0")))
                .place("listen", "PP", none("PP"))
                .place("own", "P", none("P"))
                .place("heard", "P", "")
                .transition("request", "")
                .arc("idle", "request", one(v("i")))
                .arc("request", "ask", one(v("i")))
                .transition("win", "")
                .arc("ask", "win", one(v("i")))
                .arc("free", "win", dot())
                .arc("win", "own", one(v("i")))
                .arc("win", "listen", pair(v("i"), op("subtract", all("P"), v("i"))))
                .transition("hear", op("or", op("lessthan", v("i"), v("j")), op("greaterthan", v("i"), v("j"))))
                .arc("listen", "hear", pair(v("i"), v("j")))
                .arc("hear", "heard", one(v("j")))
                .transition("release", "")
                .arc("own", "release", one(v("i")))
                .arc("heard", "release", op("subtract", one(all("P")), one(v("i"))))
                .arc("release", "free", dot())
                .arc("release", "idle", one(v("i")));

        ReachabilityGraph space = explored(net);

        assertThat(space.states()).isEqualTo(56);
        assertThat(space.edges()).isEqualTo(132);
    }

    @Test
    void theLargestOfFourNumbersInARingIsElected() {
        String range = "<finiteintrange start='1' end='4'/>";
        String toNext = op("successor", v("i"));
        String arrived = pair(v("i"), v("m"));
        String known = pair(v("i"), v("k"));
        SymmetricNetText net = new SymmetricNetText()
                .sort("I", range)
                .product("II", "I", "I")
                .variables("I", "i", "m", "k")
                .place("start", "I", all("I"))
                .place("message", "II", "")
                .place("best", "II", "")
                .place("leader", "I", "")
                .transition("go", "")
                .arc("start", "go", one(v("i")))
                .arc("go", "message", pair(toNext, v("i")))
                .arc("go", "best", pair(v("i"), v("i")))
                .transition("pass", op("greaterthan", v("m"), v("k")))
                .arc("message", "pass", arrived)
                .arc("best", "pass", known)
                .arc("pass", "message", pair(toNext, v("m")))
                .arc("pass", "best", arrived)
                .transition("drop", op("lessthan", v("m"), v("k")))
                .arc("message", "drop", arrived)
                .arc("best", "drop", known)
                .arc("drop", "best", known)
                .transition(
                        "win",
                        op(
                                "and",
                                op("equality", v("i"), v("m")),
                                op(
                                        "greaterthanorequal",
                                        v("m"),
                                        "<finiteintrangeconstant value='1'>" + range + "</finiteintrangeconstant>")))
                .arc("message", "win", arrived)
                .arc("win", "leader", one(v("i")));

        ReachabilityGraph space = explored(net);

        assertThat(space.states()).isEqualTo(73);
        assertThat(space.edges()).isEqualTo(169);
    }
}
