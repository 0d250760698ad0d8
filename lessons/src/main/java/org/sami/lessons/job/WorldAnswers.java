package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Who answers what when in a hidden case, and what: what the script says, else that all goes well. */
final class WorldAnswers {
    private static final long OPERATOR_MILLIS = 1000;
    private static final long FIRST_ROBOT_MILLIS = 2000;
    private static final long NEXT_ROBOT_MILLIS = 1000;

    private final Stepper stepper;
    private final JobCase job;
    private final WorldTrace trace;
    private final Reactions reactions;
    private final WorldHappenings happenings;
    private final Map<String, Long> busyUntil = new HashMap<>();
    private final Map<String, Integer> times = new HashMap<>();
    private int connects;

    WorldAnswers(Stepper stepper, JobCase job, WorldTrace trace) {
        this.stepper = stepper;
        this.job = job;
        this.trace = trace;
        reactions = new Reactions(job);
        happenings = new WorldHappenings(stepper, job, trace);
    }

    /** An answer that is to be given. */
    record Given(long at, String key, Supplier<List<TakenStep>> how) {
        List<TakenStep> act() {
            return how.get();
        }
    }

    WorldHappenings happenings() {
        return happenings;
    }

    private EngineView view() {
        return stepper.view();
    }

    private Vocabulary vocabulary() {
        return view().vocabulary();
    }

    private EventType type(String name) {
        return vocabulary().event(name).orElseThrow();
    }

    // ---- What is asked of whom

    /** The questions that an activation asks of robots and services. */
    List<Asked> asked(Activation activation) {
        EventType type = type(activation.type());
        Answering by = Answering.of(type, vocabulary());
        List<Asked> asked = new ArrayList<>();
        switch (by) {
            case ROBOTS, TASKS -> {
                for (TaskId task : WorldTrace.tasks(type, activation)) {
                    List<String> robot = Optional.ofNullable(
                                    activation.allocation().get(task))
                            .stream()
                            .toList();
                    if (by == Answering.TASKS || !robot.isEmpty()) {
                        asked.add(question(by, type, robot, List.of(task), activation));
                    }
                }
                if (by == Answering.ROBOTS) {
                    WorldTrace.robots(type, activation)
                            .forEach(robot -> asked.add(question(by, type, List.of(robot), List.of(), activation)));
                }
            }
            case SERVICE -> {
                List<String> robots = WorldTrace.robots(type, activation);
                List<TaskId> tasks = robots.isEmpty() ? WorldTrace.tasks(type, activation) : List.of();
                if (type.tokens() == TokenNeed.NONE || !robots.isEmpty() || !tasks.isEmpty()) {
                    asked.add(question(by, type, robots, tasks, activation));
                }
            }
            case NEW_ROBOT -> asked.add(question(by, type, List.of(), List.of(), activation));
            case OPERATOR, NOBODY -> {
                // the operator is asked by a decision
            }
        }
        return asked;
    }

    private Asked question(
            Answering by, EventType type, List<String> robots, List<TaskId> tasks, Activation activation) {
        return new Asked(by, type.name(), robots, tasks, numbers(tasks), Optional.of(activation), Optional.empty());
    }

    private List<Integer> numbers(List<TaskId> tasks) {
        return tasks.stream().map(task -> trace.number(task, view())).toList();
    }

    /** A question to the operator. */
    Asked asked(Decision decision, Optional<Activation> activation) {
        List<TaskId> tasks = activation.map(Activation::tasks).orElse(List.of());
        return new Asked(
                Answering.OPERATOR,
                activation.map(asking -> type(asking.type()).name()).orElse(""),
                activation.map(Activation::proxies).orElse(List.of()),
                tasks,
                numbers(tasks),
                activation,
                Optional.of(decision));
    }

    /** What a mission asks before it starts, by types of events and fields; empty where the question is another. */
    Optional<List<String>> fieldsAsked(Decision decision) {
        if (!(decision.question() instanceof Question.FillIn fillIn)) {
            return Optional.empty();
        }
        List<OutputEventSpec> events = view().project().plans().stream()
                .map(Plan::places)
                .flatMap(List::stream)
                .flatMap(place -> place.outputs().stream())
                .toList();
        return Optional.of(fillIn.items().stream()
                .map(item -> {
                    int dot = item.key().indexOf('.');
                    String id = dot < 0 ? "" : item.key().substring(0, dot);
                    return events.stream()
                            .filter(event -> event.id().equals(id))
                            .findFirst()
                            .map(event -> type(event.type()).name() + item.key().substring(dot))
                            .orElse("a variable");
                })
                .toList());
    }

    // ---- Answers

