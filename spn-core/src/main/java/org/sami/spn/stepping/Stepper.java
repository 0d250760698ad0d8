package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Tries one plan step by step on the engine itself, forwards and back. Each step keeps the state before it, so a
 * stepper is for runs of people's length; a {@link #branch} begins again from where it is. Steps that cannot be taken change nothing and say why. Used by one thread at a
 * time.
 */
public final class Stepper {
    /** One step on the way here: how it was before, what was done, and how a test case says that. */
    private record Past(Moment before, TakenStep taken, TestStep recorded, Optional<String> notRecorded) {}

    private final Engine engine;
    private final String plan;
    private final List<String> proxies;
    private final Optional<TestStart> from;
    private final List<Effect> startEffects = new ArrayList<>();
    private final List<Past> past = new ArrayList<>();
    private Moment now;

    private Stepper(Engine engine, String plan, List<String> proxies, Optional<TestStart> from, Moment now) {
        this.engine = Objects.requireNonNull(engine, "engine");
        this.plan = Objects.requireNonNull(plan, "plan");
        this.proxies = List.copyOf(proxies);
        this.from = from;
        this.now = now;
    }

    private static Stepper knowing(List<String> proxies, Engine engine, String plan, Optional<TestStart> from) {
        Stepper stepper = new Stepper(engine, plan, proxies, from, new Moment(engine.newState()));
        proxies.forEach(p -> stepper.run(stepper.now, new Input.ProxyJoined(p), stepper.startEffects));
        return stepper;
    }

    /**
     * Starts a plan of the engine's project from its start place. What it asks at its start is an open decision then.
     *
     * @param plan its id
     * @param name of the mission
     * @param proxies the robots known at the start
     * @throws IllegalArgumentException with the reason if the plan cannot start
     */
    public static Stepper start(Engine engine, String plan, String name, List<String> proxies) {
        Stepper stepper = knowing(proxies, engine, plan, Optional.empty());
        stepper.run(stepper.now, new Input.StartMission(plan, name, Map.of()), stepper.startEffects);
        rejection(stepper.startEffects).ifPresent(reason -> {
            throw new IllegalArgumentException(reason);
        });
        return stepper;
    }

    /**
     * Starts a plan from a marking of one's own, such as the middle of it. What it asks at its start and is not given has its
     * default.
     *
     * @param parameters as in {@link Input.StartMission}
     * @throws IllegalArgumentException with the reason if the plan cannot start so
     */
    public static Stepper startAt(
            Engine engine,
            String plan,
            String name,
            List<String> proxies,
            StartMarking marking,
            Map<String, Value> parameters) {
        Stepper stepper = knowing(proxies, engine, plan, Optional.of(new TestStart(marking, parameters)));
        engine.startAt(stepper.now.state, 0, new Input.StartMission(plan, name, parameters), marking, effect -> {
                    stepper.startEffects.add(effect);
                    stepper.now.saw(effect, engine.vocabulary());
                })
                .ifPresent(reason -> {
                    throw new IllegalArgumentException(reason);
                });
        return stepper;
    }

    /**
     * Starts a plan as one of its test cases does, without taking its steps.
     *
     * @throws IllegalArgumentException with the reason if the plan cannot start so
     */
    public static Stepper startAs(Engine engine, String plan, TestCase test) {
        return test.start().isEmpty()
                ? start(engine, plan, test.name(), test.proxies())
                : startAt(
                        engine,
                        plan,
                        test.name(),
                        test.proxies(),
                        test.start().get().marking(),
                        test.start().get().values());
    }

    /** A stepper of its own that has taken the same steps: what one of them does from now on, the other does not see. */
    public Stepper fork() {
        Stepper fork = branch();
        fork.startEffects.addAll(startEffects);
        fork.past.addAll(past);
        return fork;
    }

    /** A stepper of its own that stands at the same moment and has nothing to take back; it holds that moment only. */
    public Stepper branch() {
        return new Stepper(engine, plan, proxies, from, now);
    }

    /** As {@link #branch}, sharing nothing that changes: what it does may be done on another thread. */
    Stepper apart() {
        return new Stepper(engine, plan, proxies, from, now.copy());
    }

    // ---- Steps

