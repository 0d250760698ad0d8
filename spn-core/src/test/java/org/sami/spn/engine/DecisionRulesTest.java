package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** Decisions (R-DEC-*) and parameters asked at the start (R-ACT-4). */
class DecisionRulesTest {
    private static Session approve(MarkupSpec... markups) {
        return new Session(new NetBuilder("net")
                .start("s")
                .output(
                        "s",
                        "Approve",
                        Map.of("question", new FieldSource.Fixed(new TextValue("Go?"))),
                        Map.of(),
                        markups)
                .transition("yes", "Yes")
                .in("s", "yes", "generic >= 1")
                .out("yes", "x", "take 1 generic")
                .transition("no", "No")
                .in("s", "no", "generic >= 1")
                .out("no", "y", "take 1 generic")
                .build());
    }

    @Test
    void theFirstAnswerCountsAndIsTheOnlyOne() {
        Session s = approve();
        long m = s.start("net");
        long id = s.onlyDecision().id();
        assertThat(s.onlyDecision().prompt()).isEqualTo("Go?");

        s.step(new Input.AnswerDecision(id, new Answer.Option(0), Answerer.OPERATOR));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.step(new Input.AnswerDecision(id, new Answer.YesNo(false), Answerer.OPERATOR));
        assertThat(s.fired()).containsExactly("no");
        s.step(new Input.AnswerDecision(id, new Answer.YesNo(true), Answerer.OPERATOR));

        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.marking(m)).isEqualTo(Map.of("y", "generic"));
    }

    @Test
    void autonomyAnswersInTheSameStepWhereTheMarkupSaysSo() {
        Session s = approve(MixedInitiative.trigger("IMMEDIATELY", 0));

        s.start("net");

        assertThat(s.fired()).containsExactly("yes");
        assertThat(s.last())
                .contains(new Effect.DecisionClosed(
                        1, Optional.of(new Answer.YesNo(true)), Optional.of(Answerer.AUTONOMY)));
    }

    @Test
    void autonomyAnswersWhenTheTimerRunsOut() {
        Session s = approve(MixedInitiative.trigger("TIMER", 2000));
        s.start("net");
        assertThat(s.onlyDecision().deadlineMillis()).hasValue(2000);

        s.advance(1999);
        assertThat(s.fired()).isEmpty();
        s.advance(1);

        assertThat(s.fired()).containsExactly("yes");
        assertThat(s.view().nextDueMillis()).isEmpty();
    }

    @Test
    void aHeldDecisionWaitsForTheOperatorAlone() {
        Session s = approve(MixedInitiative.trigger("TIMER", 2000));
        s.start("net");
        long id = s.onlyDecision().id();

        s.advance(1999);
        s.step(new Input.HoldDecision(id));
        assertThat(s.last()).containsExactly(new Effect.DecisionHeld(id));
        assertThat(s.onlyDecision().deadlineMillis()).isEmpty();
        assertThat(s.view().nextDueMillis()).isEmpty();
        s.advance(100_000);
        assertThat(s.fired()).isEmpty();

        s.step(new Input.HoldDecision(id));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.decide(new Answer.YesNo(false));
        assertThat(s.fired()).containsExactly("no");
    }

    @Test
    void aHeldDecisionStaysHeldWhenTheStateIsRead() {
        Session s = approve(MixedInitiative.trigger("TIMER", 2000));
        s.start("net");
        s.step(new Input.HoldDecision(1));

        EngineState read = StateCodec.decode(StateCodec.encode(s.state()), s.engine());

        assertThat(s.engine().view(read).nextDueMillis()).isEmpty();
        assertThat(s.engine().step(read, 60_000, new Input.TimeReached())).isEmpty();
        assertThat(s.engine().view(read).decisions()).isEqualTo(s.view().decisions());
    }

    @Test
    void ofAnAnswerAHoldAnAbortAndATimerAtOneMomentTheFirstWins() {
        List<Input> racing = List.of(
                new Input.AnswerDecision(1, new Answer.YesNo(false), Answerer.OPERATOR),
                new Input.HoldDecision(1),
                new Input.AbortMission(1));
        for (Input first : racing) {
            for (long at : new long[] {1999, 2000}) {
                Session s = approve(MixedInitiative.trigger("TIMER", 2000));
                s.start("net");
                List<Effect> effects = new ArrayList<>(s.engine().step(s.state(), at, first));
                racing.forEach(later -> effects.addAll(s.engine().step(s.state(), at, later)));
                List<Effect> closed = effects.stream()
                        .filter(Effect.DecisionClosed.class::isInstance)
                        .toList();

                assertThat(closed).as(first + " at " + at).hasSize(1);
                boolean timer = closed.get(0)
                        .equals(new Effect.DecisionClosed(
                                1, Optional.of(new Answer.YesNo(true)), Optional.of(Answerer.AUTONOMY)));
                assertThat(timer).as("the timer wins when it is due").isEqualTo(at == 2000);
            }
        }
    }

    @Test
    void autonomyWithoutAnswerSaysSo() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Provide", MixedInitiative.trigger("TIMER", 10))
                .build());
        s.start("net");

        s.advance(10);

        assertThat(s.notes()).containsExactly(NoteKind.NO_AUTOMATIC_ANSWER);
        assertThat(s.view().decisions()).hasSize(1);
    }

    @Test
    void aQuestionClosesWithItsVisit() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Approve", MixedInitiative.trigger("TIMER", 100))
                .transition("t", "News")
                .in("s", "t", "always")
                .out("t", "x", "take all any")
                .build());
        s.start("net");

        s.news("News");

        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.view().nextDueMillis()).isEmpty();
        assertThat(s.last()).contains(new Effect.DecisionClosed(1, Optional.empty(), Optional.empty()));
    }

    @Test
    void redefiningChecksTheType() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .variable("@n", ValueType.Simple.INTEGER, new IntegerValue(1))
                .output(
                        "s",
                        "Redefine",
                        Map.of("variable", new FieldSource.Fixed(new VariableReference("@n"))),
                        Map.of())
                .transition("t", "Redefined")
                .in("s", "t", "always")
                .out("t", "x", "take 1 generic")
                .build());
        long m = s.start("net");

        s.decide(new Answer.Fields(Map.of("@n", new TextValue("x"))));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.decide(new Answer.Fields(Map.of("@n", new IntegerValue(2))));

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.view().variable(m, "@n")).contains(new IntegerValue(2));
    }

    private static Session asking() {
        return new Session(new NetBuilder("net")
                .start("s")
                .output(
                        "s",
                        "Do",
                        Map.of(
                                "number", new FieldSource.Asked(Optional.empty(), true),
                                "speed", new FieldSource.Asked(Optional.of(new IntegerValue(3)), false)),
                        Map.of("number", "@n"))
                .build());
    }

    @Test
    void parametersAreAskedAndTheStartMarkingWaits() {
        Session s = asking();
        long m = s.join("A").start("net");
        assertThat(s.view().mission(m).orElseThrow().status()).isEqualTo(MissionStatus.WAITING);
        assertThat(s.marking(m)).isEmpty();

        s.decide(new Answer.Fields(Map.of("s.Do.number", new IntegerValue(9))));

        assertThat(s.marking(m, "s")).isEqualTo("generic A");
        assertThat(s.latest("s").values())
                .isEqualTo(Map.<String, Value>of("number", new IntegerValue(9), "speed", new IntegerValue(3)));
        assertThat(s.view().variable(m, "@n")).contains(new IntegerValue(9));
    }

    @Test
    void parametersCanBeGivenAndAreChecked() {
        Session s = asking();
        assertThat(s.start("net", Map.of("number", new TextValue("x")))).isZero();
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.start("net", Map.of("nothing", new IntegerValue(1)))).isZero();
        assertThat(s.start("net", Map.of("speed", new IntegerValue(1)))).isZero();

        long m = s.start("net", Map.of("number", new IntegerValue(9)));

        assertThat(s.marking(m, "s")).isEqualTo("generic");
        assertThat(s.view().decisions()).isEmpty();
    }

    @Test
    void aHandlersFailureIsNotedAndTheQuestionStaysOpen() {
        Session s =
                new Session(new NetBuilder("net").start("s").output("s", "Do").build());
        s.start("net");

        s.step(new Input.HandlerFailed(1, "no link"));

        assertThat(s.notes()).containsExactly(NoteKind.HANDLER_FAILED);
        assertThat(s.view().openActivations()).hasSize(1);
    }

    @Test
    void generatedTasksAreNamedAndApplied() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output(
                        "s",
                        "GenerateTasks",
                        Map.of(
                                "locations",
                                        new FieldSource.Fixed(new org.sami.spn.value.ListValue(List.of(
                                                org.sami.spn.value.GeoPoint.of(1, 2),
                                                org.sami.spn.value.GeoPoint.of(3, 4)))),
                                "taskClass", new FieldSource.Fixed(new TextValue("Look"))),
                        Map.of())
                .transition("t", "TasksGenerated")
                .in("s", "t", "generic >= 1")
                .out("t", "x", "add all relevant")
                .output("x", "Do", Map.of("location", new FieldSource.FromTask()), Map.of())
                .build());

        long m = s.start("net");

        assertThat(s.marking(m, "x")).isEqualTo("#Look 1 #Look 2");
        assertThat(s.latest("x").taskValues()).hasSize(2);
    }

    @Test
    void memoryIsKeptUntilTheMissionEnds() {
        Session s = approve();
        long m = s.start("net");

        s.step(new Input.Remember(m, "k", new IntegerValue(1)));
        assertThat(s.view().memory(m, "k")).contains(new IntegerValue(1));
        s.step(new Input.AbortMission(m));

        assertThat(s.view().memory(m, "k")).isEmpty();
        s.step(new Input.Remember(m, "k", new IntegerValue(1)));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
    }

    @Test
    void theDomainAsksWithoutAPlanAndIsToldTheAnswer() {
        Session s = approve();
        s.step(new Input.AskOperator("Restarted", "b1", "May b1 move?", Priority.CRITICAL));
        s.step(new Input.AskOperator("Restarted", "b1", "May b1 move?", Priority.CRITICAL));
        s.step(new Input.AskOperator("Restarted", "b2", "May b2 move?", Priority.CRITICAL));

        assertThat(s.view().decisions()).extracting(Decision::prompt).containsExactly("May b1 move?", "May b2 move?");
        Decision first = s.view().decisions().get(0);
        assertThat(first.type()).isEqualTo("Restarted");
        assertThat(first.automatic()).isEmpty();
        s.step(new Input.AnswerDecision(first.id(), new Answer.Option(0), Answerer.OPERATOR));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.step(new Input.AnswerDecision(first.id(), new Answer.YesNo(false), Answerer.OPERATOR));

        assertThat(s.last()).contains(new Effect.QuestionAnswered("Restarted", "b1", false));
        assertThat(s.view().decisions()).hasSize(1);
    }

    @Test
    void autonomyAnswersAQuestionOfTheDomainThatNobodyAnsweredInItsTime() {
        Session s = approve();
        s.step(new Input.AskOperator(
                "LongWay",
                "b1",
                "Send it?",
                Priority.HIGH,
                List.of(),
                Optional.of(new Input.AskOperator.Unanswered(false, 90_000))));
        Decision asked = s.view().decisions().get(0);
        long deadline = asked.deadlineMillis().orElseThrow();
        assertThat(asked.automatic()).contains(new Answer.YesNo(false));
        EngineState read = StateCodec.decode(StateCodec.encode(s.state()), s.engine());

        assertThat(s.engine().step(read, deadline - 1, new Input.TimeReached())).isEmpty();
        assertThat(s.engine().step(read, deadline, new Input.TimeReached()))
                .containsExactly(
                        new Effect.DecisionClosed(
                                asked.id(), Optional.of(new Answer.YesNo(false)), Optional.of(Answerer.AUTONOMY)),
                        new Effect.QuestionAnswered("LongWay", "b1", false));
        assertThat(s.engine().view(read).decisions()).isEmpty();
    }

    @Test
    void whatTheDomainAskedOutlivesMissionsAndASnapshotAndCanBeWithdrawn() {
        Session s = approve();
        long m = s.start("net");
        s.step(new Input.AskOperator("Restarted", "b1", "May b1 move?", Priority.CRITICAL));
        s.step(new Input.AbortMission(m));
        EngineState read = StateCodec.decode(StateCodec.encode(s.state()), s.engine());

        assertThat(s.engine().view(read).decisions())
                .isEqualTo(s.view().decisions())
                .hasSize(1);
        List<Effect> effects = s.engine().step(read, 1, new Input.WithdrawQuestion("Restarted", "b1"));
        assertThat(effects)
                .containsExactly(new Effect.DecisionClosed(
                        s.view().decisions().get(0).id(), Optional.empty(), Optional.empty()));
        assertThat(s.engine().step(read, 1, new Input.WithdrawQuestion("Restarted", "b1")))
                .isEmpty();
    }
}
