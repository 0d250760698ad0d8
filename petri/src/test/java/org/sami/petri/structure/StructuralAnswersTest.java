package org.sami.petri.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.structure.StructuralProof.Method;

final class StructuralAnswersTest {
    private static final StructureLimits LIMITS = StructureLimits.USUAL;
    private static final StructureLimits FEW_PROGRAMS = new StructureLimits(5_000, 1_000, 12, () -> false);

    @Test
    void twentyBoatsAreNeverTwoInTheGate() {
        PetriNet net = gate(20);
        StructuralAnswers answers = new StructuralAnswers(net, LIMITS);

        Optional<StructuralProof> exclusive =
                answers.never(together(place(net, "boat3 in gate"), place(net, "boat17 in gate")));

        assertThat(exclusive.orElseThrow().method()).isEqualTo(Method.INVARIANT);
        assertThat(exclusive.get().words().get(0))
                .startsWith("gate free + boat1 in gate + boat2 in gate")
                .endsWith("+ boat20 in gate is always 1; the marking asked for needs 2");
        assertThat(answers.mostTokens(place(net, "boat5 in gate"))).hasValue(1);
        assertThat(answers.never(together(place(net, "boat3 at step 1"), place(net, "boat4 at step 1"))))
                .isEmpty();
        assertThat(answers.neverStops()).isEmpty(); // the boats arrive
    }

