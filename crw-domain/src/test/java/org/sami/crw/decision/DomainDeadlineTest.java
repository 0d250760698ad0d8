package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

/** Questions of the domain that autonomy answers after a time, as fronts show them. */
class DomainDeadlineTest {
    private static Decision asked(Optional<Answer> automatic, OptionalLong deadline) {
        return new Decision(
                1,
                Ids.NONE,
                Ids.NONE,
                "LongWay",
                "Send it?",
                new Question.Approve(),
                automatic,
                deadline,
                Priority.HIGH,
                List.of());
    }

    @Test
    void questionWithATimeCountsDownToItsAnswerUntilTheOperatorStopsIt() {
        Decision decision = asked(Optional.of(new Answer.YesNo(false)), OptionalLong.of(90_000));
        MixedInitiative counting = MixedInitiative.of(decision, "no");
        MixedInitiative stopped = MixedInitiative.of(decision.withoutDeadline(), "no");

        assertThat(counting.counts()).isTrue();
        assertThat(counting.phrase()).isEqualTo("answers no");
        assertThat(counting.remainingMillis(60_000)).hasValue(30_000);
        assertThat(counting.isHeld()).isFalse();
        assertThat(stopped.counts()).isFalse();
        assertThat(stopped.isHeld()).isTrue();
    }

    @Test
    void questionWithoutATimeWaits() {
        MixedInitiative waiting = MixedInitiative.of(asked(Optional.empty(), OptionalLong.empty()), "");

        assertThat(waiting.trigger()).isEqualTo(MixedInitiative.Trigger.NEVER);
        assertThat(waiting.isHeld()).isFalse();
    }
}