    /**
     * Takes a step as a test case says it. An expectation is a step that changes nothing, and is refused where it is not so.
     */
    public TakenStep take(TestStep step) {
        if (step instanceof TestStep.Answer s) {
            Optional<Decision> decision = meaning().decision(s.event());
            return decision.isEmpty()
                    ? refused("nothing is asked of the operator by \"" + words().deciding(s.event()) + "\"")
                    : step(meaning().answer(s.reply(), decision.get()), s);
        } else if (step instanceof TestStep.Occur s) {
            return occur(s);
        } else if (step instanceof TestStep.Press s) {
            return step(new Input.Interrupt(Ids.NONE, s.interrupt(), s.proxies()), s);
        } else if (step instanceof TestStep.Join s) {
            return step(new Input.ProxyJoined(s.proxy()), s);
        } else if (step instanceof TestStep.Drop s) {
            return step(new Input.ProxyDropped(s.proxy(), now.mission), s);
        } else if (step instanceof TestStep.Advance s) {
            return advance(s.millis());
        } else if (step instanceof TestStep.ExpectTokens s) {
            return expect(s, expectations().tokens(s));
        }
        return expect(step, expectations().ended());
    }

    private TakenStep occur(TestStep.Occur s) {
        if (s.answers().isEmpty()) {
            return step(meaning().news(s), s);
        }
        Optional<Activation> asked = meaning().activation(s);
        return asked.isEmpty()
                ? refused("\"" + words().asking(s.answers(), s.type()) + "\" has asked for nothing that "
                        + engine.vocabulary().title(s.type()) + " could answer")
                : step(meaning().answer(s, asked.get()), s);
    }

    private TakenStep expect(TestStep step, Optional<String> difference) {
        return difference.isPresent() ? refused(difference.get()) : taken(now, List.of(), step, Optional.empty());
    }

    /** The operator answers an open decision. */
    public TakenStep answer(long decision, Answer answer) {
        Optional<Decision> open =
                view().decisions().stream().filter(d -> d.id() == decision).findFirst();
        if (open.isEmpty()) {
            return refused("the decision " + decision + " is not open");
        }
        String event = meaning().eventOf(open.get());
        Optional<String> other =
                meaning().decision(event).filter(d -> d.id() == decision).isPresent()
                        ? Optional.empty()
                        : Optional.of("it answers another than the oldest open decision of \"" + words().deciding(event)
                                + "\"");
        return step(
                new Input.AnswerDecision(decision, answer, Answerer.OPERATOR),
                new TestStep.Answer(event, StepMeaning.reply(answer)),
                other);
    }

    /** An input event answers an activation whose visit has not ended, as a handler would. */
    public TakenStep occur(
            long activation, String type, List<String> robots, List<TaskId> tasks, Map<String, Value> values) {
        Optional<Activation> open = view().openActivations().stream()
                .filter(a -> a.id() == activation)
                .findFirst();
        if (open.isEmpty()) {
            return refused("the activation " + activation + " is not open: nothing waits for "
                    + engine.vocabulary().title(type));
        }
        TestStep.Occur said = new TestStep.Occur(type, open.get().event(), robots, names(tasks), values);
        Optional<String> other =
                meaning().activation(said).filter(a -> a.id() == activation).isPresent()
                        ? ofAnotherMission(tasks.stream()
                                .filter(task -> !open.get().tasks().contains(task))
                                .toList())
                        : Optional.of("of the open activations of \""
                                + words().asking(open.get().event(), type)
                                + "\" it answers another than a test case would");
        return step(new Input.Received(Occurrence.answer(type, open.get(), robots, tasks, values)), said, other);
    }

    /** An input event arrives that answers nothing. */
    public TakenStep news(String type, List<String> robots, List<TaskId> tasks, Map<String, Value> values) {
        TestStep.Occur said = new TestStep.Occur(type, "", robots, names(tasks), values);
        long about = tasks.isEmpty() ? Ids.NONE : tasks.get(0).mission();
        Occurrence occurrence = new Occurrence(type, about, Ids.NONE, robots, tasks, values);
        return step(new Input.Received(occurrence), said, ofAnotherMission(tasks));
    }

