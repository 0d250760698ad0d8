package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TestVocabulary;

/**
 * What the engine does, the nets of plans can do: random sessions on random plans, each firing held to the net. More seeds: {@code ./gradlew :spn-core:longTest --tests
 * '*PlanNetDifferentialTest' -Pseeds=20000}.
 */
@Tag("long")
class PlanNetDifferentialTest {
    private static final long FIRST_SEED = Long.getLong("spn.firstSeed", 1);
    private static final long SEEDS = Long.getLong("spn.seeds", 1000);
    private static final int MOST_TRANSITIONS = 400;
    private static final int LENGTH = 50;

    @Test
    void netsOfRandomPlansDoWhatTheEngineDoes() {
        AtomicLong firings = new AtomicLong();
        AtomicLong sessions = new AtomicLong();

        List<String> differences = LongStream.range(FIRST_SEED, FIRST_SEED + SEEDS)
                .parallel()
                .mapToObj(seed -> difference(seed, firings, sessions))
                .flatMap(Optional::stream)
                .limit(5)
                .toList();

        assertThat(differences).isEmpty();
        assertThat(firings.get()).isGreaterThan(SEEDS * 3);
    }

    /**
     * Rare cases: an end that takes those who are named of a token that stands several times, a task that only its robot's name speaks of, a robot that is asked for by
     * number and that a sub-mission holds, a robot that joins twice.
     */
    @ParameterizedTest
    @ValueSource(longs = {4967, 5245, 9565, 12516, 13385, 16439, 18354})
    void seedsThatDifferedBeforeDoNotDiffer(long seed) {
        assertThat(difference(seed, new AtomicLong(), new AtomicLong())).isEmpty();
        assertThat(difference(seed, 2, new AtomicLong(), new AtomicLong())).isEmpty();
    }

    @Test
    void netsThatFollowSubMissionsDoWhatTheEngineDoes() {
        AtomicLong firings = new AtomicLong();
        AtomicLong sessions = new AtomicLong();

        List<String> differences = LongStream.range(FIRST_SEED, FIRST_SEED + SEEDS)
                .parallel()
                .mapToObj(seed -> difference(seed, 2, firings, sessions))
                .flatMap(Optional::stream)
                .limit(5)
                .toList();

        assertThat(differences).isEmpty();
        assertThat(firings.get()).isGreaterThan(SEEDS * 3);
    }

    /** What the engine did in a seed's session and the net cannot do; empty where it can do all. */
    static Optional<String> difference(long seed, AtomicLong firings, AtomicLong sessions) {
        return difference(seed, 0, firings, sessions);
    }

    /** The same where so many levels of sub-missions are followed. */
    static Optional<String> difference(long seed, int depth, AtomicLong firings, AtomicLong sessions) {
        Project project = RandomPlans.project(seed);
        RandomInputs world = new RandomInputs(project, seed);
        Subject engine = new EngineSubject(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
        Set<String> joined = new LinkedHashSet<>(); // a robot that joins again is the one that is there
        FollowedNet followed = null;
        for (int i = 0; i < LENGTH; i++) {
            Scenario.Timed timed = world.next(engine);
            Input input = timed.input();
            boolean starts =
                    input instanceof Input.StartMission start && start.plan().equals("main");
            if (starts && followed == null) {
                Optional<PlanNet> net = net(project, List.copyOf(joined), depth);
                if (net.isEmpty()) {
                    return Optional.empty();
                }
                followed = new FollowedNet(net.get(), 1);
            } else if (input instanceof Input.ProxyJoined join && followed == null) {
                joined.add(join.proxy());
            } else if (isLeftOut(input) || starts || (depth > 0 && followed != null && endsAChild(followed, input))) {
                continue;
            }
            List<Effect> effects = engine.step(timed.nowMillis(), input);
            world.saw(effects);
            for (Effect effect : effects) {
                if (followed != null) {
                    String difference = followed.saw(effect);
                    if (!difference.isEmpty()) {
                        return Optional.of("seed " + seed + ", input " + i + " " + input + ": " + difference);
                    }
                }
            }
            if (followed != null) {
                String difference = followed.settle();
                if (!difference.isEmpty()) {
                    return Optional.of("seed " + seed + ", input " + i + " " + input + ": " + difference);
                }
            }
        }
        if (followed != null) {
            firings.addAndGet(followed.firings());
            sessions.incrementAndGet();
        }
        return Optional.empty();
    }

    private static Optional<PlanNet> net(Project project, List<String> robots, int depth) {
        try {
            PlanNet net = PlanNet.of(new PlanNetRequest(
                    project, TestVocabulary.TEST, "main", robots, 2, MOST_TRANSITIONS * (1 + depth), depth));
            boolean isPartial = net.abstractions().stream().anyMatch(a -> a.kind() == Abstraction.Kind.PARTIAL);
            return isPartial ? Optional.empty() : Optional.of(net);
        } catch (PlanNetTooLargeException e) {
            return Optional.empty();
        }
    }

    /** Nobody aborts or completes a sub-mission that is followed. */
    private static boolean endsAChild(FollowedNet followed, Input input) {
        return (input instanceof Input.AbortMission abort && followed.isChild(abort.mission()))
                || (input instanceof Input.CompleteMission complete && followed.isChild(complete.mission()));
    }

    /** The team stays as it is, tasks are those of the plan, news is what may be news. */
    private static boolean isLeftOut(Input input) {
        return input instanceof Input.ProxyJoined
                || input instanceof Input.ProxyDropped
                || input instanceof Input.AddTasks
                || (input instanceof Input.Received received
                        && received.occurrence().activation() == Ids.NONE);
    }
}