    /** The answer to a question; empty where it is never answered. */
    Optional<Given> answer(Asked asked, long now) {
        Optional<JobCase.Reaction> reaction = reactions.next(asked.type(), asked.robots(), asked.numbers());
        boolean isSilent = reaction.map(JobCase.Reaction::isSilent)
                .orElse(!asked.type().isEmpty() && Answering.isSilent(type(asked.type())));
        if (isSilent) {
            return Optional.empty();
        }
        int time = times.merge(asked.type(), 1, Integer::sum);
        String question = asked.type() + time;
        return switch (asked.by()) {
            case OPERATOR ->
                Optional.of(new Given(
                        now + after(reaction, OPERATOR_MILLIS),
                        "2 " + asked.key(),
                        () -> decide(asked, reaction, question)));
            case ROBOTS -> byRobot(asked, reaction, question, now);
            case NEW_ROBOT -> {
                long due = now + after(reaction, FIRST_ROBOT_MILLIS + NEXT_ROBOT_MILLIS * connects++);
                yield Optional.of(new Given(due, "3 " + asked.key(), () -> happenings.connect(asked, reaction)));
            }
            case SERVICE, TASKS ->
                answerType(asked, reaction)
                        .map(type -> new Given(
                                now + after(reaction, 0),
                                "0 " + asked.key(),
                                () -> occur(asked, type, reaction, question)));
            case NOBODY -> Optional.empty();
        };
    }

    private static long after(Optional<JobCase.Reaction> reaction, long otherwise) {
        return reaction.isPresent() ? reaction.get().afterMillis().orElse(otherwise) : otherwise;
    }

    /** A robot does one thing after another. */
    private Optional<Given> byRobot(Asked asked, Optional<JobCase.Reaction> reaction, String question, long now) {
        Optional<EventType> type = answerType(asked, reaction);
        String robot = asked.robots().get(0);
        int index = view().proxies().indexOf(robot);
        if (type.isEmpty() || index < 0) {
            return Optional.empty();
        }
        long from = Math.max(now, busyUntil.getOrDefault(robot, 0L));
        long due = from + after(reaction, FIRST_ROBOT_MILLIS + NEXT_ROBOT_MILLIS * index);
        busyUntil.put(robot, due);
        return Optional.of(new Given(due, "3 " + asked.key(), () -> occur(asked, type.get(), reaction, question)));
    }

    /** The answer that the script names, else the first that does not tell of a failure. */
    private Optional<EventType> answerType(Asked asked, Optional<JobCase.Reaction> reaction) {
        String said = reaction.map(JobCase.Reaction::answer).orElse("");
        if (!said.isEmpty()) {
            return vocabulary().event(said);
        }
        return type(asked.type()).answers().stream()
                .flatMap(name -> vocabulary().event(name).stream())
                .filter(type -> !type.flags().contains(EventFlag.FAILURE))
                .findFirst();
    }

    private List<TakenStep> decide(Asked asked, Optional<JobCase.Reaction> reaction, String question) {
        long id = asked.decision().orElseThrow().id();
        Optional<Decision> open =
                view().decisions().stream().filter(one -> one.id() == id).findFirst();
        if (open.isEmpty()) {
            return List.of();
        }
        WorldValues values = WorldValues.asked(question, view(), job.locations());
        Optional<Answer> answer = new OperatorReply(reaction, values, view().proxies(), vocabulary())
                .to(
                        open.get().question(),
                        asked.activation().flatMap(asking -> type(asking.type()).decision()));
        trace.answered(stepper.nowMillis(), asked.type(), asked.robots(), asked.numbers());
        return answer.map(given -> List.of(stepper.answer(id, given))).orElse(List.of());
    }

    private List<TakenStep> occur(Asked asked, EventType type, Optional<JobCase.Reaction> reaction, String question) {
        Activation activation = asked.activation().orElseThrow();
        List<String> known =
                asked.robots().stream().filter(view().proxies()::contains).toList();
        if (!asked.robots().isEmpty() && known.isEmpty()) {
            return List.of(); // it was dropped meanwhile
        }
        boolean namesTasks = type.tokens() == TokenNeed.TASK || type.tokens() == TokenNeed.PROXY_OR_TASK;
        boolean namesRobots = type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK;
        List<String> workers = asked.by() == Answering.SERVICE && known.isEmpty() ? ofMission(activation) : known;
        if (asked.by() == Answering.SERVICE && type(asked.type()).tokens() != TokenNeed.NONE && workers.isEmpty()) {
            return List.of(); // there is nobody to do it
        }
        WorldValues values = WorldValues.answering(activation, inOrder(workers), question, view(), job.locations());
        trace.answered(stepper.nowMillis(), type.name(), known, asked.numbers());
        return List.of(stepper.occur(
                activation.id(),
                type.name(),
                namesRobots ? known : List.of(),
                namesTasks ? asked.tasks() : List.of(),
                values.fields(type, reaction.map(JobCase.Reaction::values).orElse(Map.of()))));
    }

    private List<String> inOrder(List<String> robots) {
        return view().proxies().stream().filter(robots::contains).toList();
    }

    private List<String> ofMission(Activation activation) {
        Set<String> robots = new LinkedHashSet<>();
        for (MissionView mission : view().missions()) {
            if (mission.id() == activation.mission()) {
                mission.marking()
                        .values()
                        .forEach(tokens -> tokens.forEach(token -> {
                            if (token instanceof Token.Proxy proxy) {
                                robots.add(proxy.proxy());
                            }
                        }));
            }
        }
        return robots.isEmpty() ? view().proxies() : List.copyOf(robots);
    }
}
