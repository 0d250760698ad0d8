package org.sami.crw.sim.run.incident;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.session.SessionOperator.Asked;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

/** What the operator does in the background, and when an incident is noticed (thesis 8.1). */
class BackgroundWorkTest {
    private static final String WORK = "OperatorBackgroundAction";
    private static final String PLAN = "background-actions";

    private final BackgroundWork work = new BackgroundWork(new BackgroundActions(PLAN, "scan"));

    private long asked(long id, String place, long atMillis) {
        work.onStep(
                id,
                atMillis,
                new Input.TimeReached(),
                List.of(new Effect.Activated(new Activation(
                        id,
                        1,
                        1,
                        id,
                        PLAN,
                        place,
                        "do-" + place,
                        WORK,
                        Map.of(),
                        Map.of(),
                        List.of(),
                        Map.of(),
                        List.of(),
                        Priority.LOW))),
                null);
        return work.waitMillis(asked(id, PLAN, 30_000, atMillis));
    }

    private static Asked asked(long id, String plan, long workMillis, long atMillis) {
        return new Asked(
                DecisionPresenter.plain(new Decision(
                        id,
                        1,
                        id,
                        WORK,
                        "",
                        new Question.Approve(),
                        Optional.empty(),
                        OptionalLong.empty(),
                        Priority.LOW,
                        List.of())),
                plan,
                workMillis,
                atMillis);
    }

    @Test
    void actionsAreDoneOneAfterAnotherInTheOrderInWhichTheyWereAskedFor() {
        assertThat(asked(1, "scan", 1000)).isZero();
        assertThat(asked(2, "check", 1000)).isEqualTo(30_000);
        assertThat(asked(3, "scan", 31_000)).isEqualTo(30_000);
    }

    @Test
    void incidentIsNoticedOnlyWhileTheOperatorScans() {
        asked(1, "check", 0);
        asked(2, "scan", 0);
        asked(3, "check", 30_000);

        assertThat(work.isNoticing(29_999)).isFalse();
        assertThat(work.isNoticing(30_000)).isTrue();
        assertThat(work.isNoticing(59_999)).isTrue();
        assertThat(work.isNoticing(60_000)).isFalse();
    }

    @Test
    void questionsOfOtherPlansDoNotWait() {
        asked(1, "check", 0);

        assertThat(work.waitMillis(asked(2, "clv", 0, 0))).isZero();
    }

    @Test
    void operatorWithoutBackgroundActionsNoticesAtOnce() {
        assertThat(new BackgroundWork(BackgroundActions.NONE).isNoticing(0)).isTrue();
    }
}
