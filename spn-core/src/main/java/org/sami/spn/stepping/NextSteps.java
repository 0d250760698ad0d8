package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * The steps that robots, services and an operator without a mind of their own could take at one moment, as a test case says them. The
 * operator says yes or no, chooses all robots or one of them, each option or none, and gives what is proposed, else a sample. Robots answer
 * a command one by one, services answer for all at once, with samples as values. Nothing is answered again that a transition keeps already.
 */
public final class NextSteps {
    private final Stepper stepper;
    private final EngineView view;
    private final SampleValues samples;
    private final Set<NextStep> steps = new LinkedHashSet<>();

    private NextSteps(Stepper stepper) {
        this.stepper = stepper;
        view = stepper.view();
        samples = new SampleValues(view.vocabulary(), view.proxies(), tasks());
    }

    /** The steps that can be tried now, the expected ones first; some may turn out to change nothing. */
    public static List<NextStep> of(Stepper stepper) {
        NextSteps next = new NextSteps(stepper);
        Possible possible = stepper.possible();
        possible.decisions().forEach(next::decide);
        possible.activations().forEach(next::answer);
        possible.nextDueMillis()
                .ifPresent(due ->
                        next.add(NextStep.Kind.TIME, new TestStep.Advance(Math.max(0, due - stepper.nowMillis()))));
        possible.interrupts().forEach(next::press);
        possible.news().forEach(next::news);
        List<NextStep> sorted = new ArrayList<>(next.steps);
        sorted.sort(Comparator.comparing(NextStep::kind));
        return List.copyOf(sorted);
    }

    private List<TaskId> tasks() {
        return view.mission(stepper.mission())
                .flatMap(mission -> view.planOf(mission.id()))
                .map(plan -> plan.tasks().stream()
                        .map(task -> new TaskId(stepper.mission(), task.name()))
                        .toList())
                .orElse(List.of());
    }

    private void add(NextStep.Kind kind, TestStep step) {
        steps.add(new NextStep(kind, step));
    }

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
            Map<String, Value> values = new LinkedHashMap<>();
            fillIn.items().stream()
                    .filter(item -> item.defaultValue().isEmpty())
                    .forEach(item -> samples.of(item.type()).ifPresent(value -> values.put(item.key(), value)));
            reply(event, new TestStep.Reply.Values(values));
        }
    }

    private void reply(String event, TestStep.Reply reply) {
        add(NextStep.Kind.DECISION, new TestStep.Answer(event, reply));
    }

    private void answer(Possible.OpenActivation open) {
        Activation asked = open.activation();
        boolean oneByOne = view.vocabulary()
                .event(asked.type())
                .filter(type -> type.flags().contains(EventFlag.COMMAND))
                .isPresent();
        for (EventType type : open.answers()) {
            if (view.awaits(type.name())) {
                named(type, asked, oneByOne).stream()
                        .filter(step -> !isKept(asked, step))
                        .forEach(step -> add(
                                type.flags().contains(EventFlag.FAILURE) ? NextStep.Kind.FAILURE : NextStep.Kind.ANSWER,
                                step));
            }
        }
    }

    private List<TestStep.Occur> named(EventType type, Activation asked, boolean oneByOne) {
        boolean namesTasks = type.tokens() == TokenNeed.TASK || type.tokens() == TokenNeed.PROXY_OR_TASK;
        boolean namesRobots = type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK;
        List<TaskId> tasks = asked.tasks().stream()
                .filter(task -> namesTasks && task.mission() == stepper.mission())
                .toList();
        List<String> robots = namesRobots ? asked.proxies() : List.of();
        List<TestStep.Occur> steps = new ArrayList<>();
        if (oneByOne && !tasks.isEmpty()) {
            for (TaskId task : tasks) {
                List<String> robot = namesRobots && asked.allocation().containsKey(task)
                        ? List.of(asked.allocation().get(task))
                        : List.of();
                steps.add(occur(type, asked.event(), robot, List.of(task.name())));
            }
        } else if (oneByOne && !robots.isEmpty()) {
            robots.forEach(robot -> steps.add(occur(type, asked.event(), List.of(robot), List.of())));
        } else {
            steps.add(occur(
                    type,
                    asked.event(),
                    robots,
                    tasks.stream().map(TaskId::name).toList()));
        }
        return steps;
    }

    private TestStep.Occur occur(EventType type, String answers, List<String> robots, List<String> tasks) {
        Map<String, Value> values = new LinkedHashMap<>();
        type.fields()
                .forEach(field -> field.defaultValue()
                        .or(() -> samples.of(field.type()))
                        .ifPresent(value -> values.put(field.name(), value)));
        return new TestStep.Occur(type.name(), answers, robots, tasks, values);
    }

    private boolean isKept(Activation asked, TestStep.Occur step) {
        return view.pendingAnswers(asked.mission()).stream()
                .map(pending -> pending.occurrence())
                .anyMatch(kept -> kept.activation() == asked.id()
                        && kept.type().equals(step.type())
                        && kept.proxies().equals(step.proxies())
                        && kept.tasks().stream().map(TaskId::name).toList().equals(step.tasks()));
    }

    private void press(InterruptButton button) {
        if (button.asksForProxies()) {
            view.proxies()
                    .forEach(robot -> add(NextStep.Kind.INTERRUPT, new TestStep.Press(button.name(), List.of(robot))));
        } else {
            add(NextStep.Kind.INTERRUPT, new TestStep.Press(button.name(), List.of()));
        }
    }

    private void news(EventType type) {
        boolean namesRobots = type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK;
        if (namesRobots) {
            view.proxies().forEach(robot -> addNews(occur(type, "", List.of(robot), List.of())));
        } else if (type.tokens() == TokenNeed.TASK) {
            tasks().forEach(task -> addNews(occur(type, "", List.of(), List.of(task.name()))));
        } else {
            addNews(occur(type, "", List.of(), List.of()));
        }
    }

    /** News of one kind that is kept already is not told again: a newer one would only replace it. */
    private void addNews(TestStep.Occur step) {
        boolean kept = view.missions().stream()
                .flatMap(mission -> view.pendingAnswers(mission.id()).stream())
                .map(pending -> pending.occurrence())
                .anyMatch(o -> o.activation() == Ids.NONE
                        && o.type().equals(step.type())
                        && o.proxies().equals(step.proxies()));
        if (!kept) {
            add(NextStep.Kind.NEWS, step);
        }
    }
}