    private Optional<String> ofAnotherMission(List<TaskId> tasks) {
        return tasks.stream()
                .filter(task -> task.mission() != now.mission)
                .findFirst()
                .map(task -> "it names the task \"" + task.name() + "\" of a sub-mission");
    }

    private static List<String> names(List<TaskId> tasks) {
        return tasks.stream().map(TaskId::name).toList();
    }

    /** Lets time pass: what is due runs down, each at its own time. */
    public TakenStep advance(long millis) {
        TestStep.Advance said = new TestStep.Advance(millis);
        Moment after = now.copy();
        List<Effect> effects = new ArrayList<>();
        long until = now.nowMillis + millis;
        OptionalLong due = engine.view(after.state).nextDueMillis();
        while (due.isPresent() && due.getAsLong() < until) {
            after.nowMillis = Math.max(after.nowMillis, due.getAsLong());
            run(after, new Input.TimeReached(), effects);
            due = engine.view(after.state).nextDueMillis();
        }
        after.nowMillis = until;
        run(after, new Input.TimeReached(), effects);
        return taken(after, effects, said, Optional.empty());
    }

    /** Lets time pass until the next timer or deadline runs down; refused where none runs. */
    public TakenStep advanceToNextTimer() {
        OptionalLong due = view().nextDueMillis();
        return due.isEmpty()
                ? refused("no timer runs and no decision has a deadline")
                : advance(Math.max(0, due.getAsLong() - now.nowMillis));
    }

    private TakenStep step(Input input, TestStep said) {
        return step(input, said, Optional.empty());
    }

    private TakenStep step(Input input, TestStep said, Optional<String> notRecorded) {
        Moment after = now.copy();
        List<Effect> effects = new ArrayList<>();
        if (input instanceof Input.Received received) {
            engine.vocabulary()
                    .event(received.occurrence().type())
                    .ifPresent(type ->
                            after.tasks.received(type, received.occurrence().tasks()));
        }
        run(after, input, effects);
        Optional<String> rejection = rejection(effects);
        return rejection.isPresent() ? refused(rejection.get()) : taken(after, effects, said, notRecorded);
    }

    /** Why the engine changed nothing. Where it says so of a part only, the step was taken. */
    private static Optional<String> rejection(List<Effect> effects) {
        boolean nothingElse = effects.stream().allMatch(Effect.Noted.class::isInstance);
        return effects.stream()
                .filter(e -> nothingElse && e instanceof Effect.Noted n && n.kind() == NoteKind.REJECTED_INPUT)
                .map(e -> ((Effect.Noted) e).message())
                .findFirst();
    }

    private void run(Moment on, Input input, List<Effect> effects) {
        engine.step(on.state, on.nowMillis, input, effect -> {
            effects.add(effect);
            on.saw(effect, engine.vocabulary());
        });
    }

    private TakenStep taken(Moment after, List<Effect> effects, TestStep said, Optional<String> notRecorded) {
        TakenStep taken = new TakenStep(past.size() + 1, effects, Optional.empty());
        past.add(new Past(now, taken, said, notRecorded));
        now = after;
        return taken;
    }

    private TakenStep refused(String reason) {
        return new TakenStep(past.size(), List.of(), Optional.of(reason));
    }

    /**
     * Undoes the last steps: everything is as it was before them.
     *
     * @throws IllegalArgumentException if fewer steps were taken
     */
    public void back(int steps) {
        if (steps < 0 || steps > past.size()) {
            throw new IllegalArgumentException("There are " + past.size() + " steps to go back, not " + steps);
        }
        for (int i = 0; i < steps; i++) {
            now = past.remove(past.size() - 1).before();
        }
    }

    // ---- Questions

    /** The words for steps of its plan. */
    public StepText words() {
        return StepText.of(engine.project(), plan, engine.vocabulary());
    }

    /** The steps taken, in order, without those that were refused or undone. */
    public List<TakenStep> steps() {
        return past.stream().map(Past::taken).toList();
    }

    /** What the start did. */
    public List<Effect> startEffects() {
        return List.copyOf(startEffects);
    }

    /** What can happen now. */
    public Possible possible() {
        return Possible.of(view(), engine.vocabulary());
    }

