package org.sami.spn.stepping;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;

/** Who acts next where a plan runs on by itself. */
class TurnsTest {
    private static final int MOST = 100;
    private static final Map<String, FieldSource> A_SECOND =
            Map.of("duration", new FieldSource.Fixed(new DurationValue(1000)));

    private final List<String> remarks = new ArrayList<>();

    private static Stepper start(Plan plan) {
        return Stepper.start(
                new Engine(TestVocabulary.TEST, NetBuilder.project(plan)), plan.id(), plan.id(), List.of("A", "B"));
    }

    /** Runs on; what was remarked is kept. */
    private int run(Stepper stepper, boolean operator, boolean robots) {
        int steps = 0;
        while (steps < MOST && stepper.outcome().isEmpty()) {
            Turns.Turn turn = Turns.next(stepper, NextSteps.LOCATIONS, operator, robots);
            if (!turn.remark().isEmpty()) {
                remarks.add(turn.remark());
            }
            if (turn.step().isEmpty()) {
                return steps;
            }
            assertThat(stepper.take(turn.step().get().step()).refusal()).isEmpty();
            steps++;
        }
        return steps;
    }

    @Test
    void operatorSaysNoWhereYesLeadsBack() {
        Stepper stepper = start(new NetBuilder("again")
                .start("ask")
                .output("ask", "Approve")
                .end("end")
                .transition("yes", "Yes")
                .in("ask", "yes", "generic >= 1")
                .out("yes", "ask", "take all any")
                .transition("no", "No")
                .in("ask", "no", "generic >= 1")
                .out("no", "end", "take all any")
                .build());

        assertThat(run(stepper, true, true)).isLessThan(10);
        assertThat(stepper.outcome()).contains(Outcome.ENDED);
        assertThat(remarks).isEmpty();
    }

    @Test
    void whoeverActedLeastGoesFirst() {
        Stepper stepper = start(new NetBuilder("piling")
                .start("begin")
                .transition("split")
                .in("begin", "split", "generic >= 1")
                .out("split", "busy", "take 1 generic")
                .out("split", "quiet", "add 1 generic")
                .output("busy", "Do")
                .output("quiet", "Provide")
                .end("end")
                .transition("more", "Done")
                .in("busy", "more", "generic >= 1")
                .out("more", "busy", "take 1 generic")
                .out("more", "heap", "add 1 generic")
                .transition("given", "Provided")
                .in("quiet", "given", "generic >= 1")
                .out("given", "end", "take all any")
                .build());

        run(stepper, true, true);

        assertThat(stepper.outcome())
                .as("the answers that make ever more tokens leave the operator a turn")
                .contains(Outcome.ENDED);
    }

    @Test
    void whatIsAnsweredAgainAndAgainLetsTimePassAtLast() {
        Stepper stepper = start(new NetBuilder("late")
                .start("busy")
                .output("busy", "Do")
                .output("busy", "StartTimer", A_SECOND, Map.of())
                .end("end")
                .transition("more", "Done")
                .in("busy", "more", "any >= 1")
                .out("more", "heap", "add 1 generic")
                .transition("late", "TimerExpired")
                .in("busy", "late", "any >= 1")
                .out("late", "end", "take all any")
                .build());

        run(stepper, true, true);

        assertThat(stepper.outcome()).contains(Outcome.ENDED);
    }

    private static NetBuilder watching() {
        return new NetBuilder("watching")
                .start("watch")
                .output("watch", "StartTimer", A_SECOND, Map.of())
                .end("end")
                .transition("look", "TimerExpired")
                .in("watch", "look", "any >= 1")
                .out("look", "watch", "take all any");
    }

    private static Plan withButton() {
        return watching()
                .input("stop", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
                .in("watch", "stop", "any >= 1")
                .out("stop", "end", "take all any")
                .build();
    }

    @Test
    void buttonThatLeadsOutOfARoundIsPressedAndTold() {
        Stepper stepper = start(withButton());

        run(stepper, true, true);

        assertThat(stepper.outcome()).contains(Outcome.ENDED);
        assertThat(remarks).containsExactly("it went round; press Stop leads out");
    }

    @Test
    void roundSaysWhatWouldLeadOutWhereThatIsLeftToTheAuthor() {
        Stepper stepper = start(withButton());

        run(stepper, false, true);

        assertThat(stepper.outcome()).isEmpty();
        assertThat(remarks).last().isEqualTo("This goes round; what leads out, by hand: press Stop");
    }

    @Test
    void roundWithoutAWayOutIsTold() {
        Stepper stepper = start(watching().build());

        assertThat(run(stepper, true, true)).isLessThan(10);
        assertThat(remarks).last().isEqualTo("This goes round, and nothing that can be tried leads out");
    }

    @Test
    void decisionIsLeftToTheAuthorWhereTheOperatorDoesNotAnswer() {
        Stepper stepper = start(new NetBuilder("ask")
                .start("ask")
                .output("ask", "Approve")
                .end("end")
                .transition("yes", "Yes")
                .in("ask", "yes", "any >= 1")
                .out("yes", "end", "take all any")
                .build());

        assertThat(run(stepper, false, true)).isZero();
        assertThat(remarks)
                .containsExactly("Nothing goes on by itself; what leads on, by hand: operator: yes to Approve at ask");
    }
}