    @Test
    void boundsAreNeverBelowWhatIsReached() {
        int exact = 0;
        int bounded = 0;
        for (long seed = 0; seed < 700; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 3);
            NaiveMarkings markings = new NaiveMarkings(net, 400);
            StructuralAnswers answers = new StructuralAnswers(net, FEW_PROGRAMS);
            PlaceBounds bounds = new PlaceBounds(net);
            for (int place = 0; place < net.placeCount(); place++) {
                Optional<MarkingBound> program = bounds.byStateEquation(place);
                if (program.isPresent()) {
                    assertHolds(program.get(), markings, seed);
                    assertThat(program.get().mostTokens(place))
                            .as("p%d of seed %d", place, seed)
                            .isGreaterThanOrEqualTo(markings.most(place));
                    bounded++;
                    exact += program.get().mostTokens(place) == markings.most(place) ? 1 : 0;
                }
                Optional<MarkingBound> invariant = bounds.byInvariants(answers.invariants(), place);
                if (invariant.isPresent()) {
                    assertHolds(invariant.get(), markings, seed);
                    assertThat(invariant.get().constant()).isTrue();
                    assertThat(program).isPresent();
                    assertThat(program.get().mostTokens(place))
                            .isLessThanOrEqualTo(invariant.get().mostTokens(place));
                }
                if (program.isEmpty() && net.isPlain()) {
                    assertThat(answers.mostTokens(place)).isEmpty();
                }
            }
        }
        assertThat(bounded).isGreaterThan(500);
        assertThat(exact).isGreaterThan(bounded / 3);
    }

    @Test
    void whatIsRefutedIsNeverReached() {
        int refuted = 0;
        int cases = 0;
        for (long seed = 0; seed < 700; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 2);
            NaiveMarkings markings = new NaiveMarkings(net, 400);
            InvariantSet invariants = Invariants.ofPlaces(net, LIMITS);
            Random random = new Random(seed);
            for (int i = 0; i < 3; i++) {
                LinearCondition condition = condition(random, net.placeCount(), 2);
                Optional<Refutation> refutation = StateEquation.refute(net, condition, invariants, FEW_PROGRAMS);
                if (refutation.isPresent()) {
                    refuted++;
                    cases += refutation.get().words().size();
                    assertThat(refutation.get().isProof()).isTrue();
                    assertThat(markings.found())
                            .as("%s, seed %d", condition, seed)
                            .noneMatch(marking -> condition.holds(NaiveMarkings.array(marking)));
                    refutation.get().bounds().forEach(bound -> assertHolds(bound, markings, 0));
                }
            }
        }
        assertThat(refuted).isGreaterThan(150);
        assertThat(cases).isGreaterThan(refuted);
    }

    @Test
    void netsThatNeverStopHaveNoMarkingWithoutATransition() {
        int proved = 0;
        for (long seed = 0; seed < 1_200; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 5, 2);
            StructuralAnswers answers = new StructuralAnswers(net, FEW_PROGRAMS);
            NaiveMarkings markings = new NaiveMarkings(net, 300);
            if (answers.neverStops().isPresent()) {
                proved++;
                assertThat(markings.stops()).as("seed %d", seed).isFalse();
            }
            for (int t = 0; t < net.transitionCount(); t++) {
                int transition = t;
                if (answers.never(LinearCondition.enabled(net, transition)).isPresent()) {
                    assertThat(markings.found())
                            .as("t%d of seed %d", transition, seed)
                            .noneMatch(marking -> NaiveMarkings.enabled(net, marking, transition));
                }
            }
        }
        assertThat(proved).isGreaterThan(100);
    }

    @Test
    void conditionsAndTheirOppositesShareNoMarking() {
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            LinearCondition condition = condition(random, 3, 3);
            LinearCondition opposite = LinearCondition.opposite(condition);
            for (int[] marking : new int[][] {{0, 0, 0}, {1, 0, 2}, {0, 2, 1}, {3, 1, 0}, {2, 2, 2}}) {
                assertThat(opposite.holds(marking)).isNotEqualTo(condition.holds(marking));
            }
        }
    }

    /** A ring of three whose token the state equation alone would let vanish: it has a solution in which the ring is empty, and the trap has none. */
    @Test
    void aTrapProvesWhatTheEquationAloneDoesNot() {
        PetriNetBuilder builder = new PetriNetBuilder("trap");
        builder.place("a", 1);
        builder.place("b", 0);
        builder.place("c", 0);
        builder.move("split", List.of("a"), List.of("b", "c"));
        builder.move("join", List.of("b", "c"), List.of("b"));
        builder.move("lose", List.of("b", "c"), List.of("c"));
        PetriNet net = builder.build();
        LinearCondition empty = new LinearCondition.AllOf(
                List.of(LinearCondition.atMost(0, 0), LinearCondition.atMost(1, 0), LinearCondition.atMost(2, 0)));

        Optional<StructuralProof> proof = new StructuralAnswers(net, LIMITS).never(empty);

        assertThat(new NaiveMarkings(net, 50).found()).doesNotContain(List.of(0, 0, 0));
        assertThat(proof.orElseThrow().method()).isEqualTo(Method.STATE_EQUATION);
        assertThat(proof.get().words())
                .containsExactly("a + b + c never becomes 0 (a marked trap); the marking asked for contradicts itself");
    }

    /** Tokens come and go in pairs: an odd number would need half a firing. */
    @Test
    void wholeNumbersProveWhatFractionsDoNot() {
        PetriNetBuilder builder = new PetriNetBuilder("pairs");
        builder.place("a", 4);
        builder.place("b", 0);
        int take = builder.transition("take");
        builder.consume(take, 0, 2).produce(take, 1, 2);
        PetriNet net = builder.build();
        LinearCondition odd =
                new LinearCondition.AllOf(List.of(LinearCondition.atLeast(1, 1), LinearCondition.atMost(1, 1)));

        StructuralProof proof = new StructuralAnswers(net, LIMITS).never(odd).orElseThrow();

        assertThat(proof.words()).hasSize(2);
        assertThat(proof.words().get(0)).contains("where take fires at most 0 times");
        assertThat(proof.words().get(1)).contains("where take fires at least 1 times");
    }

    @Test
    void aFreeChoiceNetIsLiveWhereItsSiphonsKeepATrap() {
        PetriNetBuilder ring = new PetriNetBuilder("ring");
        ring.place("a", 1);
        ring.place("b", 0);
        ring.move("go", List.of("a"), List.of("b"));
        ring.move("back", List.of("b"), List.of("a"));

        StructuralProof live =
                new StructuralAnswers(ring.build(), LIMITS).isLive().orElseThrow();

        assertThat(live.words()).containsExactly("{a, b} is a siphon and a trap, marked at first");
        assertThat(new StructuralAnswers(Philosophers.net(3), LIMITS).isLive()).isEmpty();
        ring.inhibit(0, 1, 1);
        assertThat(new StructuralAnswers(ring.build(), LIMITS).isLive()).isEmpty();
    }

    @Test
    void placesThatGrowHaveNoBound() {
        PetriNetBuilder builder = new PetriNetBuilder("source");
        builder.place("made", 0);
        builder.move("make", List.of(), List.of("made"));

        assertThat(new StructuralAnswers(builder.build(), LIMITS).mostTokens(0)).isEqualTo(OptionalLong.empty());
        assertThat(new StructuralAnswers(builder.build(), LIMITS).neverStops())
                .hasValueSatisfying(proof -> assertThat(proof.words()).isEmpty());
    }

    /** Boats that go through one gate, one after the other: each has four places, and one place holds the free gate. */
    static PetriNet gate(int boats) {
        PetriNetBuilder net = new PetriNetBuilder("gate");
        net.place("gate free", 1);
        for (int i = 1; i <= boats; i++) {
            String boat = "boat" + i;
            net.place(boat + " at step 1", 1);
            net.place(boat + " waits", 0);
            net.place(boat + " in gate", 0);
            net.place(boat + " through", 0);
            net.move(boat + " comes", List.of(boat + " at step 1"), List.of(boat + " waits"));
            net.move(boat + " enters", List.of(boat + " waits", "gate free"), List.of(boat + " in gate"));
            net.move(boat + " leaves", List.of(boat + " in gate"), List.of(boat + " through", "gate free"));
        }
        return net.build();
    }

    private static LinearCondition together(int first, int second) {
        return new LinearCondition.AllOf(
                List.of(LinearCondition.atLeast(first, 1), LinearCondition.atLeast(second, 1)));
    }

    @Test
    void structureIsAskedUntilATime() {
        PetriNet net = Philosophers.net(3);
        long[] now = {0};
        StructureLimits limits = StructureLimits.USUAL.until(5_000_000, () -> now[0]);

        StructuralAnswers intime = new StructuralAnswers(net, limits);
        StructuralAnswers late = new StructuralAnswers(net, limits);

        assertThat(intime.bound(0)).isPresent();
        assertThat(limits.millisLeft().getAsLong()).isEqualTo(5);
        now[0] = 5_000_000;
        assertThat(late.bound(0)).isEmpty();
        assertThat(limits.cancelled().getAsBoolean()).isTrue();
        assertThat(limits.millisLeft().getAsLong()).isEqualTo(1);
    }

    private static int place(PetriNet net, String id) {
        return net.place(id).orElseThrow();
    }

    private static void assertHolds(MarkingBound bound, NaiveMarkings markings, long seed) {
        for (List<Integer> marking : markings.found()) {
            long sum = bound.weights().times(NaiveMarkings.array(marking));
            assertThat(bound.constant() ? sum == bound.most() : sum <= bound.most())
                    .as("%s in %s, seed %d", bound, marking, seed)
                    .isTrue();
        }
    }

    private static LinearCondition condition(Random random, int places, int depth) {
        int kind = depth == 0 ? 0 : random.nextInt(3);
        if (kind == 0) {
            int place = random.nextInt(places);
            return random.nextBoolean()
                    ? LinearCondition.atLeast(place, 1 + random.nextInt(4))
                    : LinearCondition.atMost(place, random.nextInt(3));
        }
        List<LinearCondition> parts =
                List.of(condition(random, places, depth - 1), condition(random, places, depth - 1));
        return kind == 1 ? new LinearCondition.AllOf(parts) : new LinearCondition.OneOf(parts);
    }
}
