package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs a mission on the engine with robots, services and an operator that a test says in a few words. Each robot and task answers for itself,
 * in an order that a seed draws; time passes only when nobody has anything else to say.
 */
public final class PlayedTeam {
    private static final int MOST_STEPS = 2000;

    private final Session session;
    private final Random random;
    private final Map<String, Answering> answers = new LinkedHashMap<>();
    private final Map<String, Function<Decision, Answer>> decisions = new LinkedHashMap<>();
    private final Map<String, Function<Activation, List<String>>> robots = new LinkedHashMap<>();
    private final List<Activation> asked = new ArrayList<>();
    private final List<Runnable> waiting = new ArrayList<>();
    private final List<Occurrence> begun = new ArrayList<>();
    private final Map<String, List<TaskId>> queues = new LinkedHashMap<>();
    private final Set<Long> seen = new HashSet<>();
    private String started = "";
    private String completed = "";
    private long now;
    private long mission = Ids.NONE;

    /** How an output event is answered. */
    private record Answering(String type, boolean one, Function<Activation, Map<String, Value>> values) {}

    /** A team of so many robots, called b1, b2 and so on. */
    public PlayedTeam(Project project, Vocabulary vocabulary, int robots, long seed) {
        session = new Session(new Engine(vocabulary, project));
        random = new Random(seed);
        for (int i = 1; i <= robots; i++) {
            session.join("b" + i);
        }
    }

    /** Every robot or task that enters answers by itself. */
    public PlayedTeam each(String output, String input) {
        answers.put(output, new Answering(input, false, a -> Map.of()));
        return this;
    }

    /** One answer names all that entered. */
    public PlayedTeam once(String output, String input, Function<Activation, Map<String, Value>> values) {
        answers.put(output, new Answering(input, true, values));
        return this;
    }

    /** Some robots answer, each by itself. */
    public PlayedTeam some(String output, String input, Function<Activation, List<String>> who) {
        robots.put(output, who);
        return each(output, input);
    }

    /** The operator answers a question of a type so; other questions as autonomy would. */
    public PlayedTeam decides(String output, Function<Decision, Answer> answer) {
        decisions.put(output, answer);
        return this;
    }

    /**
     * Robots begin their allocated tasks one after the other.
     *
     * @param begun the news that a task is the first of its robot's queue
     * @param done the output event at which a task leaves the queue
     */
    public PlayedTeam works(String begun, String done) {
        started = begun;
        completed = done;
        return this;
    }

    /** The session, for what a test looks at. */
    public Session session() {
        return session;
    }

    /** The id of the mission. */
    public long mission() {
        return mission;
    }

    /** Starts a plan and lets everybody answer until the mission ends or nobody has anything to say; empty for the latter. */
    public Optional<Outcome> run(String plan) {
        session.step(new Input.StartMission(plan, plan, Map.of()));
        mission = session.last().stream()
                .filter(Effect.MissionStarted.class::isInstance)
                .map(e -> ((Effect.MissionStarted) e).mission())
                .findFirst()
                .orElseThrow(() -> new AssertionError("not started: " + session.last()));
        listen();
        for (int i = 0; i < MOST_STEPS && session.outcome(mission).isEmpty(); i++) {
            if (!step()) {
                break;
            }
            listen();
        }
        return session.outcome(mission);
    }

    private boolean step() {
        if (!begun.isEmpty()) { // a fleet says so at once
            session.step(new Input.Received(begun.remove(0)));
            return true;
        }
        List<Decision> open = session.view().decisions();
        if (!open.isEmpty()) {
            Decision decision = open.get(random.nextInt(open.size()));
            session.step(new Input.AnswerDecision(decision.id(), answer(decision), Answerer.OPERATOR));
            return true;
        }
        if (!waiting.isEmpty()) {
            waiting.remove(random.nextInt(waiting.size())).run();
            return true;
        }
        OptionalLong due = session.view().nextDueMillis();
        due.ifPresent(at -> {
            session.advance(Math.max(0, at - now));
            now = Math.max(now, at);
        });
        return due.isPresent();
    }

    private Answer answer(Decision decision) {
        Function<Decision, Answer> told = decisions.get(decision.type());
        if (told != null) {
            return told.apply(decision);
        }
        return decision.automatic()
                .orElseGet(() -> decision.question() instanceof Question.ChooseProxies choose
                        ? new Answer.Proxies(choose.proxies())
                        : decision.question() instanceof Question.ChooseOption
                                ? new Answer.Option(0)
                                : new Answer.YesNo(true));
    }

    /** Notes what the last step asks of robots and services. */
    private void listen() {
        for (Effect effect : List.copyOf(session.effects())) {
            if (effect instanceof Effect.Activated activated
                    && seen.add(activated.activation().id())) {
                hear(activated.activation());
            }
        }
        for (Effect effect : session.last()) {
            if (effect instanceof Effect.TasksAllocated allocated) {
                allocated.robots().forEach((task, robot) -> robot.ifPresent(r -> queue(task, r)));
            }
        }
    }

    private void queue(TaskId task, String robot) {
        List<TaskId> queue = queues.computeIfAbsent(robot, r -> new ArrayList<>());
        queue.add(task);
        if (queue.size() == 1) {
            begin(queue);
        }
    }

    private void begin(List<TaskId> queue) {
        if (!started.isEmpty() && !queue.isEmpty()) {
            TaskId first = queue.get(0);
            begun.add(new Occurrence(started, Ids.NONE, Ids.NONE, List.of(), List.of(first), Map.of()));
        }
    }

    private void hear(Activation activation) {
        asked.add(activation);
        if (activation.type().equals(completed)) {
            for (TaskId task : activation.tasks()) {
                for (List<TaskId> queue : queues.values()) {
                    if (queue.remove(task)) {
                        begin(queue);
                    }
                }
            }
        }
        Answering answering = answers.get(activation.type());
        if (answering == null) {
            return;
        }
        if (answering.one()) {
            Map<String, Value> values = answering.values().apply(activation);
            List<String> named = activation.tokens().stream()
                    .filter(Token.Proxy.class::isInstance)
                    .map(t -> ((Token.Proxy) t).proxy())
                    .toList();
            waiting.add(() -> received(answering.type(), activation, named, activation.tasks(), values));
            return;
        }
        Function<Activation, List<String>> who = robots.get(activation.type());
        if (who != null) {
            who.apply(activation)
                    .forEach(robot -> waiting.add(
                            () -> received(answering.type(), activation, List.of(robot), List.of(), Map.of())));
            return;
        }
        for (Token token : activation.tokens()) {
            if (token instanceof Token.Task task) {
                waiting.add(() -> received(answering.type(), activation, List.of(), List.of(task.task()), Map.of()));
            } else if (token instanceof Token.Proxy proxy) {
                waiting.add(() -> received(answering.type(), activation, List.of(proxy.proxy()), List.of(), Map.of()));
            }
        }
    }

    private void received(
            String type, Activation activation, List<String> robots, List<TaskId> tasks, Map<String, Value> values) {
        session.step(new Input.Received(Occurrence.answer(type, activation, robots, tasks, values)));
    }

    /** What was asked of robots and services, in order. */
    public List<Activation> asked() {
        return Collections.unmodifiableList(asked);
    }

    /** How often a transition fired. */
    public long fired(String transition) {
        return session.allFired().stream().filter(transition::equals).count();
    }

    /** The transitions that fired, of those given, in order. */
    public List<String> firedOf(String... transitions) {
        return session.allFired().stream()
                .filter(Arrays.asList(transitions)::contains)
                .toList();
    }
}
