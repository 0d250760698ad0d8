package org.sami.petri.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

final class InvariantsTest {
    private static final StructureLimits LIMITS = StructureLimits.USUAL;

    @Test
    void weightsFollowTheArcs() {
        PetriNetBuilder builder = new PetriNetBuilder("packing");
        builder.place("loose", 6);
        builder.place("packed", 0);
        int pack = builder.transition("pack");
        builder.consume(pack, 0, 2).produce(pack, 1, 1);
        int open = builder.transition("open");
        builder.consume(open, 1, 1).produce(open, 0, 2);
        PetriNet net = builder.build();

        InvariantSet places = Invariants.ofPlaces(net, LIMITS);
        InvariantSet transitions = Invariants.ofTransitions(net, LIMITS);

        assertThat(places.complete()).isTrue();
        assertThat(places.invariants()).containsExactly(IntegerVector.of(new long[] {1, 2}));
        assertThat(transitions.invariants()).containsExactly(IntegerVector.of(new long[] {1, 1}));
        assertThat(new StructuralAnswers(net, LIMITS).bound(1).orElseThrow().words(net))
                .isEqualTo("loose + 2 packed is always 6");
    }

    @Test
    void invariantsAreConstantInAllMarkings() {
        int seen = 0;
        for (long seed = 0; seed < 3_000; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 3);
            List<IntegerVector> all =
                    new ArrayList<>(Invariants.ofPlaces(net, LIMITS).invariants());
            all.addAll(Invariants.basisOfPlaces(net, LIMITS).orElseThrow());
            seen += all.size();
            NaiveMarkings markings = new NaiveMarkings(net, 200);
            for (IntegerVector invariant : all) {
                long sum = invariant.times(net.initialMarking());
                for (List<Integer> marking : markings.found()) {
                    assertThat(invariant.times(NaiveMarkings.array(marking)))
                            .as("%s in %s of seed %d", invariant, marking, seed)
                            .isEqualTo(sum);
                }
            }
        }
        assertThat(seen).isGreaterThan(1_000);
    }

    @Test
    void theMinimalOnesAreThoseOfAllSmallVectors() {
        int seen = 0;
        for (long seed = 0; seed < 1_500; seed++) {
            PetriNet net = SeededNets.plain(seed, 4, 2);
            InvariantSet places = Invariants.ofPlaces(net, LIMITS);
            assertThat(places.complete()).isTrue();
            Set<IntegerVector> expected = minimal(net, 6);
            Set<IntegerVector> small = new HashSet<>(places.invariants());
            small.removeIf(invariant -> largest(invariant) > 6);
            assertThat(small).as("seed %d", seed).isEqualTo(expected);
            assertThat(places.invariants()).doesNotHaveDuplicates();
            seen += expected.size();
        }
        assertThat(seen).isGreaterThan(500);
    }

    @Test
    void noInvariantContainsAnother() {
        int seen = 0;
        for (long seed = 0; seed < 400; seed++) {
            PetriNet net = synchronizations(new Random(seed), 9, 6);
            InvariantSet places = Invariants.ofPlaces(net, LIMITS);
            assertThat(places.complete()).isTrue();
            for (IntegerVector one : places.invariants()) {
                seen++;
                assertThat(places.invariants()).as("%s of seed %d", one, seed).noneMatch(other -> within(other, one));
            }
        }
        assertThat(seen).isGreaterThan(500);
    }

    @Test
    void theBasisMissesNoWholeVector() {
        for (long seed = 0; seed < 1_000; seed++) {
            PetriNet net = SeededNets.plain(seed, 4, 3);
            List<IntegerVector> basis = Invariants.basisOfPlaces(net, LIMITS).orElseThrow();
            long shared = 0;
            for (BitSet columns : subsets(net.placeCount(), basis.size())) {
                shared = IntegerVector.gcd(shared, determinant(minor(basis, columns)));
            }
            // its determinants share no divisor: no vector lies between its whole sums
            assertThat(shared).as("seed %d: %s", seed, basis).isEqualTo(1);
            assertThat(basis).hasSize(net.placeCount() - rank(net));
        }
    }

    @Test
    void firingsOfATransitionInvariantChangeNothing() {
        int seen = 0;
        for (long seed = 0; seed < 2_000; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 3);
            for (IntegerVector counts : Invariants.ofTransitions(net, LIMITS).invariants()) {
                seen++;
                for (int place = 0; place < net.placeCount(); place++) {
                    long change = 0;
                    for (int transition = 0; transition < net.transitionCount(); transition++) {
                        int each = effect(net, transition, place);
                        change += counts.get(transition) * each;
                        assertThat(counts.get(transition) == 0 || net.resets().isEmpty(transition))
                                .isTrue();
                    }
                    assertThat(change).as("seed %d", seed).isZero();
                }
            }
        }
        assertThat(seen).isGreaterThan(100);
    }

    @Test
    void aPlaceThatIsResetIsInNoInvariantAndInhibitorsDoNotMatter() {
        assertThat(Invariants.ofPlaces(ring(false, false), LIMITS).invariants()).hasSize(1);
        assertThat(Invariants.ofPlaces(ring(true, false), LIMITS).invariants()).hasSize(1);
        assertThat(Invariants.ofPlaces(ring(true, true), LIMITS).invariants()).isEmpty();
        // the sum can only become smaller, so the bound stays
        assertThat(new StructuralAnswers(ring(true, true), LIMITS)
                        .bound(0)
                        .orElseThrow()
                        .words(ring(true, true)))
                .isEqualTo("a + b is never more than 2");
    }

    @Test
    void whatDoesNotFitIsLeftOutAndSaid() {
        PetriNetBuilder builder = new PetriNetBuilder("many ways");
        for (int stage = 0; stage < 8; stage++) {
            for (int way = 0; way < 2; way++) {
                builder.place("s" + stage + "w" + way, stage == 0 ? 1 : 0);
            }
        }
        for (int stage = 0; stage < 7; stage++) {
            int move = builder.transition("t" + stage);
            for (int way = 0; way < 2; way++) {
                builder.consume(move, 2 * stage + way, 1).produce(move, 2 * stage + 2 + way, 1);
            }
        }
        PetriNet net = builder.build();

        InvariantSet all = Invariants.ofPlaces(net, LIMITS);
        InvariantSet few = Invariants.ofPlaces(net, new StructureLimits(20, 1, 1, () -> false));
        InvariantSet none = Invariants.ofPlaces(net, LIMITS.withCancel(() -> true));

        assertThat(all.complete()).isTrue();
        assertThat(all.invariants()).hasSize(256);
        assertThat(few.complete()).isFalse();
        assertThat(all.invariants()).containsAll(few.invariants());
        assertThat(few.invariants()).isNotEmpty();
        assertThat(none.complete()).isFalse();
        assertThat(Invariants.basisOfPlaces(net, LIMITS.withCancel(() -> true))).isEmpty();
    }

    /** Each transition takes two or three tokens and gives as many back. */
    private static PetriNet synchronizations(Random random, int places, int transitions) {
        PetriNetBuilder net = new PetriNetBuilder("synchronizations");
        for (int place = 0; place < places; place++) {
            net.place("p" + place, 1);
        }
        for (int transition = 0; transition < transitions; transition++) {
            net.transition("t" + transition);
            for (int i = 2 + random.nextInt(2); i > 0; i--) {
                net.consume(transition, random.nextInt(places), 1).produce(transition, random.nextInt(places), 1);
            }
        }
        return net.build();
    }

    private static PetriNet ring(boolean inhibited, boolean reset) {
        PetriNetBuilder net = new PetriNetBuilder("ring");
        net.place("a", 2);
        net.place("b", 0);
        net.move("go", List.of("a"), List.of("b"));
        net.move("back", List.of("b"), List.of("a"));
        if (inhibited) {
            net.inhibit(0, 1, 2);
        }
        if (reset) {
            net.reset(1, 1);
        }
        return net.build();
    }

    /** By trying all vectors up to a number. */
    private static Set<IntegerVector> minimal(PetriNet net, int most) {
        List<long[]> solutions = new ArrayList<>();
        long[] vector = new long[net.placeCount()];
        int place = 0;
        while (place < vector.length) {
            if (isInvariant(net, vector)) {
                solutions.add(vector.clone());
            }
            place = 0;
            while (place < vector.length && ++vector[place] > most) {
                vector[place++] = 0;
            }
        }
        Set<IntegerVector> minimal = new HashSet<>();
        for (long[] solution : solutions) {
            IntegerVector one = IntegerVector.of(solution);
            boolean smallest = solutions.stream().map(IntegerVector::of).noneMatch(other -> within(other, one));
            if (!one.isZero() && smallest) {
                minimal.add(one.dividedBy(one.greatestDivisor()));
            }
        }
        return minimal;
    }

    private static boolean within(IntegerVector small, IntegerVector large) {
        BitSet rest = small.support();
        rest.andNot(large.support());
        return !small.isZero() && rest.isEmpty() && small.size() < large.size();
    }

    private static boolean isInvariant(PetriNet net, long[] weights) {
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            long change = 0;
            for (int place = 0; place < weights.length; place++) {
                change += weights[place] * effect(net, transition, place);
            }
            if (change != 0) {
                return false;
            }
        }
        return true;
    }

    private static int effect(PetriNet net, int transition, int place) {
        return net.produced().weight(transition, place) - net.consumed().weight(transition, place);
    }

    private static long largest(IntegerVector vector) {
        long largest = 0;
        for (int i = 0; i < vector.size(); i++) {
            largest = Math.max(largest, vector.valueAt(i));
        }
        return largest;
    }

    private static List<BitSet> subsets(int of, int size) {
        List<BitSet> subsets = new ArrayList<>();
        for (long bits = 0; bits < 1L << of; bits++) {
            if (Long.bitCount(bits) == size) {
                subsets.add(BitSet.valueOf(new long[] {bits}));
            }
        }
        return subsets;
    }

    private static long[][] minor(List<IntegerVector> rows, BitSet columns) {
        return rows.stream()
                .map(row -> columns.stream().mapToLong(row::get).toArray())
                .toArray(long[][]::new);
    }

    private static long determinant(long[][] matrix) {
        if (matrix.length == 0) {
            return 1;
        }
        long sum = 0;
        for (int column = 0; column < matrix.length; column++) {
            int left = column;
            long[][] rest = new long[matrix.length - 1][];
            for (int row = 1; row < matrix.length; row++) {
                long[] kept = new long[matrix.length - 1];
                for (int i = 0, at = 0; i < matrix.length; i++) {
                    if (i != left) {
                        kept[at++] = matrix[row][i];
                    }
                }
                rest[row - 1] = kept;
            }
            sum += (column % 2 == 0 ? 1 : -1) * matrix[0][column] * determinant(rest);
        }
        return sum;
    }

    private static int rank(PetriNet net) {
        for (int size = Math.min(net.placeCount(), net.transitionCount()); size > 0; size--) {
            for (BitSet rows : subsets(net.placeCount(), size)) {
                for (BitSet columns : subsets(net.transitionCount(), size)) {
                    long[][] square = rows.stream()
                            .mapToObj(place -> columns.stream()
                                    .mapToLong(transition -> effect(net, transition, place))
                                    .toArray())
                            .toArray(long[][]::new);
                    if (determinant(square) != 0) {
                        return size;
                    }
                }
            }
        }
        return 0;
    }

    @Test
    void netsOfTooManyPlacesHaveNoCompleteSetOfInvariants() {
        PetriNetBuilder net = new PetriNetBuilder("many");
        for (int place = 0; place <= 30_000; place++) {
            net.place("p" + place, 1);
        }
        net.transition("t");

        InvariantSet found = Invariants.ofPlaces(net.build(), StructureLimits.USUAL);

        assertThat(found.invariants()).isEmpty();
        assertThat(found.complete()).isFalse();
    }
}
