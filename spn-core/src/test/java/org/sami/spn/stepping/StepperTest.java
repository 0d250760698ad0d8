package org.sami.spn.stepping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;

class StepperTest {
    /** The operator chooses robots, those do something, a button brings them back; a timer ends the waiting. */
    private static final Plan VISIT = new NetBuilder("visit")
            .start("ask")
            .output("ask", "Choose")
            .output("work", "Do")
            .output(
                    "home",
                    "StartTimer",
                    Map.of("duration", new FieldSource.Fixed(new DurationValue(60_000))),
                    Map.of())
            .end("end")
            .transition("chosen", "Chosen")
            .in("ask", "chosen", "relevant all")
            .out("chosen", "work", "take all relevant")
            .transition("done", "Done")
            .in("work", "done", "relevant all")
            .out("done", "home", "take all relevant")
            .input("recall", "Interrupt", Map.of("interruptName", new TextValue("Recall")), Map.of())
            .in("work", "recall", "relevant >= 1")
            .out("recall", "home", "take all relevant")
            .transition("over", "TimerExpired")
            .in("home", "over", "proxy >= 1")
            .out("over", "end", "take all proxy")
            .transition("news", "News")
            .in("ask", "news", "relevant all")
            .out("news", "work", "take all relevant")
            .task("T", "Measure", Map.of())
            .build();

    private final Engine engine = new Engine(TestVocabulary.TEST, NetBuilder.project(VISIT));
    private final Stepper stepper = Stepper.start(engine, "visit", "tried", List.of("A", "B"));

    private List<Token> tokens(String place) {
        return stepper.view()
                .mission(stepper.mission())
                .map(MissionView::marking)
                .map(m -> m.getOrDefault(place, List.of()))
                .orElse(List.of());
    }

    private static Token robot(String name) {
        return new Token.Proxy(name);
    }

    private TakenStep choose(String... robots) {
        return stepper.answer(stepper.possible().decisions().get(0).id(), new Answer.Proxies(List.of(robots)));
    }

    private TakenStep occur(String type, String... robots) {
        Activation activation = stepper.possible()
                .activations()
                .get(stepper.possible().activations().size() - 1)
                .activation();
        return stepper.occur(activation.id(), type, List.of(robots), List.of(), Map.of());
    }

    @Test
    void whatIsPossibleIsListed() {
        Possible atStart = stepper.possible();
        assertThat(atStart.decisions()).hasSize(1);
        assertThat(atStart.activations()).singleElement().satisfies(asked -> {
            assertThat(asked.activation().event()).isEqualTo("ask.Choose");
            assertThat(asked.decision()).contains(atStart.decisions().get(0));
            assertThat(asked.answers()).as("a domain's answers").isEmpty();
        });
        assertThat(atStart.news()).extracting(EventType::name).containsExactly("News");
        assertThat(atStart.interrupts()).extracting(InterruptButton::name).containsExactly("Recall");
        assertThat(atStart.nextDueMillis()).isEmpty();

        choose("A");
        assertThat(stepper.possible().activations().get(1).answers())
                .extracting(EventType::name)
                .containsExactly("Done", "Done2", "Failed");

        occur("Done", "A");
        assertThat(stepper.possible().nextDueMillis()).isEqualTo(OptionalLong.of(60_000));
    }

    @Test
    void stepsMoveTokensAndTellTheirEffects() {
        TakenStep chosen = choose("A", "B");
        assertThat(chosen.number()).isEqualTo(1);
        assertThat(chosen.effects())
                .anyMatch(e -> e instanceof Effect.Fired f && f.transition().equals("chosen"));
        assertThat(tokens("work")).containsExactly(robot("A"), robot("B"));

        occur("Done", "A");
        stepper.take(new TestStep.Press("Recall", List.of("B")));
        assertThat(tokens("home")).containsExactly(robot("A"), robot("B"));

        stepper.advanceToNextTimer();
        assertThat(stepper.outcome()).contains(Outcome.ENDED);
        assertThat(stepper.nowMillis()).isEqualTo(60_000);
        assertThat(stepper.steps()).hasSize(4);
    }

