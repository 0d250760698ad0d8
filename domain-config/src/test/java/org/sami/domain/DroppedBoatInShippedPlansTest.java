package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventType;

/**
 * A boat is dropped while a question or request of a plan that ships names it. What is answered then, to whichever question of
 * whichever place, takes the other boat on as it would have without the drop.
 */
class DroppedBoatInShippedPlansTest {
    private static final List<String> ROBOTS = List.of("b1", "b2");
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    record Shipped(Project project, Plan plan) {
        @Override
        public String toString() {
            return plan.id();
        }
    }

    /** What is asked in a place, and an answer to it. */
    private record Asked(Engine engine, EngineState state, Activation activation, String words, Input answer) {}

    static Stream<Shipped> plans() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream().map(plan -> new Shipped(project, plan)));
    }

    @ParameterizedTest
    @MethodSource("plans")
    void everyAnswerTakesTheOtherBoatOn(Shipped shipped) {
        List<String> stuck = new ArrayList<>();
        for (String dropped : ROBOTS) {
            for (Asked asked : asked(shipped)) {
                Engine engine = asked.engine;
                EngineState state = asked.state.copy();
                engine.step(state, 0, new Input.ProxyDropped(dropped, Ids.NONE));
                boolean isOpen =
                        engine.view(state).activation(asked.activation.id()).isPresent();
                if (isOpen
                        && fired(engine.step(state, 0, answerNow(engine, state, asked)))
                                .isEmpty()) {
                    stuck.add(asked.words + " without " + dropped);
                }
            }
        }

        assertThat(stuck).as("What does not go on").isEmpty();
    }

    @Test
    void everyPlanThatAsksAboutSeveralBoatsIsTried() {
        Set<String> tried = new TreeSet<>();
        int answers = 0;
        for (Shipped shipped : plans().toList()) {
            List<Asked> asked = asked(shipped);
            answers += asked.size();
            if (!asked.isEmpty()) {
                tried.add(shipped.plan.id());
            }
        }

        assertThat(tried).hasSizeGreaterThanOrEqualTo(22);
        assertThat(answers).isGreaterThan(100);
    }

    /** All that can be asked of both boats in one place, and be answered so that a transition fires. */
    private static List<Asked> asked(Shipped shipped) {
        List<Asked> found = new ArrayList<>();
        for (Place place : shipped.plan.places()) {
            for (List<String> tasks : startTasks(shipped.plan)) {
                if (!place.end() && !place.outputs().isEmpty()) {
                    found.addAll(asked(shipped, place, tasks));
                }
            }
        }
        return found;
    }

    private static List<List<String>> startTasks(Plan plan) {
        List<String> all = plan.tasks().stream().map(TaskSpec::name).toList();
        return all.isEmpty() ? List.of(all) : List.of(List.of(), all);
    }

    private static List<Asked> asked(Shipped shipped, Place place, List<String> tasks) {
        Engine engine = new Engine(LIBRARY.vocabulary(), shipped.project);
        EngineState state = engine.newState();
        ROBOTS.forEach(robot -> engine.step(state, 0, new Input.ProxyJoined(robot)));
        StartMarking marking = new StartMarking(List.of(new StartMarking.Tokens(place.id(), 1, ROBOTS, tasks)));
        Optional<String> refused = engine.startAt(
                state, 0, new Input.StartMission(shipped.plan.id(), "m", given(shipped.plan)), marking, effect -> {});
        assertThat(refused).isEmpty();
        List<Asked> found = new ArrayList<>();
        for (Activation activation : engine.view(state).openActivations()) {
            if (activation.proxies().containsAll(ROBOTS)) {
                for (Map.Entry<String, Input> answer :
                        answers(engine, state, activation).entrySet()) {
                    if (!fired(engine.step(state.copy(), 0, answer.getValue())).isEmpty()) {
                        String words = activation.place() + ": " + activation.type() + ", " + answer.getKey();
                        found.add(new Asked(engine, state, activation, words, answer.getValue()));
                    }
                }
            }
        }
        return found;
    }

    /** What the plan asks at its start, and what its variables could hold then: values that its author let services answer. */
    private static Map<String, Value> given(Plan plan) {
        Map<String, Value> variables = answered(plan, "");
        for (Transition t : plan.transitions()) {
            for (InputEventSpec input : t.inputs()) {
                Map<String, Value> answered = saved(plan, input.type());
                input.writes().forEach((field, variable) -> {
                    if (answered.containsKey(field)) {
                        variables.put(variable, answered.get(field));
                    }
                });
            }
        }
        return variables;
    }

    private static Map<String, Value> saved(Plan plan, String type) {
        Map<String, Value> values = new LinkedHashMap<>();
        plan.testCases().stream()
                .flatMap(test -> test.steps().stream())
                .filter(step ->
                        step instanceof TestStep.Occur occur && occur.type().equals(type))
                .forEach(step -> values.putAll(((TestStep.Occur) step).values()));
        return values;
    }

    /** What the operator fills in in the plan's test cases, at its start where no event asks. */
    private static Map<String, Value> answered(Plan plan, String event) {
        Map<String, Value> values = new LinkedHashMap<>();
        plan.testCases().stream()
                .flatMap(test -> test.steps().stream())
                .filter(step -> step instanceof TestStep.Answer given
                        && given.event().equals(event)
                        && given.reply() instanceof TestStep.Reply.Values)
                .forEach(step -> values.putAll(((TestStep.Reply.Values) ((TestStep.Answer) step).reply()).values()));
        return values;
    }

    /** All answers to an activation, by what they say: as the operator gives them, or as a service names all whom it was asked about. */
    private static Map<String, Input> answers(Engine engine, EngineState state, Activation activation) {
        Map<String, Input> answers = new LinkedHashMap<>();
        Optional<Decision> open = decision(engine, state, activation);
        if (open.isPresent()) {
            Question question = open.get().question();
            if (question instanceof Question.Approve) {
                answers.put("yes", answer(open.get(), new Answer.YesNo(true)));
                answers.put("no", answer(open.get(), new Answer.YesNo(false)));
            } else if (question instanceof Question.ChooseProxies) {
                answers.put("all", answer(open.get(), everybody(question)));
            } else if (question instanceof Question.ChooseOption options) {
                answers.put("none", answer(open.get(), new Answer.Rejected()));
                if (!options.options().isEmpty()) {
                    answers.put("first", answer(open.get(), new Answer.Option(0)));
                }
            } else if (question instanceof Question.FillIn) {
                Plan plan = engine.view(state).planOf(activation.mission()).orElseThrow();
                answers.put("values", answer(open.get(), new Answer.Fields(answered(plan, activation.event()))));
            }
            return answers;
        }
        EventType type = LIBRARY.vocabulary().event(activation.type()).orElseThrow();
        for (String answer : type.answers()) {
            Map<String, Value> values = engine.view(state)
                    .planOf(activation.mission())
                    .map(plan -> saved(plan, answer))
                    .orElse(Map.of());
            answers.put(
                    answer,
                    new Input.Received(
                            Occurrence.answer(answer, activation, activation.proxies(), activation.tasks(), values)));
        }
        return answers;
    }

    private static Optional<Decision> decision(Engine engine, EngineState state, Activation activation) {
        return engine.view(state).decisions().stream()
                .filter(decision -> decision.activation() == activation.id())
                .findFirst();
    }

    private static Input answer(Decision decision, Answer answer) {
        return new Input.AnswerDecision(decision.id(), answer, Answerer.OPERATOR);
    }

    private static Answer everybody(Question question) {
        Question.ChooseProxies choose = (Question.ChooseProxies) question;
        return new Answer.Proxies(choose.proxies()
                .subList(0, Math.min(choose.max(), choose.proxies().size())));
    }

    /** The same answer; a choice of boats is asked again without the one that was dropped. */
    private static Input answerNow(Engine engine, EngineState state, Asked asked) {
        return asked.answer instanceof Input.AnswerDecision given && given.answer() instanceof Answer.Proxies
                ? decision(engine, state, asked.activation)
                        .map(again -> answer(again, everybody(again.question())))
                        .orElseThrow()
                : asked.answer;
    }

    private static List<String> fired(List<Effect> effects) {
        return effects.stream()
                .filter(Effect.Fired.class::isInstance)
                .map(effect -> ((Effect.Fired) effect).transition())
                .toList();
    }
}
