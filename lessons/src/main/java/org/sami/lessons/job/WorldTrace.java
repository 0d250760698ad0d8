package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Writes down what can be seen of a run from outside, in words that do not depend on ids, names and positions. */
final class WorldTrace {
    /** Stands for an output event where values are asked before the mission starts. */
    static final String ASKED_AT_START = "asked at the start";

    private final Vocabulary vocabulary;
    private final CanonicalValue canonical;
    private final Map<TaskId, Integer> tasks = new LinkedHashMap<>();
    private final List<TraceItem> items = new ArrayList<>();
    private final List<TraceItem> answers = new ArrayList<>();

    WorldTrace(Project project, Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        canonical = new CanonicalValue(project, this::number);
    }

    /** Numbers tasks in the order in which they are first seen: that of their making. */
    void saw(Effect effect, EngineView view) {
        if (effect instanceof Effect.Entered entered) {
            entered.tokens().forEach(token -> {
                if (token instanceof Token.Task task) {
                    number(owned(task.task(), view));
                }
            });
        } else if (effect instanceof Effect.Fired fired) {
            fired.used().forEach(used -> used.tasks().forEach(task -> number(owned(task, view))));
        }
    }

    /** Tasks get robots: whichever field of the event says so. */
    void allocated(long now, Effect.TasksAllocated allocated, EngineView view) {
        Map<String, String> robots = new LinkedHashMap<>();
        List<Integer> of = new ArrayList<>();
        allocated
                .robots()
                .forEach((task, robot) -> robot.ifPresent(name -> {
                    int number = number(owned(task, view));
                    of.add(number);
                    robots.put("task " + number, name);
                }));
        Optional<EventType> type = vocabulary.eventWithRole(EventRole.APPLY_ALLOCATION);
        if (type.isPresent() && !of.isEmpty()) {
            items.add(new TraceItem(now, type.get().name(), List.of(), of, robots));
        }
    }

    /** A task of a sub-mission is its parent's, where that owns it. */
    private static TaskId owned(TaskId task, EngineView view) {
        return view.namesOf(task).stream().findFirst().orElse(task);
    }

    private int number(TaskId task) {
        return tasks.computeIfAbsent(task, made -> tasks.size() + 1);
    }

    /** The number of a task, from 1. */
    int number(TaskId task, EngineView view) {
        return number(owned(task, view));
    }

    /** The task of a number. */
    Optional<TaskId> task(int number) {
        return tasks.entrySet().stream()
                .filter(entry -> entry.getValue() == number)
                .map(Map.Entry::getKey)
                .findFirst();
    }

    void activated(long now, Activation activation, EngineView view) {
        EventType type = vocabulary.event(activation.type()).orElseThrow();
        if (type.role() == EventRole.APPLY_ALLOCATION) {
            return; // it is added when it is done
        } else if (!isForEach(type)) {
            boolean concernsNobody = type.tokens() == TokenNeed.NONE
                    || type.decision()
                            .filter(decision -> decision.form() == DecisionForm.CHOOSE_OPTION)
                            .isPresent();
            items.add(item(
                    now,
                    type,
                    activation,
                    concernsNobody ? List.of() : activation.proxies(),
                    concernsNobody ? List.of() : tasks(type, activation),
                    view));
            return;
        }
        for (TaskId task : tasks(type, activation)) {
            List<String> robot = Optional.ofNullable(activation.allocation().get(task)).stream()
                    .toList();
            items.add(item(now, type, activation, robot, List.of(task), view));
        }
        robots(type, activation)
                .forEach(robot -> items.add(item(now, type, activation, List.of(robot), List.of(), view)));
    }

    /** The robots that an output event means by themselves, not by their tasks. */
    static List<String> robots(EventType type, Activation activation) {
        return switch (type.tokens()) {
            case NONE, TASK -> List.of();
            case PROXY -> activation.proxies();
            case PROXY_OR_TASK ->
                activation.tokens().stream()
                        .filter(Token.Proxy.class::isInstance)
                        .map(token -> ((Token.Proxy) token).proxy())
                        .distinct()
                        .toList();
        };
    }

    /** The tasks that an output event means. */
    static List<TaskId> tasks(EventType type, Activation activation) {
        boolean meansTasks = type.tokens() == TokenNeed.TASK || type.tokens() == TokenNeed.PROXY_OR_TASK;
        return meansTasks ? activation.tasks() : List.of();
    }

    /** Whether an output event is for each robot or task by itself, so that it does not matter how many enter together. */
    static boolean isForEach(EventType type) {
        return type.tokens() != TokenNeed.NONE
                && type.decision().isEmpty()
                && (type.role() == EventRole.PROXY_TIMER
                        || (type.role() == EventRole.NONE && Answering.of(type) != Answering.SERVICE));
    }

    private TraceItem item(
            long now, EventType type, Activation activation, List<String> robots, List<TaskId> of, EngineView view) {
        Map<String, String> values = new LinkedHashMap<>();
        activation.values().forEach((field, value) -> {
            if (!isForPeople(type, value)) {
                values.put(field, canonical.of(isForEach(type) ? ownPart(value, robots) : value));
            }
        });
        of.forEach(task -> activation
                .taskValues()
                .getOrDefault(task, Map.of())
                .forEach((field, value) ->
                        values.merge(field, canonical.of(value), (one, other) -> one + ", " + other)));
        return new TraceItem(
                now,
                type.name(),
                robots,
                of.stream().map(task -> number(owned(task, view))).toList(),
                values);
    }

    /** Text that operators read is worded as everybody likes. */
    private static boolean isForPeople(EventType type, Value value) {
        boolean isMessage = type.role() == EventRole.NONE
                && type.tokens() == TokenNeed.NONE
                && type.answers().isEmpty();
        return value instanceof TextValue && (type.decision().isPresent() || isMessage);
    }

    private static Value ownPart(Value value, List<String> robots) {
        if (!(value instanceof MapValue map) || robots.isEmpty()) {
            return value;
        }
        Map<Value, Value> own = new LinkedHashMap<>();
        map.entries().forEach((key, item) -> {
            if (!(key instanceof ProxyValue robot) || robots.contains(robot.proxy())) {
                own.put(key, item);
            }
        });
        return new MapValue(own);
    }

    /** The mission asks for values before it starts. */
    void askedAtStart(long now, List<String> fields) {
        Map<String, String> values = new LinkedHashMap<>();
        List<String> sorted = fields.stream().sorted().toList();
        for (int i = 0; i < sorted.size(); i++) {
            values.put(String.format("%03d", i), sorted.get(i));
        }
        items.add(new TraceItem(now, ASKED_AT_START, List.of(), List.of(), values));
    }

    /** Operator, robots or services posted an input event. */
    void answered(long now, String type, List<String> robots, List<Integer> of) {
        answers.add(new TraceItem(now, Objects.requireNonNull(type, "type"), robots, of, Map.of()));
    }

    List<TraceItem> items() {
        return items.stream().sorted(TraceItem.ORDER).toList();
    }

    List<TraceItem> answers() {
        return List.copyOf(answers);
    }
}
