package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.petri.pnml.SymmetricNetText.all;
import static org.sami.petri.pnml.SymmetricNetText.colour;
import static org.sami.petri.pnml.SymmetricNetText.op;
import static org.sami.petri.pnml.SymmetricNetText.v;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.petri.net.PetriNet;

/** Truth values are colours, and a variable of them is a condition. */
class BooleanColoursTest {
    private static final String TRUE = "<booleanconstant value='true'/>";
    private static final String FALSE = "<booleanconstant value='false'/>";

    private static SymmetricNetText lamp(String condition) {
        return new SymmetricNetText()
                .sort("B", "<bool/>")
                .variables("B", "b", "c")
                .place("lamp", "B", TRUE)
                .transition("switch", condition)
                .arc("lamp", "switch", v("b"))
                .arc("switch", "lamp", v("c"));
    }

    @Test
    void aPlaceHasATrueAndAFalseColour() {
        PetriNet net = lamp("").read().net().orElseThrow();

        assertThat(net.place("lamp(false)")).isPresent();
        assertThat(net.place("lamp(true)")).isPresent();
        assertThat(net.initialMarking()[net.place("lamp(true)").getAsInt()]).isEqualTo(1);
        assertThat(net.initialMarking()[net.place("lamp(false)").getAsInt()]).isZero();
        assertThat(net.transitionCount()).isEqualTo(4);
    }

    @Test
    void aVariableIsACondition() {
        PetriNet net = lamp(op("and", v("b"), op("not", v("c")))).read().net().orElseThrow();

        assertThat(net.transitionCount()).isOne();
        assertThat(net.transition("switch(b=true,c=false)")).isPresent();
    }

    @Test
    void aVariableIsComparedWithATruthValue() {
        PetriNet net = lamp(op("equality", v("b"), FALSE)).read().net().orElseThrow();

        assertThat(net.transitionCount()).isEqualTo(2);
        assertThat(net.transition("switch(b=true,c=true)")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"true, 2", "false, 1"})
    void aMultisetContainsAnother(boolean isWhole, int choices) {
        String whole = op("subtract", all("P"), colour("P0"));
        String condition = op("contains", isWhole ? whole : colour("P2"), v("x"));
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("cyclicenumeration", "P", 3)
                .variables("P", "x")
                .place("here", "P", all("P"))
                .transition("go", condition)
                .arc("here", "go", v("x"));

        assertThat(net.read().net().orElseThrow().transitionCount()).isEqualTo(choices);
    }

    @Test
    void aConditionThatIsAColourIsRefused() {
        SymmetricNetText net = new SymmetricNetText()
                .enumeration("finiteenumeration", "P", 2)
                .variables("P", "x")
                .place("here", "P", all("P"))
                .transition("go", v("x"))
                .arc("here", "go", v("x"));

        assertThat(net.read().findings())
                .anySatisfy(finding -> assertThat(finding.toString()).contains("x is neither true nor false"));
    }
}
