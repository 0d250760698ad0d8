package org.sami.spn.reference;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * A world around a session. Mostly it does what lets transitions fire ({@link Guide}), otherwise it treats the session badly:
 * answers early, late and twice, names wrong boats, sends news, drops boats, presses buttons. A function of the seed and of
 * the session's effects.
 */
final class RandomInputs {
    private static final List<String> BOATS = List.of("A", "B", "C", "D");

    private final Dice dice;
    private final Seen seen;
    private final Answering answering;
    private final Guide guide;
    /** What is still to be sent for the transition that was chosen last. */
    private final Deque<Input> planned = new ArrayDeque<>();

    /** For drops of whom a question or request names, and who answers it then; of its own, so that other choices do not depend on it. */
    private final Dice dropping;

    /** What is to be answered next, whoever has gone. */
    private Optional<Activation> toAnswer = Optional.empty();

    private Optional<String> askedOfDropped = Optional.empty();

    private final List<Input> loads;
    private final int boats;
    private long now;
    private int sent;

    RandomInputs(Project project, long seed) {
        this(project, seed, List.of());
    }

    /**
     * A world in which projects are loaded as well.
     *
     * @param loads what is loaded, any of it at any time
     */
    RandomInputs(Project project, long seed, List<Input> loads) {
        this.loads = loads;
        dice = new Dice(seed * 31 + 7);
        dropping = new Dice(seed * 43 + 11);
        seen = new Seen(project);
        answering = new Answering(dice);
        guide = new Guide(dice, seen, answering);
        boats = 1 + dice.below(3);
    }

    void saw(List<Effect> effects) {
        seen.saw(effects);
    }

    Seen seen() {
        return seen;
    }

    /** What asked of a boat that the latest input dropped; empty where that was no such drop. */
    Optional<String> askedOfDropped() {
        return askedOfDropped;
    }

    Scenario.Timed next(Subject subject) {
        sent++;
        askedOfDropped = Optional.empty();
        Input input = input(subject);
        if (dice.chance(20)) {
            now += 100L * dice.below(30);
        }
        boolean awaitsTime = input instanceof Input.TimeReached && dice.chance(85);
        if ((awaitsTime || dice.chance(5)) && subject.nextDueMillis().isPresent()) {
            now = Math.max(now, subject.nextDueMillis().getAsLong() + dice.below(2));
        }
        return new Scenario.Timed(now, input);
    }

    private Input input(Subject subject) {
        if (sent <= boats) {
            return join(BOATS.get(sent - 1));
        }
        if (!loads.isEmpty() && dice.chance(8)) {
            return dice.pick(loads);
        }
        if (toAnswer.isPresent()) {
            Activation asked = toAnswer.get();
            toAnswer = Optional.empty();
            if (subject.openActivations().contains(asked.id())) {
                return answerOfAll(subject, asked);
            }
        }
        if (dropping.chance(seen.openDecisions(subject).isEmpty() ? 3 : 9)) {
            Optional<Input> drop = dropOfAsked(subject);
            if (drop.isPresent()) {
                return drop.get();
            }
        }
        Map<Long, String> statuses = subject.statuses();
        boolean nothingRuns = statuses.values().stream().allMatch("HALTED"::equals);
        if (nothingRuns && dice.chance(90)) {
            return new Input.StartMission("main", "m", Map.of());
        }
        List<Decision> open = seen.openDecisions(subject);
        if (!open.isEmpty() && (dice.chance(7) || statuses.containsValue("WAITING"))) {
            Decision d = dice.pick(open);
            return new Input.AnswerDecision(d.id(), answering.any(d.question()), Answerer.OPERATOR);
        }
        if (open.stream().anyMatch(d -> d.deadlineMillis().isPresent()) && dice.chance(4)) {
            return hold(subject);
        }
        if (dice.chance(70)) {
            if (planned.isEmpty()) {
                planned.addAll(guide.next(subject));
            }
            if (!planned.isEmpty()) {
                return planned.remove();
            }
            if (dice.chance(50)) {
                return another(statuses); // nothing that runs waits for anything
            }
        }
        return hostile(subject);
    }

