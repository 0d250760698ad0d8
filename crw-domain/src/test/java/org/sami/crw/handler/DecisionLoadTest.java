package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;

/** A thousand decisions in ten seconds, while the operator answers, holds and aborts, and autonomy's timers run out. */
class DecisionLoadTest {
    private static final int DECISIONS = 1000;
    private static final long TIMEOUT_MS = 2000;
    private static final List<Priority> RANKS = List.of(Priority.values());

    private final Engine engine = new Engine(TestWorld.VOCABULARY, plans().project());
    private final EngineState state = engine.newState();
    private final OperatorModels models = new OperatorModels(Runnable::run);
    private final Random random = new Random(7);
    private final Map<Long, Decision> opened = new HashMap<>();
    private final Map<Long, Long> openedAt = new HashMap<>();
    private final Set<Long> closed = new HashSet<>();
    private final Set<Long> held = new HashSet<>();
    private int byAutonomy;
    private long steps;

    /** One plan for each rank; each asks with a timer. */
    private static PlanSketch plans() {
        PlanSketch plans = new PlanSketch();
        for (Priority rank : RANKS) {
            plans.plan(rank.name())
                    .asks("asking", "OperatorApprove", "question", new TextValue("Go on?"))
                    .marked("Priority", "rank", rank.name())
                    .marked("MixedInitiativeTrigger", "trigger", "TIMER", "timeout", new DurationValue(TIMEOUT_MS))
                    .on("asking", "YesOption", "done")
                    .end("done");
        }
        return plans;
    }

    @Test
    void noneIsLostTheCriticalComeFirstAndTimersAreExact() {
        for (int i = 0; i < DECISIONS; i++) {
            long now = 10L * i;
            letTimersRunUntil(now);
            Priority rank = RANKS.get(random.nextInt(RANKS.size()));
            step(now, new Input.StartMission(rank.name(), "m" + i, Map.of()));
            act(now);
            assertInOrder();
        }
        letTimersRunUntil(10L * DECISIONS + TIMEOUT_MS);

        assertThat(opened).hasSize(DECISIONS);
        Set<Long> waiting = new HashSet<>();
        models.decisions()
                .pending()
                .forEach(pending -> waiting.add(pending.decision().id()));
        assertThat(held).as("who waits at the end was held").containsAll(waiting);
        assertThat(closed).as("nothing is lost").hasSize(DECISIONS - waiting.size());
        assertThat(byAutonomy).isGreaterThan(100);
        assertThat(held).hasSizeGreaterThan(20);
    }

    private void letTimersRunUntil(long now) {
        while (engine.view(state).nextDueMillis().orElse(Long.MAX_VALUE) <= now) {
            step(engine.view(state).nextDueMillis().getAsLong(), new Input.TimeReached());
        }
    }

    /** The operator does something, mostly with what stands on top, sometimes in the moment in which a timer runs out. */
    private void act(long now) {
        List<PendingDecision> pending = models.decisions().pending();
        if (pending.isEmpty()) {
            return;
        }
        PendingDecision any = pending.get(random.nextInt(pending.size()));
        switch (random.nextInt(10)) {
            case 0, 1, 2 ->
                step(
                        now,
                        new Input.AnswerDecision(
                                pending.get(0).decision().id(), new Answer.YesNo(true), Answerer.OPERATOR));
            case 3 -> step(now, new Input.AbortMission(any.decision().mission()));
            case 4 -> {
                if (any.presentation().autonomy().counts()) {
                    step(now, new Input.HoldDecision(any.decision().id()));
                }
            }
            default -> {}
        }
    }

    private void assertInOrder() {
        List<PendingDecision> pending = models.decisions().pending();
        for (int i = 1; i < pending.size(); i++) {
            PendingDecision before = pending.get(i - 1);
            PendingDecision after = pending.get(i);
            int rank = before.decision().priority().compareTo(after.decision().priority());
            assertThat(rank > 0 || (rank == 0 && before.openedAtMillis() <= after.openedAtMillis()))
                    .as("%s before %s", before.decision(), after.decision())
                    .isTrue();
        }
    }

    private void step(long now, Input input) {
        List<Effect> effects = new ArrayList<>();
        engine.step(state, now, input, effects::add);
        models.onStep(++steps, now, input, effects, engine.view(state));
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened e) {
                opened.put(e.decision().id(), e.decision());
                openedAt.put(e.decision().id(), now);
            } else if (effect instanceof Effect.DecisionHeld e) {
                held.add(e.decision());
            } else if (effect instanceof Effect.DecisionClosed e) {
                assertThat(closed.add(e.decision())).as("closed once").isTrue();
                if (e.by().equals(Optional.of(Answerer.AUTONOMY))) {
                    byAutonomy++;
                    assertThat(now).isEqualTo(openedAt.get(e.decision()) + TIMEOUT_MS);
                    assertThat(held).doesNotContain(e.decision());
                }
            }
        }
    }
}
