package org.sami.petri.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.structure.LinearCondition.AtLeast;

/** What a solver suggests is a proof only if its numbers are. */
final class RefutedCaseTest {
    private final PetriNet net = ring();
    private final Incidence incidence = Incidence.of(net);

    @Test
    void theSumMustStayBelowWhatIsNeeded() {
        // a + b is always 2
        assertThat(isProof(3, List.of(), 1, 0, 1)).isTrue();
        assertThat(isProof(2, List.of(), 1, 0, 1)).isFalse();
        assertThat(isProof(3, List.of(), 2, 0, 2)).isTrue();
    }

    @Test
    void theSumMustNotGrow() {
        assertThat(isProof(3, List.of(), 1, 0, 0)).isFalse(); // a alone grows
        assertThat(isProof(3, List.of(), 1, 0, 2)).isFalse(); // so does a + 2 b
    }

    @Test
    void noFactorIsNegative() {
        assertThat(isProof(3, List.of(), 1, -1, 2)).isFalse();
    }

    @Test
    void limitsOfFiringsCount() {
        FiringLimit never = new FiringLimit(1, false, 0);
        FiringLimit once = new FiringLimit(1, false, 1);

        // a grows by "back" only: as often as it fires
        assertThat(isProof(3, List.of(never), 1, 0, 0, 1)).isTrue();
        assertThat(isProof(3, List.of(once), 1, 0, 0, 1)).isFalse();
        assertThat(isProof(4, List.of(once), 1, 0, 0, 1)).isTrue();
        assertThat(isProof(3, List.of(new FiringLimit(1, true, 0)), 1, 0, 0, 1)).isFalse();
    }

    /** Whether factors of the condition "a has so many", of the places a and b, and of the limits prove that it never holds. */
    private boolean isProof(long tokens, List<FiringLimit> limits, long... factors) {
        AtLeast condition = LinearCondition.atLeast(0, tokens);
        return new RefutedCase(List.of(condition), List.of(), limits, IntegerVector.of(factors))
                .isProof(net, incidence);
    }

    private static PetriNet ring() {
        PetriNetBuilder net = new PetriNetBuilder("ring");
        net.place("a", 2);
        net.place("b", 0);
        net.move("go", List.of("a"), List.of("b"));
        net.move("back", List.of("b"), List.of("a"));
        return net.build();
    }
}