    /** Starts one more mission, or ends one of them. */
    private Input another(Map<Long, String> statuses) {
        List<Long> roots = statuses.keySet().stream().filter(seen::isRoot).toList();
        if (roots.size() < 3) {
            return new Input.StartMission("main", "n", Map.of());
        }
        long root = dice.pick(roots);
        return dice.chance(60) ? new Input.AbortMission(root) : new Input.CompleteMission(root);
    }

    private Input hostile(Subject subject) {
        int die = dice.below(100);
        if (die < 45 && !seen.activations.isEmpty()) {
            return new Input.Received(answer(subject));
        }
        return die < 60 ? new Input.Received(news()) : other(subject);
    }

    private Input join(String boat) {
        if (!seen.joined.contains(boat)) {
            seen.joined.add(boat);
        }
        return new Input.ProxyJoined(boat);
    }

    // ---- Answers and news, fitting or not

    private Occurrence answer(Subject subject) {
        List<Activation> open = seen.open(subject);
        List<Activation> from = open.isEmpty() || dice.chance(15) ? List.copyOf(seen.activations.values()) : open;
        Activation activation = dice.pick(from);
        List<String> types =
                TestVocabulary.TEST.event(activation.type()).orElseThrow().answers();
        String type = types.isEmpty() ? "Done" : dice.pick(types);
        List<String> proxies = dice.some(activation.proxies());
        List<TaskId> named = dice.chance(70) ? oneOf(activation.tasks()) : List.of();
        if (dice.chance(8)) {
            proxies = dice.some(BOATS);
        }
        if (dice.chance(6)) {
            proxies = List.of();
            named = List.of();
        }
        boolean everybody = dice.chance(6) && open.contains(activation) && noClockRuns(subject);
        long mission = everybody ? Ids.NONE : activation.mission();
        return new Occurrence(type, mission, activation.id(), proxies, named, answering.values(type));
    }

    /** Then what is open now is open when the input is taken. */
    private static boolean noClockRuns(Subject subject) {
        return subject.nextDueMillis().isEmpty();
    }

    private List<TaskId> oneOf(List<TaskId> all) {
        return all.isEmpty() ? List.of() : List.of(dice.pick(all));
    }

    private Occurrence news() {
        String type = dice.pick("News", "News", "Other", "Other", "Pose", "Done");
        List<String> proxies = dice.chance(75) ? dice.some(someBoats()) : List.of();
        List<TaskId> named = dice.chance(12) ? oneOf(seen.tasks) : List.of();
        long mission = dice.chance(30) && !seen.missions().isEmpty() ? anyMission() : Ids.NONE;
        return new Occurrence(type, mission, Ids.NONE, proxies, named, answering.values(type));
    }

    private List<String> someBoats() {
        return seen.joined.isEmpty() || dice.chance(10) ? BOATS : seen.joined;
    }

    // ---- Everything else

    private Input other(Subject subject) {
        return switch (dice.below(18)) {
            case 0, 1, 2 ->
                new Input.Interrupt(
                        dice.chance(50) ? Ids.NONE : anyMission(),
                        dice.pick("stop", "hold"),
                        dice.chance(60) ? dice.some(seen.joined) : List.of());
            case 3 -> join(dice.pick(BOATS));
            case 4 -> drop();
            case 5 -> new Input.AbortMission(dice.chance(10) ? Ids.NONE : anyMission());
            case 6 -> new Input.CompleteMission(anyMission());
            case 7, 8, 9 -> allocate();
            case 10, 11 ->
                new Input.SetVariable(
                        dice.chance(40) ? Ids.NONE : anyMission(), RandomPlans.variable(dice), anyValue());
            case 12 ->
                new Input.AddTasks(
                        anyMission(), List.of(new TaskSpec(dice.pick("T1", "X1", "X2"), "Measure", Map.of())));
            case 13 -> dice.chance(50) ? describe() : hold(subject);
            case 14 -> dice.chance(30) ? new Input.StartMission("main", "n", Map.of()) : new Input.TimeReached();
            default -> new Input.TimeReached();
        };
    }

    private Value anyValue() {
        return dice.chance(15) ? new TextValue("of no use") : new IntegerValue(dice.below(50));
    }

