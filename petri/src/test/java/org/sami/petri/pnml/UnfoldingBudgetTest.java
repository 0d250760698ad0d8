package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.petri.pnml.SymmetricNetText.all;
import static org.sami.petri.pnml.SymmetricNetText.op;
import static org.sami.petri.pnml.SymmetricNetText.v;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A symmetric net that would unfold to too much is refused with the line, before it is built. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class UnfoldingBudgetTest {
    private static final int VARIABLES = 6;
    private static final List<String> NAMES = List.of("a", "b", "c", "d", "e", "f");

    /** A transition that moves six tokens of 100 colours under a condition. */
    private static PnmlReading moving(String condition) {
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("cyclicenumeration", "P", 100)
                .variables("P", NAMES.toArray(String[]::new))
                .place("here", "P", all("P"))
                .transition("move", condition);
        NAMES.forEach(name -> net.arc("here", "move", v(name)).arc("move", "here", v(name)));
        return net.read();
    }

    private static void assertRefused(PnmlReading reading, String words) {
        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings()).anySatisfy(finding -> {
            assertThat(finding.code()).isEqualTo("E-SIZE");
            assertThat(finding.line()).isPositive();
            assertThat(finding.toString()).contains(words);
        });
    }

    @Test
    void tooManyChoicesWithoutACondition() {
        assertRefused(moving(""), "more than 8000000 arcs");
    }

    @Test
    void tooManyChoicesOfRisingColours() {
        List<String> rising = new ArrayList<>();
        for (int i = 1; i < VARIABLES; i++) {
            rising.add(op("lessthan", v(NAMES.get(i - 1)), v(NAMES.get(i))));
        }

        assertRefused(moving(op("and", rising.toArray(String[]::new))), "more than 8000000 arcs");
    }

    @Test
    void tooManyTriedThoughNoneFits() {
        List<String> parts = new ArrayList<>();
        for (String name : List.of("b", "c", "d", "e")) { // these get their colours before the two that contradict
            parts.add(op("equality", v(name), v(name)));
        }
        parts.add(op("equality", v("a"), v("f")));
        parts.add(op("inequality", v("f"), v("a")));

        assertRefused(moving(op("and", parts.toArray(String[]::new))), "choices were tried");
    }

    @Test
    void comparisonsOfMultisetsCountAsManyTries() {
        String sum = op("add", v("a"), v("f"));
        String other = op("add", v("a"), op("successor", v("f")));

        assertRefused(
                moving(op(
                        "and",
                        op("equality", v("b"), v("b")),
                        op("equality", v("c"), v("c")),
                        op("equality", sum, other))),
                "choices were tried");
    }

    @Test
    void allColoursForEachColour() {
        SymmetricNetText net = new SymmetricNetText()
                .sort("R", "<finiteintrange start='0' end='3000'/>")
                .variables("R", "x")
                .place("here", "R", all("R"))
                .transition("spread", "")
                .arc("here", "spread", v("x"))
                .arc("spread", "here", op("subtract", all("R"), v("x")));

        assertRefused(net.read(), "more than 8000000 arcs");
    }

    @Test
    void placesThatAreTooManyTogether() {
        SymmetricNetText net = new SymmetricNetText().sort("R", "<finiteintrange start='0' end='1000000'/>");

        assertRefused(net.place("one", "R", "").place("two", "R", "").read(), "more than 2000000 nodes");
    }

    @Test
    void termsThatTakeEachOthersColoursAwayAreNotCountedAsArcs() {
        SymmetricNetText net = new SymmetricNetText()
                .sort("R", "<finiteintrange start='0' end='3000'/>")
                .variables("R", "x")
                .place("here", "R", all("R"))
                .transition("move", "")
                .arc("here", "move", op("add", v("x"), op("subtract", all("R"), all("R"))))
                .arc("move", "here", op("subtract", op("add", all("R"), v("x")), all("R")));

        assertThat(net.read().net().orElseThrow().transitionCount()).isEqualTo(3001);
    }
}
