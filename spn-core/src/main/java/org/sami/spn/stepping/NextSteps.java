package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * The steps that robots, services and an operator without a mind of their own could take at one moment, as a test case says them. The
 * operator says yes or no, chooses all robots or one of them, each option or none, and gives what is proposed, else a sample; lists of
 * locations of several lengths. Robots answer a command one by one and begin with their tasks one after the other; services answer for all
 * at once; who connects is a robot that was not known. Nothing is answered again that a transition keeps already. What cannot be tried,
 * because no value can be made up for it, is reported.
 */
public final class NextSteps {
    /** How many locations the operator gives where nobody says how many. */
    public static final List<Integer> LOCATIONS = List.of(3);

    private static final int MOST_NEW_ROBOTS = 2;

    private final Stepper stepper;
    private final EngineView view;
    private final List<Integer> locations;
    private final TasksNow tasksNow;
    private final Set<NextStep> steps = new LinkedHashSet<>();
    private final Set<String> unlooked = new LinkedHashSet<>();

    private NextSteps(Stepper stepper, List<Integer> locations) {
        this.stepper = stepper;
        this.locations = locations;
        view = stepper.view();
        tasksNow = new TasksNow(stepper);
    }

    /**
     * What can be tried now.
     *
     * @param locations how many locations the operator gives where some are asked for; each is a step, the first is expected
     */
    public static NextSteps of(Stepper stepper, List<Integer> locations) {
        NextSteps next = new NextSteps(stepper, locations);
        Possible possible = stepper.possible();
        possible.decisions().forEach(next::decide);
        possible.activations().forEach(next::answer);
        possible.nextDueMillis()
                .ifPresent(due ->
                        next.add(NextStep.Kind.TIME, new TestStep.Advance(Math.max(0, due - stepper.nowMillis()))));
        possible.interrupts().forEach(next::press);
        possible.news().forEach(next::news);
        return next;
    }

    /** The steps, the expected ones first; some may turn out to change nothing. */
    public List<NextStep> steps() {
        List<NextStep> sorted = new ArrayList<>(steps);
        sorted.sort(Comparator.comparing(NextStep::kind));
        return List.copyOf(sorted);
    }

    /** What could happen here as well and is not among the steps, in a few words each: it could not be made up. */
    public Set<String> unlooked() {
        return unlooked;
    }

    private SampleValues samples(List<String> robots, List<TaskId> tasks, int size) {
        return new SampleValues(
                view.vocabulary(),
                robots.isEmpty() ? view.proxies() : robots,
                tasks.isEmpty() ? tasksNow.standing() : tasks,
                size);
    }

    private void add(NextStep.Kind kind, TestStep step) {
        steps.add(new NextStep(kind, step));
    }

    // ---- The operator

    private void decide(Decision decision) {
        String event = stepper.eventAsking(decision);
        Question question = decision.question();
        if (question instanceof Question.Approve) {
            reply(event, new TestStep.Reply.YesNo(true));
            reply(event, new TestStep.Reply.YesNo(false));
        } else if (question instanceof Question.ChooseProxies choose) {
            int most = Math.min(choose.max(), choose.proxies().size());
            reply(event, new TestStep.Reply.Proxies(choose.proxies().subList(0, most)));
            if (choose.min() <= 1 && most > 1) {
                choose.proxies().forEach(one -> reply(event, new TestStep.Reply.Proxies(List.of(one))));
            }
        } else if (question instanceof Question.ChooseOption choose) {
            for (int i = 0; i < choose.options().size(); i++) {
                reply(event, new TestStep.Reply.Option(i));
            }
            reply(event, new TestStep.Reply.Rejected());
        } else if (question instanceof Question.FillIn fillIn) {
            fillIn(event, fillIn);
        }
    }

    private void reply(String event, TestStep.Reply reply) {
        add(NextStep.Kind.DECISION, new TestStep.Answer(event, reply));
    }

    private void fillIn(String event, Question.FillIn fillIn) {
        List<Question.Item> items = fillIn.items().stream()
                .filter(item -> item.defaultValue().isEmpty())
                .toList();
        boolean asksLocations = items.stream().anyMatch(item -> isLocations(item.type()));
        for (int size : asksLocations ? locations : List.of(1)) {
            Map<String, Value> values = new LinkedHashMap<>();
            SampleValues samples = samples(List.of(), List.of(), size);
            items.forEach(item -> samples.of(item.type())
                    .ifPresentOrElse(
                            value -> values.put(item.key(), value),
                            () -> unlooked.add("the operator is asked for "
                                    + stepper.words().asked(item.key()) + ", and " + samples.whyNone(item.type()))));
            if (values.size() == items.size()) {
                NextStep.Kind kind = size == 0 ? NextStep.Kind.EMPTY : NextStep.Kind.DECISION;
                add(kind, new TestStep.Answer(event, new TestStep.Reply.Values(values)));
            }
        }
    }

    private static boolean isLocations(ValueType type) {
        return type instanceof ValueType.ListOf list && list.element() == ValueType.Simple.POINT;
    }

    private void press(InterruptButton button) {
        if (button.asksForProxies()) {
            view.proxies()
                    .forEach(robot -> add(NextStep.Kind.INTERRUPT, new TestStep.Press(button.name(), List.of(robot))));
        } else {
            add(NextStep.Kind.INTERRUPT, new TestStep.Press(button.name(), List.of()));
        }
    }

    // ---- Robots and services

