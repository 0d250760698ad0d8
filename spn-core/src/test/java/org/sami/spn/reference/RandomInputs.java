package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * A world that treats a session badly: answers early, late and twice, names wrong boats, sends news, drops boats, presses
 * buttons. Sees the session's effects, so that most of what it says makes sense. A function of the seed and the effects.
 */
final class RandomInputs {
    private static final List<String> BOATS = List.of("A", "B", "C", "D");

    private final Random random;
    private final List<Activation> activations = new ArrayList<>();
    private final List<Decision> decisions = new ArrayList<>();
    private final List<Long> missions = new ArrayList<>();
    private final List<TaskId> tasks = new ArrayList<>();
    private final List<String> joined = new ArrayList<>();
    private long now;
    private int sent;

    RandomInputs(long seed) {
        random = new Random(seed * 31 + 7);
    }

    void saw(List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated a) {
                activations.add(a.activation());
                a.activation().tasks().stream().filter(t -> !tasks.contains(t)).forEach(tasks::add);
            } else if (effect instanceof Effect.DecisionOpened d) {
                decisions.add(d.decision());
            } else if (effect instanceof Effect.MissionStarted m) {
                missions.add(m.mission());
            }
        }
    }

    long nextTime(Subject subject) {
        if (chance(30)) {
            now += 100L * random.nextInt(30);
        }
        if (chance(8) && subject.nextDueMillis().isPresent()) {
            now = Math.max(now, subject.nextDueMillis().getAsLong() + random.nextInt(2));
        }
        return now;
    }

    Input next(Subject subject) {
        sent++;
        int boats = 1 + Math.abs(random.nextInt(3));
        if (sent <= boats) {
            return join();
        }
        if (missions.isEmpty() || (subject.statuses().isEmpty() && chance(90))) {
            return new Input.StartMission("main", "m", Map.of());
        }
        int die = random.nextInt(100);
        List<Decision> open = decisions.stream()
                .filter(d -> subject.openDecisions().contains(d.id()))
                .toList();
        if (!open.isEmpty() && (die < 30 || subject.statuses().containsValue("WAITING"))) {
            return decide(open.get(random.nextInt(open.size())));
        }
        if (die < 72 && !activations.isEmpty()) {
            return new Input.Received(answer(subject));
        }
        if (die < 84) {
            return new Input.Received(news());
        }
        return other();
    }

    private Input join() {
        String boat = BOATS.get(random.nextInt(BOATS.size()));
        if (!joined.contains(boat)) {
            joined.add(boat);
        }
        return new Input.ProxyJoined(boat);
    }

    // ---- Answers

    private Occurrence answer(Subject subject) {
        List<Activation> open = activations.stream()
                .filter(a -> subject.openActivations().contains(a.id()))
                .toList();
        List<Activation> from = open.isEmpty() || chance(12) ? activations : open;
        Activation activation = from.get(random.nextInt(from.size()));
        List<String> types = TestVocabulary.TEST
                .event(activation.type())
                .map(t -> t.answers())
                .filter(answers -> !answers.isEmpty())
                .orElse(List.of("Done"));
        String type = types.get(random.nextInt(types.size()));
        List<String> proxies = some(activation.proxies());
        List<TaskId> named = chance(70) ? someTasks(activation.tasks()) : List.of();
        if (chance(8)) {
            proxies = some(BOATS);
        }
        if (chance(6)) {
            proxies = List.of();
            named = List.of();
        }
        boolean everybody = chance(4) && open.contains(activation) && noClockRuns(subject);
        long mission = everybody ? Ids.NONE : activation.mission();
        return new Occurrence(type, mission, activation.id(), proxies, named, values(type));
    }

    /** Then what is open now is open when the input is taken. */
    private static boolean noClockRuns(Subject subject) {
        return subject.nextDueMillis().isEmpty();
    }

    private List<String> some(List<String> all) {
        if (all.isEmpty()) {
            return List.of();
        }
        if (chance(50)) {
            return List.of(all.get(random.nextInt(all.size())));
        }
        List<String> some = all.stream().filter(x -> chance(70)).toList();
        return some.isEmpty() ? all : some;
    }

    private List<TaskId> someTasks(List<TaskId> all) {
        return all.isEmpty() ? List.of() : List.of(all.get(random.nextInt(all.size())));
    }

    private Map<String, Value> values(String type) {
        return switch (type) {
            case "Provided" -> Map.of("number", new IntegerValue(random.nextInt(50)));
            case "Done", "Done2", "News", "Other" ->
                chance(80) ? Map.of("value", new IntegerValue(random.nextInt(50))) : Map.of();
            default -> Map.of();
        };
    }

    private Occurrence news() {
        String type = pick("News", "News", "Other", "Other", "Pose", "Done");
        List<String> proxies = chance(75) ? some(joined.isEmpty() || chance(10) ? BOATS : joined) : List.of();
        List<TaskId> named = chance(12) ? someTasks(tasks) : List.of();
        long mission = chance(30) ? anyMission() : Ids.NONE;
        return new Occurrence(type, mission, Ids.NONE, proxies, named, values(type));
    }

    private Input decide(Decision decision) {
        Answerer by = Answerer.OPERATOR;
        Question question = decision.question();
        if (question instanceof Question.Approve) {
            return new Input.AnswerDecision(decision.id(), new Answer.YesNo(chance(65)), by);
        }
        if (question instanceof Question.ChooseProxies choose) {
            return new Input.AnswerDecision(decision.id(), new Answer.Proxies(some(choose.proxies())), by);
        }
        if (question instanceof Question.ChooseOption) {
            Answer answer = chance(25) ? new Answer.Rejected() : new Answer.Option(random.nextInt(3));
            return new Input.AnswerDecision(decision.id(), answer, by);
        }
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : ((Question.FillIn) question).items()) {
            if (item.defaultValue().isEmpty() || chance(60)) {
                values.put(item.key(), new IntegerValue(random.nextInt(50)));
            }
        }
        return new Input.AnswerDecision(decision.id(), new Answer.Fields(values), by);
    }

    // ---- Everything else

    private Input other() {
        return switch (random.nextInt(16)) {
            case 0, 1, 2, 3 ->
                new Input.Interrupt(
                        chance(50) ? Ids.NONE : anyMission(),
                        pick("stop", "hold"),
                        chance(60) && !joined.isEmpty() ? some(joined) : List.of());
            case 4, 5 -> join();
            case 6 -> drop();
            case 7 -> new Input.AbortMission(chance(10) ? Ids.NONE : anyMission());
            case 8 -> new Input.CompleteMission(anyMission());
            case 9, 10, 11 -> allocate();
            case 12 ->
                new Input.SetVariable(
                        chance(50) ? Ids.NONE : anyMission(),
                        pick("@own", "@empty", "@global"),
                        new IntegerValue(random.nextInt(50)));
            case 13 ->
                new Input.AddTasks(anyMission(), List.of(new TaskSpec(pick("T1", "X1", "X2"), "Measure", Map.of())));
            case 14 -> chance(40) ? new Input.StartMission("main", "n", Map.of()) : new Input.TimeReached();
            default -> new Input.TimeReached();
        };
    }

    private Input drop() {
        if (joined.isEmpty()) {
            return new Input.TimeReached();
        }
        String boat = joined.get(random.nextInt(joined.size()));
        boolean fromAll = chance(50);
        if (fromAll) {
            joined.remove(boat);
        }
        return new Input.ProxyDropped(boat, fromAll ? Ids.NONE : missions.get(0));
    }

    private Input allocate() {
        if (tasks.isEmpty()) {
            return new Input.TimeReached();
        }
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        for (TaskId task : someTasks(tasks)) {
            allocation.put(
                    task,
                    chance(80) && !joined.isEmpty() ? Optional.of(some(joined).get(0)) : Optional.empty());
        }
        return new Input.AllocateTasks(allocation);
    }

    /** Mostly the newest mission and its relatives, sometimes one that is over. */
    private long anyMission() {
        return missions.get(random.nextInt(missions.size()));
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private String pick(String... choices) {
        return choices[random.nextInt(choices.length)];
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