    @Test
    void stepsBackGiveTheVeryStateThatWas() {
        byte[] start = stepper.stateBytes();
        choose("A", "B");
        byte[] atWork = stepper.stateBytes();
        occur("Done", "A");
        stepper.take(new TestStep.Drop("B"));
        stepper.advance(59_999);

        stepper.back(3);
        assertThat(stepper.stateBytes()).isEqualTo(atWork);
        assertThat(stepper.nowMillis()).isZero();
        assertThat(tokens("work")).containsExactly(robot("A"), robot("B"));

        occur("Done", "B");
        assertThat(tokens("home")).containsExactly(robot("B"));

        stepper.back(2);
        assertThat(stepper.stateBytes()).isEqualTo(start);
        assertThatThrownBy(() -> stepper.back(1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("There are 0 steps to go back, not 1");
    }

    @Test
    void whatCannotBeDoneChangesNothingAndSaysWhy() {
        byte[] before = stepper.stateBytes();

        assertThat(choose("C").refusal())
                .hasValueSatisfying(why -> assertThat(why).contains("does not fit"));
        assertThat(stepper.answer(99, new Answer.YesNo(true)).refusal()).contains("the decision 99 is not open");
        assertThat(stepper.occur(99, "Done", List.of(), List.of(), Map.of()).refusal())
                .contains("the activation 99 is not open: nothing waits for Done");
        assertThat(stepper.advanceToNextTimer().refusal()).contains("no timer runs and no decision has a deadline");
        assertThat(stepper.take(new TestStep.Drop("C")).refusal()).isEmpty();
        stepper.back(1);
        assertThat(stepper.expectTokens("nowhere").refusal()).contains("the plan \"visit\" has no place \"nowhere\"");
        assertThat(stepper.expectEnded().refusal())
                .hasValueSatisfying(why -> assertThat(why).startsWith("the mission has not ended"));

        assertThat(stepper.stateBytes()).isEqualTo(before);
        assertThat(stepper.steps()).isEmpty();
        assertThatThrownBy(() -> Stepper.start(engine, "none", "x", List.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("There is no plan 'none'");
    }

    @Test
    void whyATransitionCannotFireIsSaidInWords() {
        choose("A");

        assertThat(stepper.whyNot(stepper.mission(), "over").reasons()).isNotEmpty();
        assertThat(stepper.whyNot(stepper.mission(), "done").awaited())
                .extracting(input -> input.type())
                .containsExactly("Done");
    }

    @Test
    void aPlanIsTriedFromAMarkingOfOnesOwn() {
        StartMarking marking = new StartMarking(List.of(
                new StartMarking.Tokens("work", 1, List.of("B"), List.of("T")),
                new StartMarking.Tokens("home", 0, List.of("A"), List.of())));
        Stepper middle = Stepper.startAt(engine, "visit", "middle", List.of("A", "B"), marking, Map.of());

        Map<String, List<Token>> found = middle.view()
                .mission(middle.mission())
                .map(MissionView::marking)
                .orElseThrow();
        assertThat(found)
                .isEqualTo(Map.of(
                        "work", List.of(Token.GENERIC, robot("B"), new Token.Task(new TaskId(middle.mission(), "T"))),
                        "home", List.of(robot("A"))));
        assertThat(middle.possible().activations())
                .extracting(open -> open.activation().event())
                .containsExactly("work.Do", "home.StartTimer");
        assertThat(middle.possible().decisions()).isEmpty();

        middle.advanceToNextTimer();
        assertThat(middle.outcome()).contains(Outcome.ENDED);
        middle.expectEnded();
        TestCase recorded = middle.testCase("from the middle");
        assertThat(recorded.start()).contains(new TestStart(marking, Map.of()));
        assertThat(new TestCaseRunner(project(), TestVocabulary.TEST).run(VISIT, recorded))
                .isEmpty();
        assertThat(new TestCaseRunner(project(), TestVocabulary.TEST)
                        .run(VISIT, recorded.withStart(java.util.Optional.empty())))
                .as("from the plan's own start place it goes another way")
                .isPresent();
    }

    @Test
    void aTestCaseThatCannotStartIsAFindingAtItsStart() {
        StartMarking gone = new StartMarking(List.of(new StartMarking.Tokens("end", 1, List.of(), List.of())));
        TestCase test = new TestCase("late", List.of("A"), List.of(new TestStep.ExpectEnded()))
                .withStart(java.util.Optional.of(new TestStart(gone, Map.of())));
        Plan plan = VISIT.withTestCases(List.of(test));

        assertThat(new TestCaseRunner(NetBuilder.project(plan), TestVocabulary.TEST).run(plan, test))
                .hasValueSatisfying(finding -> {
                    assertThat(finding.pointer()).isEqualTo("/plans/0/testCases/0/start");
                    assertThat(finding.message()).contains("\"late\", cannot start: 'end' is an end place");
                });
    }

    @Test
    void aForkGoesItsOwnWay() {
        choose("A", "B");
        Stepper fork = stepper.fork();
        fork.take(new TestStep.Press("Recall", List.of("A")));

        assertThat(fork.steps()).hasSize(2);
        assertThat(stepper.steps()).hasSize(1);
        assertThat(tokens("work")).containsExactly(robot("A"), robot("B"));
        fork.back(1);
        assertThat(fork.stateBytes()).isEqualTo(stepper.stateBytes());
    }

    @Test
    void startMarkingsThatCannotBeAreRefusedWithTheirPlace() {
        assertThatThrownBy(() -> startAt("nowhere", List.of(), List.of()))
                .hasMessage("The plan 'visit' has no place 'nowhere'");
        assertThatThrownBy(() -> startAt("end", List.of("A"), List.of())).hasMessageContaining("'end' is an end place");
        assertThatThrownBy(() -> startAt("work", List.of("C"), List.of()))
                .hasMessage("No robot 'C' is known that could stand in 'work'");
        assertThatThrownBy(() -> startAt("work", List.of(), List.of("U")))
                .hasMessage("The plan 'visit' has no task 'U' that could stand in 'work'");
    }

    private void startAt(String place, List<String> robots, List<String> tasks) {
        StartMarking marking = new StartMarking(List.of(new StartMarking.Tokens(place, 0, robots, tasks)));
        Stepper.startAt(engine, "visit", "x", List.of("A"), marking, Map.of());
    }

    @Test
    void whatAPlanAsksAtItsStartHasItsDefaultOrMustBeGiven() {
        Plan asks = new NetBuilder("asks")
                .start("s")
                .output("s", "Do", Map.of("speed", new FieldSource.Asked(java.util.Optional.empty(), true)), Map.of())
                .places("b")
                .variable("@x", ValueType.Simple.REAL)
                .build();
        Engine asking = new Engine(TestVocabulary.TEST, NetBuilder.project(asks));
        StartMarking marking = new StartMarking(List.of(new StartMarking.Tokens("s", 1, List.of(), List.of())));

        assertThatThrownBy(() -> Stepper.startAt(asking, "asks", "x", List.of(), marking, Map.of()))
                .hasMessage(
                        "The plan 'asks' asks for 's.Do.speed' at its start: it has no default, so a value must be given");
        Stepper given = Stepper.startAt(asking, "asks", "x", List.of(), marking, Map.of("speed", new RealValue(2)));
        assertThat(given.possible().activations().get(0).activation().value("speed"))
                .contains(new RealValue(2));
        assertThat(given.whyNotATestCase())
                .hasValueSatisfying(why -> assertThat(why).contains("speed"));
    }

    @Test
    void recordedStepsRunAsATestCase() {
        choose("A", "B");
        stepper.expectTokens("work");
        occur("Done", "A");
        stepper.back(1);
        occur("Done", "B");
        stepper.take(new TestStep.Press("Recall", List.of("A")));
        stepper.expectTokens("home");
        stepper.advance(60_000);
        stepper.expectEnded();

        assertThat(stepper.whyNotATestCase()).isEmpty();
        TestCase recorded = stepper.testCase("as tried");
        assertThat(recorded.proxies()).containsExactly("A", "B");
        assertThat(recorded.steps()).hasSize(7);
        assertThat(new TestCaseRunner(project(), TestVocabulary.TEST).run(VISIT, recorded))
                .isEmpty();
    }

    private Project project() {
        return engine.project();
    }

    @Test
    void anAnswerThatATestCaseCannotNameIsNotRecordedAsAnother() {
        stepper.news("News", List.of("A"), List.of(), Map.of());
        stepper.news("News", List.of("B"), List.of(), Map.of());
        Activation second = stepper.possible().activations().get(2).activation();
        stepper.occur(second.id(), "Failed", List.of(), List.of(), Map.of());

        assertThat(stepper.whyNotATestCase())
                .hasValueSatisfying(
                        why -> assertThat(why).startsWith("step 3 cannot be expressed in a test case: of the open"));
        assertThatThrownBy(() -> stepper.testCase("x")).isInstanceOf(IllegalStateException.class);
        stepper.back(1);
        assertThat(stepper.testCase("x").steps()).hasSize(2);
    }
}