    private void answer(Possible.OpenActivation open) {
        Activation asked = open.activation();
        EventType asking = view.vocabulary().event(asked.type()).orElseThrow();
        for (EventType type : open.answers()) {
            if (view.awaits(type.name())) {
                NextStep.Kind kind =
                        type.flags().contains(EventFlag.FAILURE) ? NextStep.Kind.FAILURE : NextStep.Kind.ANSWER;
                if (asking.tokens() == TokenNeed.NONE && type.tokens() == TokenNeed.PROXY) {
                    connect(type, asked, kind);
                } else {
                    named(type, asked, asking.flags().contains(EventFlag.COMMAND)).stream()
                            .filter(step -> !isKept(asked, step))
                            .forEach(step -> add(kind, step));
                }
            }
        }
    }

    /** Who asks for no robot and is answered with one gets one that takes no part yet; where there is none, another joins. */
    private void connect(EventType type, Activation asked, NextStep.Kind kind) {
        List<String> known = view.proxies();
        List<String> free = known.stream().filter(robot -> !takesPart(robot)).toList();
        if (!free.isEmpty()) {
            TestStep.Occur step = occur(type, asked.event(), free.subList(0, 1), List.of());
            if (!isKept(asked, step)) {
                add(kind, step);
            }
        } else if (known.size() < stepper.robotsAtStart() + MOST_NEW_ROBOTS) {
            add(kind, new TestStep.Join(newName(known)));
        } else {
            unlooked.add("more than " + MOST_NEW_ROBOTS + " robots that connect");
        }
    }

    private static String newName(List<String> known) {
        int number = known.size() + 1;
        while (known.contains("robot-" + number)) {
            number++;
        }
        return "robot-" + number;
    }

    private boolean takesPart(String robot) {
        return view.missions().stream()
                .flatMap(mission -> mission.marking().values().stream())
                .anyMatch(tokens -> tokens.contains(new Token.Proxy(robot)));
    }

    private List<TestStep.Occur> named(EventType type, Activation asked, boolean oneByOne) {
        boolean namesTasks = type.tokens() == TokenNeed.TASK || type.tokens() == TokenNeed.PROXY_OR_TASK;
        boolean namesRobots = type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK;
        List<TaskId> tasks = namesTasks ? asked.tasks() : List.of();
        List<String> robots = namesRobots ? asked.proxies() : List.of();
        List<TestStep.Occur> named = new ArrayList<>();
        if (oneByOne && !tasks.isEmpty()) {
            for (TaskId task : tasks) {
                List<String> robot = namesRobots && asked.allocation().containsKey(task)
                        ? List.of(asked.allocation().get(task))
                        : List.of();
                named.add(occur(type, asked.event(), robot, List.of(task)));
            }
        } else if (oneByOne && !robots.isEmpty()) {
            robots.forEach(robot -> named.add(occur(type, asked.event(), List.of(robot), List.of())));
        } else {
            named.add(occur(type, asked.event(), robots, tasks));
        }
        return named;
    }

    private TestStep.Occur occur(EventType type, String answers, List<String> robots, List<TaskId> tasks) {
        Map<String, Value> values = new LinkedHashMap<>();
        SampleValues samples = samples(robots, tasks, locations.get(0));
        for (FieldType field : type.fields()) {
            Optional<Value> value = field.defaultValue().or(() -> samples.of(field.type()));
            value.ifPresent(sample -> values.put(field.name(), sample));
            if (value.isEmpty() && field.required()) {
                unlooked.add(
                        type.title() + " is tried without its " + field.name() + ": " + samples.whyNone(field.type()));
            }
        }
        return new TestStep.Occur(
                type.name(), answers, robots, tasks.stream().map(TaskId::name).toList(), values);
    }

    private boolean isKept(Activation asked, TestStep.Occur step) {
        return view.pendingAnswers(asked.mission()).stream()
                .map(pending -> pending.occurrence())
                .anyMatch(kept -> kept.activation() == asked.id()
                        && kept.type().equals(step.type())
                        && kept.proxies().equals(step.proxies())
                        && kept.tasks().stream().map(TaskId::name).toList().equals(step.tasks()));
    }

    // ---- News

    private void news(EventType type) {
        if (type.tokens() == TokenNeed.TASK) {
            boolean starts = type.flags().contains(EventFlag.TASK_STARTED);
            tasksNow.concernedBy(type)
                    .forEach(task -> addNews(
                            starts ? NextStep.Kind.ANSWER : NextStep.Kind.NEWS,
                            occur(type, "", List.of(), List.of(task))));
        } else if (type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK) {
            view.proxies().forEach(robot -> addNews(NextStep.Kind.NEWS, occur(type, "", List.of(robot), List.of())));
        } else {
            addNews(NextStep.Kind.NEWS, occur(type, "", List.of(), List.of()));
        }
    }

    /** News of one kind that is kept already is not posted again: a newer one would only replace it. */
    private void addNews(NextStep.Kind kind, TestStep.Occur step) {
        boolean kept = view.missions().stream()
                .flatMap(mission -> view.pendingAnswers(mission.id()).stream())
                .map(pending -> pending.occurrence())
                .anyMatch(o -> o.activation() == Ids.NONE
                        && o.type().equals(step.type())
                        && o.proxies().equals(step.proxies())
                        && o.tasks().stream().map(TaskId::name).toList().equals(step.tasks()));
        if (!kept) {
            add(kind, step);
        }
    }
}
