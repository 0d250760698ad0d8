package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Question;
import org.sami.spn.stepping.Possible;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventType;

/** Random walks through every plan that ships: what is possible can be done, and can be undone to the last byte. */
class SteppingShippedPlansTest {
    private static final int STEPS = 40;
    private static final List<String> ROBOTS = List.of("b1", "b2", "b3");
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    record Walk(Project project, Plan plan, long seed) {
        @Override
        public String toString() {
            return plan.id() + ", seed " + seed;
        }
    }

    static Stream<Walk> walks() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream()
                        .flatMap(plan -> Stream.of(1L, 2L, 3L).map(seed -> new Walk(project, plan, seed))));
    }

    @ParameterizedTest
    @MethodSource("walks")
    void everyStepCanBeUndoneAndTheWalkRunsAsATestCase(Walk walk) {
        Engine engine = new Engine(LIBRARY.vocabulary(), walk.project());
        Stepper stepper = Stepper.start(engine, walk.plan().id(), "walk", ROBOTS);
        Random random = new Random(walk.seed());
        List<byte[]> states = new ArrayList<>(List.of(stepper.stateBytes()));
        int fired = firings(stepper.startEffects());
        for (int i = 0; i < STEPS && stepper.outcome().isEmpty(); i++) {
            TakenStep taken = step(stepper, walk.plan(), random);
            fired += firings(taken.effects());
            if (taken.refusal().isPresent()) {
                assertThat(stepper.stateBytes()).as(taken.refusal().get()).isEqualTo(states.get(states.size() - 1));
            } else {
                states.add(stepper.stateBytes());
            }
            if (states.size() > 3 && random.nextInt(6) == 0) {
                int back = 1 + random.nextInt(3);
                stepper.back(back);
                states.subList(states.size() - back, states.size()).clear();
                assertThat(stepper.stateBytes()).isEqualTo(states.get(states.size() - 1));
            }
        }

        assertThat(fired).as("firings").isPositive();
        if (stepper.whyNotATestCase().isEmpty()) {
            TestCaseRunner runner = new TestCaseRunner(walk.project(), LIBRARY.vocabulary());
            assertThat(runner.run(walk.plan(), stepper.testCase("walk"))).isEmpty();
        }
        while (!stepper.steps().isEmpty()) {
            stepper.back(1);
            assertThat(stepper.stateBytes())
                    .isEqualTo(states.get(stepper.steps().size()));
        }
    }

    private static int firings(List<Effect> effects) {
        return (int) effects.stream().filter(Effect.Fired.class::isInstance).count();
    }

    private static TakenStep step(Stepper stepper, Plan plan, Random random) {
        Possible possible = stepper.possible();
        if (!possible.decisions().isEmpty() && random.nextInt(3) > 0) {
            Decision decision = oneOf(possible.decisions(), random);
            return stepper.answer(decision.id(), answer(decision.question(), plan, random));
        }
        List<Possible.OpenActivation> answerable = possible.activations().stream()
                .filter(open -> !open.answers().isEmpty())
                .toList();
        if (!answerable.isEmpty() && random.nextInt(4) > 0) {
            Possible.OpenActivation open = oneOf(answerable, random);
            Activation asked = open.activation();
            List<String> robots = asked.proxies().isEmpty() ? List.of() : List.of(oneOf(asked.proxies(), random));
            return stepper.occur(asked.id(), oneOf(open.answers(), random).name(), robots, List.of(), Map.of());
        }
        return switch (random.nextInt(6)) {
            case 0 ->
                stepper.take(new TestStep.Drop(oneOf(ROBOTS.subList(1, ROBOTS.size()), random))); // the first one stays
            case 1 -> stepper.take(new TestStep.Join("b4"));
            case 2 ->
                possible.interrupts().isEmpty()
                        ? stepper.advanceToNextTimer()
                        : stepper.take(new TestStep.Press(
                                oneOf(possible.interrupts(), random).name(), List.of(oneOf(ROBOTS, random))));
            case 3 -> news(stepper, possible.news(), random);
            case 4 -> stepper.advance(random.nextInt(30_000));
            default -> stepper.advanceToNextTimer();
        };
    }

    private static TakenStep news(Stepper stepper, List<EventType> news, Random random) {
        return news.isEmpty()
                ? stepper.advance(1)
                : stepper.news(oneOf(news, random).name(), List.of(oneOf(ROBOTS, random)), List.of(), Map.of());
    }

    private static Answer answer(Question question, Plan plan, Random random) {
        if (question instanceof Question.ChooseProxies choose) {
            int most = Math.min(choose.max(), choose.proxies().size());
            return new Answer.Proxies(choose.proxies().subList(0, most));
        } else if (question instanceof Question.ChooseOption choose
                && !choose.options().isEmpty()) {
            return new Answer.Option(random.nextInt(choose.options().size()));
        } else if (question instanceof Question.FillIn fillIn) {
            Map<String, Value> values = new LinkedHashMap<>();
            Map<String, Value> saved = savedValues(plan);
            fillIn.items()
                    .forEach(i -> i.defaultValue()
                            .or(() -> Optional.ofNullable(saved.get(i.key())))
                            .ifPresent(value -> values.put(i.key(), value)));
            return new Answer.Fields(values);
        }
        return question instanceof Question.Approve ? new Answer.YesNo(random.nextInt(4) > 0) : new Answer.Rejected();
    }

    /** The values that the plan's author gave in its test cases. */
    private static Map<String, Value> savedValues(Plan plan) {
        Map<String, Value> values = new LinkedHashMap<>();
        plan.testCases().stream()
                .flatMap(test -> test.steps().stream())
                .filter(s -> s instanceof TestStep.Answer answer && answer.reply() instanceof TestStep.Reply.Values)
                .forEach(s -> values.putAll(((TestStep.Reply.Values) ((TestStep.Answer) s).reply()).values()));
        return values;
    }

    private static <T> T oneOf(List<T> list, Random random) {
        return list.get(random.nextInt(list.size()));
    }
}
