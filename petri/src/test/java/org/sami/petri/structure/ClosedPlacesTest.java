package org.sami.petri.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

final class ClosedPlacesTest {
    private static final StructureLimits LIMITS = StructureLimits.USUAL;

    @Test
    void minimalSiphonsAndTrapsAreThoseOfAllSubsets() {
        int seen = 0;
        for (long seed = 0; seed < 3_000; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 7, 2);
            for (boolean siphon : new boolean[] {true, false}) {
                ClosedPlaces closed = siphon ? ClosedPlaces.siphons(net) : ClosedPlaces.traps(net);
                MinimalClosedSets.Result result = MinimalClosedSets.of(closed, LIMITS);
                List<BitSet> expected = minimalByTryingAll(net, siphon);
                assertThat(result.complete()).isTrue();
                assertThat(result.sets()).doesNotHaveDuplicates();
                assertThat(new HashSet<>(result.sets()))
                        .as("seed %d, siphons %s", seed, siphon)
                        .isEqualTo(new HashSet<>(expected));
                seen += expected.size();
            }
        }
        assertThat(seen).isGreaterThan(3_000);
    }

    @Test
    void theGreatestSubsetIsTheUnionOfAll() {
        for (long seed = 0; seed < 1_000; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 6, 2);
            BitSet allowed = BitSet.valueOf(new long[] {seed % (1L << net.placeCount())});
            BitSet union = new BitSet();
            for (BitSet set : closedByTryingAll(net, false)) {
                BitSet outside = (BitSet) set.clone();
                outside.andNot(allowed);
                if (outside.isEmpty()) {
                    union.or(set);
                }
            }
            assertThat(ClosedPlaces.traps(net).greatestWithin(allowed)).isEqualTo(union);
        }
    }

    @Test
    void emptySiphonsStayEmptyAndMarkedTrapsStayMarked() {
        for (long seed = 0; seed < 1_500; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 3);
            NaiveMarkings markings = new NaiveMarkings(net, 100);
            for (BitSet siphon :
                    MinimalClosedSets.of(ClosedPlaces.siphons(net), LIMITS).sets()) {
                if (siphon.stream().allMatch(place -> net.initial(place) == 0)) {
                    assertThat(markings.found())
                            .as("siphon %s of seed %d", siphon, seed)
                            .allMatch(marking -> siphon.stream().allMatch(place -> marking.get(place) == 0));
                }
            }
            for (BitSet trap :
                    MinimalClosedSets.of(ClosedPlaces.traps(net), LIMITS).sets()) {
                if (trap.stream().anyMatch(place -> net.initial(place) > 0)) {
                    assertThat(markings.found())
                            .as("trap %s of seed %d", trap, seed)
                            .allMatch(marking -> trap.stream().anyMatch(place -> marking.get(place) > 0));
                }
            }
        }
    }

    @Test
    void aNetWithMarkedTrapsInItsSiphonsNeverStops() {
        int proved = 0;
        for (long seed = 0; seed < 4_000; seed++) {
            PetriNet net = SeededNets.withResets(seed, 5, 1);
            SiphonTrapCheck.Result check = SiphonTrapCheck.check(net, LIMITS);
            if (check.holds()) {
                proved++;
                assertThat(new NaiveMarkings(net, 300).stops())
                        .as("seed %d", seed)
                        .isFalse();
            }
        }
        assertThat(proved).isGreaterThan(50);
    }

    @Test
    void whatTheCheckCannotJudgeItNames() {
        PetriNetBuilder inhibited = new PetriNetBuilder("inhibited");
        inhibited.place("a", 1);
        inhibited.move("stay", List.of("a"), List.of("a"));
        inhibited.inhibit(0, 0, 1);
        PetriNetBuilder weighted = new PetriNetBuilder("weighted");
        weighted.place("a", 1);
        int pair = weighted.transition("pair");
        weighted.consume(pair, 0, 2).produce(pair, 0, 2);
        PetriNetBuilder nothing = new PetriNetBuilder("nothing");
        nothing.place("a", 1);

        assertThat(SiphonTrapCheck.check(inhibited.build(), LIMITS).why()).isEqualTo("the net has inhibitor arcs");
        assertThat(SiphonTrapCheck.check(weighted.build(), LIMITS).why())
                .isEqualTo("a transition consumes several tokens of one place");
        assertThat(SiphonTrapCheck.check(nothing.build(), LIMITS).holds()).isFalse();
        assertThat(new NaiveMarkings(inhibited.build(), 5).stops()).isTrue();
        assertThat(new StructuralAnswers(inhibited.build(), LIMITS).neverStops())
                .isEmpty();
    }

    @Test
    void aSearchThatIsCutOffSaysSo() {
        PetriNet net = Philosophers.net(6);
        MinimalClosedSets.Result all = MinimalClosedSets.of(ClosedPlaces.siphons(net), LIMITS);
        MinimalClosedSets.Result few =
                MinimalClosedSets.of(ClosedPlaces.siphons(net), new StructureLimits(100, 5, 1, () -> false));

        assertThat(all.complete()).isTrue();
        assertThat(few.complete()).isFalse();
        assertThat(new HashSet<>(all.sets())).containsAll(few.sets());
        assertThat(SiphonTrapCheck.check(net, LIMITS).unmarked()).isPresent();
        assertThat(SiphonTrapCheck.check(net, new StructureLimits(100, 1, 1, () -> false))
                        .holds())
                .isFalse();
    }

    private static List<BitSet> minimalByTryingAll(PetriNet net, boolean siphon) {
        List<BitSet> closed = closedByTryingAll(net, siphon);
        closed.removeIf(BitSet::isEmpty);
        return closed.stream()
                .filter(set -> closed.stream().noneMatch(other -> {
                    BitSet rest = (BitSet) other.clone();
                    rest.andNot(set);
                    return rest.isEmpty() && other.cardinality() < set.cardinality();
                }))
                .toList();
    }

    private static List<BitSet> closedByTryingAll(PetriNet net, boolean siphon) {
        List<BitSet> closed = new ArrayList<>();
        for (long bits = 0; bits < 1L << net.placeCount(); bits++) {
            BitSet set = BitSet.valueOf(new long[] {bits});
            if (isClosed(net, set, siphon)) {
                closed.add(set);
            }
        }
        return closed;
    }

    private static boolean isClosed(PetriNet net, BitSet set, boolean siphon) {
        for (int t = 0; t < net.transitionCount(); t++) {
            int transition = t;
            boolean consumes = set.stream().anyMatch(p -> net.consumed().weight(transition, p) > 0);
            boolean empties = set.stream().anyMatch(p -> net.resets().weight(transition, p) > 0);
            boolean produces = set.stream().anyMatch(p -> net.produced().weight(transition, p) > 0);
            boolean broken = siphon ? produces && !consumes : (consumes || empties) && !produces;
            if (broken) {
                return false;
            }
        }
        return true;
    }
}