    /** Id of the output event that asks a decision; empty text where the mission asks at its start, or the engine itself does. */
    public String eventAsking(Decision decision) {
        return meaning().eventOf(decision);
    }

    /** Why a transition of the tried mission, or of an instance in it, cannot fire now. */
    public EnablingExplanation whyNot(long mission, String transition) {
        return view().whyNotEnabled(mission, transition);
    }

    /** Any other question about the present state; valid until the next step. */
    public EngineView view() {
        return engine.view(now.state);
    }

    /** The mission that is tried. */
    public long mission() {
        return now.mission;
    }

    /** How the mission ended; empty while it goes on. */
    public Optional<Outcome> outcome() {
        return now.outcome;
    }

    /** The time that has passed since the start, in milliseconds. */
    public long nowMillis() {
        return now.nowMillis;
    }

    /** The whole state as bytes: equal ones go on alike. */
    public byte[] stateBytes() {
        return StateCodec.encode(now.state);
    }

    /** Names the present moment by what it means: equal keys go on alike, whatever ids were given and at whatever time. */
    public MomentKey key() {
        return now.key();
    }

    /**
     * Names the present moment likewise, but for what makes no difference to where it leads: which of the robots and made tasks is which, where
     * points lie, and how long timers run.
     *
     * @param robots names of robots that are like one another
     */
    public MomentKey keyAlike(Set<String> robots) {
        return MomentKey.alike(now.state, now.tasks, robots);
    }

    /** The keys of all moments before the present one, from the start on. */
    Set<MomentKey> keysBefore() {
        Set<MomentKey> keys = new LinkedHashSet<>();
        past.forEach(step -> keys.add(step.before().key()));
        return keys;
    }

    /** The summaries of all moments before the present one, from the start on. */
    List<String> summariesBefore() {
        return past.stream().map(step -> step.before().summary(engine)).toList();
    }

    /** The summary of the present moment ({@link MomentSummary}). */
    String summary() {
        return now.summary(engine);
    }

    /** The steps taken, as a test case says them. */
    List<TestStep> said() {
        return past.stream().map(Past::recorded).toList();
    }

    /** How many robots were known at the start. */
    int robotsAtStart() {
        return proxies.size();
    }

    /** The tasks with which a robot begins next, by robot. */
    Map<String, TaskId> startableTasks() {
        return now.tasks.startable();
    }

    // ---- Recording

    /** Records that a place has the tokens that stand there now. */
    public TakenStep expectTokens(String place) {
        return engine.project().plan(plan).flatMap(p -> p.place(place)).isEmpty()
                ? refused("the plan \"" + plan + "\" has no place \"" + place + "\"")
                : take(expectations().found(place));
    }

    /** Records that the mission has ended by entering an end place. */
    public TakenStep expectEnded() {
        return take(new TestStep.ExpectEnded());
    }

    /** Why the steps cannot be saved as a test case, naming the step; empty where they can. */
    public Optional<String> whyNotATestCase() {
        for (String key : from.map(TestStart::values).orElse(Map.of()).keySet()) {
            if (!key.startsWith("@") && key.indexOf('.') < 0) {
                return Optional.of(
                        "the value of " + key + " was given at the start without the event that asks for it");
            }
        }
        for (int i = 0; i < past.size(); i++) {
            Optional<String> reason = past.get(i).notRecorded();
            if (reason.isPresent()) {
                return Optional.of("step " + (i + 1) + " cannot be expressed in a test case: " + reason.get());
            }
        }
        return Optional.empty();
    }

    /**
     * The steps taken as a test case, to be saved with the plan.
     *
     * @throws IllegalStateException with {@link #whyNotATestCase} if they cannot be saved
     */
    public TestCase testCase(String name) {
        whyNotATestCase().ifPresent(reason -> {
            throw new IllegalStateException(reason);
        });
        return asTried(name);
    }

    /** The steps taken, as near as a test case can say them; those that it cannot say may mean others when they are taken again. */
    public TestCase asTried(String name) {
        return new TestCase(
                name, proxies, from, past.stream().map(Past::recorded).toList());
    }

    private StepMeaning meaning() {
        return new StepMeaning(now, view());
    }

    private Expectations expectations() {
        return new Expectations(now, view());
    }
}