    /** What a boat is called, by which questions may be filtered. */
    private Input describe() {
        return new Input.Remember(
                Ids.NONE, "description/" + dice.pick(BOATS), new TextValue(dice.pick("shore", "water", "")));
    }

    /** Mostly a decision for which a clock runs, as far as one is known. */
    private Input hold(Subject subject) {
        List<Decision> open = seen.openDecisions(subject);
        List<Decision> timed =
                open.stream().filter(d -> d.deadlineMillis().isPresent()).toList();
        if (timed.isEmpty() || dice.chance(10)) {
            return open.isEmpty()
                    ? new Input.TimeReached()
                    : new Input.HoldDecision(dice.pick(open).id());
        }
        return new Input.HoldDecision(dice.pick(timed).id());
    }

    private Input drop() {
        if (seen.joined.isEmpty()) {
            return new Input.TimeReached();
        }
        String boat = dice.pick(seen.joined);
        boolean fromAll = dice.chance(40);
        if (fromAll) {
            seen.joined.remove(boat);
        }
        List<Long> roots = seen.missions().stream().filter(seen::isRoot).toList();
        return new Input.ProxyDropped(boat, fromAll || roots.isEmpty() ? Ids.NONE : roots.get(roots.size() - 1));
    }

    /** Drops a boat that something open was asked of, besides others; that is answered next. */
    private Optional<Input> dropOfAsked(Subject subject) {
        List<Activation> asked = seen.open(subject).stream()
                .filter(a -> a.proxies().size() > 1 && !answers(a).isEmpty())
                .toList();
        if (asked.isEmpty()) {
            return Optional.empty();
        }
        List<String> types = asked.stream().map(Activation::type).distinct().toList();
        if (types.size() > 1) {
            types = types.stream().filter(kind -> !kind.equals("Do")).toList(); // most is asked by it
        }
        String type = dropping.pick(types);
        Activation one =
                dropping.pick(asked.stream().filter(a -> a.type().equals(type)).toList());
        String boat = dropping.pick(one.proxies());
        boolean fromAll = dropping.chance(25);
        if (fromAll) {
            seen.joined.remove(boat);
        }
        toAnswer = Optional.of(one);
        askedOfDropped = Optional.of(type);
        return Optional.of(new Input.ProxyDropped(boat, fromAll ? Ids.NONE : one.rootMission()));
    }

    private static List<String> answers(Activation asked) {
        return TestVocabulary.TEST.event(asked.type()).orElseThrow().answers();
    }

    /** An answer that names all who were asked, whether they are still there or not. */
    private Input answerOfAll(Subject subject, Activation asked) {
        Optional<Decision> open = seen.openDecisions(subject).stream()
                .filter(d -> d.activation() == asked.id())
                .findFirst();
        if (open.isPresent()) {
            return new Input.AnswerDecision(
                    open.get().id(),
                    answering.fitting(open.get().question(), true, asked.proxies()),
                    Answerer.OPERATOR);
        }
        String type = dropping.pick(answers(asked));
        List<TaskId> tasks = dropping.chance(50) ? asked.tasks() : List.of();
        return new Input.Received(
                new Occurrence(type, asked.mission(), asked.id(), asked.proxies(), tasks, answering.values(type)));
    }

    private Input allocate() {
        if (seen.tasks.isEmpty()) {
            return new Input.TimeReached();
        }
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        for (TaskId task : dice.some(seen.tasks)) {
            allocation.put(
                    task,
                    dice.chance(80) && !seen.joined.isEmpty() ? Optional.of(dice.pick(seen.joined)) : Optional.empty());
        }
        return new Input.AllocateTasks(allocation);
    }

    /** Mostly one that runs or is just over, sometimes one that never was. */
    private long anyMission() {
        List<Long> missions = seen.missions();
        if (missions.isEmpty()) {
            return 1;
        }
        return missions.get(
                dice.chance(60) ? Math.max(0, missions.size() - 1 - dice.below(3)) : dice.below(missions.size()));
    }

    /** Whom a token is about, for printing. */
    static String word(Token token) {
        if (token instanceof Token.Proxy boat) {
            return boat.proxy();
        }
        return token instanceof Token.Task task
                ? task.task().mission() + "/" + task.task().name()
                : "*";
    }
}
