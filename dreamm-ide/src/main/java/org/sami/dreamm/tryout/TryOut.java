package org.sami.dreamm.tryout;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.MissionView;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Question;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.stepping.Turns;
import org.sami.spn.value.Value;

/**
 * A run of one plan of the document, with robots that are not real. Its steps are taken by hand or, one at a time, by what robots, services
 * and an operator are expected to do; they stop at breakpoints and can be taken back. A run goes on with the plan as it was when it began;
 * where the plan has changed it says so. On the document's thread.
 */
public final class TryOut {
    /** The greatest number of robots. */
    public static final int MOST_ROBOTS = 25;

    /** The greatest number of locations that the operator gives by himself. */
    public static final int MOST_LOCATIONS = 25;

    private final ProjectDocument document;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final Set<Breakpoint> breakpoints = new LinkedHashSet<>();
    private int robots = 3;
    private int locations = 3;
    private boolean mockOperator = true;
    private boolean mockRobots = true;
    private Optional<PlanRun> run = Optional.empty();
    private String message = "";
    private int disabled;

    /** A place where nothing is tried yet. */
    public TryOut(ProjectDocument document) {
        this.document = Objects.requireNonNull(document, "document");
        document.addListener(this::follow);
    }

    private void follow(DocumentChange change) {
        if (change.isOpened()) {
            breakpoints.clear();
            stop();
        } else if (run.isPresent() && NetChanges.in(change)) {
            run.get().setOutdated();
            message = "The plan has changed since this run began; Restart takes its steps again on the new plan";
            tell();
        }
    }

    // ---- Beginning and ending

    /** Names of the robots that a run begins with. */
    public List<String> robotNames() {
        return IntStream.rangeClosed(1, robots).mapToObj(i -> "robot-" + i).toList();
    }

    /** With how many robots the next run begins. */
    public int robots() {
        return robots;
    }

    /** Begins the next run with so many robots. */
    public void setRobots(int count) {
        robots = Math.max(0, Math.min(MOST_ROBOTS, count));
        tell();
    }

    /** How many locations the operator gives by himself where some are asked for, and samples have. */
    public int locations() {
        return locations;
    }

    /** Has the operator give so many locations where some are asked for. */
    public void setLocations(int count) {
        locations = Math.max(1, Math.min(MOST_LOCATIONS, count));
        tell();
    }

    /** Begins a plan at its start place. */
    public boolean start(String plan) {
        return begin(plan, new TestCase(plan, robotNames(), List.of()));
    }

    /**
     * Begins a plan at its start place with what its author has given for what it asks there, as the first step. Where that is not all that
     * it asks, the question stays open.
     *
     * @param given values by {@code eventId.field} or the name of a variable
     */
    public boolean start(String plan, Map<String, Value> given) {
        if (!start(plan)) {
            return false;
        }
        if (!given.isEmpty() && asksNoMoreThan(given)) {
            String started = message;
            take(new TestStep.Answer("", new TestStep.Reply.Values(given)));
            message = started + "; " + message;
            tell();
        }
        return true;
    }

    private boolean asksNoMoreThan(Map<String, Value> given) {
        Stepper now = stepper().orElseThrow();
        return now.possible().decisions().stream()
                .filter(decision -> now.eventAsking(decision).isEmpty())
                .map(Decision::question)
                .filter(Question.FillIn.class::isInstance)
                .flatMap(asked -> ((Question.FillIn) asked).items().stream())
                .allMatch(item -> item.defaultValue().isPresent() || given.containsKey(item.key()));
    }

    /** Begins a plan at a marking. */
    public boolean startAt(String plan, TestStart start) {
        return begin(plan, new TestCase(plan, robotNames(), List.of()).withStart(Optional.of(start)));
    }

    /** Begins a plan as a test case does and takes all of its steps, as far as they can be taken. */
    public boolean play(String plan, TestCase test) {
        return begin(plan, test)
                && test.steps().stream().allMatch(step -> take(step).refusal().isEmpty());
    }

    private boolean begin(String plan, TestCase as) {
        List<String> errors = PlanChecks.check(document.project(), document.vocabulary(), plan).stream()
                .filter(Finding::isError)
                .map(Finding::message)
                .toList();
        if (document.plan(plan).isEmpty() || !errors.isEmpty()) {
            message = errors.isEmpty()
                    ? "There is no plan " + plan
                    : "A plan with an error is not started: " + errors.get(0);
            tell();
            return false;
        }
        try {
            Engine engine = new Engine(document.vocabulary(), DisabledParts.leftOut(document.project()));
            run = Optional.of(new PlanRun(plan, Stepper.startAs(engine, plan, as)));
            disabled =
                    document.plan(plan).map(DisabledParts::of).orElse(List.of()).size();
            message = "Started with " + as.proxies().size() + " robots"
                    + (disabled == 0 ? "" : "; " + disabled + " disabled left out");
        } catch (IllegalArgumentException refused) {
            message = String.valueOf(refused.getMessage());
            tell();
            return false;
        }
        tell();
        return true;
    }

    /** Begins again with the plan as it is now, and takes the same steps as far as they can be taken. */
    public void restart(boolean withSteps) {
        run.ifPresent(was -> {
            String plan = was.plan();
            TestCase so = was.stepper().asTried(plan);
            if (withSteps) {
                int wanted = so.steps().size();
                if (!play(plan, so) && run.filter(is -> is != was).isPresent()) {
                    message = "Taken again up to step " + steps() + " of " + wanted + ": " + message;
                    tell();
                }
            } else {
                begin(plan, so.withSteps(List.of()));
            }
        });
    }

    /** Ends the run; breakpoints stay. */
    public void stop() {
        run = Optional.empty();
        message = "";
        tell();
    }

    // ---- Steps

    /** Takes a step by hand. */
    public TakenStep take(TestStep step) {
        return done(words(step), stepper -> stepper.take(step));
    }

    private String words(TestStep step) {
        return stepper().map(stepper -> StepWords.of(step, stepper)).orElse("");
    }

    /** Takes a step that a stepper knows, such as an answer to one of several open questions. */
    public TakenStep done(String words, Function<Stepper, TakenStep> step) {
        PlanRun now = run.orElseThrow(() -> new IllegalStateException("nothing is tried"));
        TakenStep taken = step.apply(now.stepper());
        message = taken.refusal()
                .map(why -> words + ": " + why)
                .orElseGet(() -> now.add(words, taken).came());
        tell();
        return taken;
    }

    /**
     * Takes the next step of those that the run plays. They take turns; where all that is expected leads back to what was there, the message
     * says that it goes round and what leads out, and that is taken.
     *
     * @return whether one was taken; where none was, the message says what is waited for
     */
    public boolean stepOn() {
        if (isOver()) {
            say("The mission is over");
            return false;
        }
        Turns turns = turns();
        return take(turns.expected().orElseGet(() -> turns.leadOut(() -> false)));
    }

    /** The turns at the present moment of the run. */
    Turns turns() {
        return run.orElseThrow(() -> new IllegalStateException("nothing is tried"))
                .turns(locations, mockOperator, mockRobots);
    }

    /** Takes a turn; where it has no step, the message says why. */
    boolean take(Turns.Turn turn) {
        if (turn.step().isPresent()) {
            return stepOn(turn.step().get().step(), turn.remark());
        }
        say(turn.remark());
        return false;
    }

    /** Shows a message. */
    void say(String what) {
        message = what;
        tell();
    }

    private boolean stepOn(TestStep step, String remark) {
        String why = remark.isEmpty() ? "" : " (" + remark.substring(0, remark.indexOf(';')) + ")";
        boolean taken =
                done(words(step) + why, stepper -> stepper.take(step)).refusal().isEmpty();
        if (taken && !remark.isEmpty()) {
            message = remark + ": " + message;
            tell();
        }
        return taken;
    }

    /** Takes so many steps back. */
    public void back(int steps) {
        run.ifPresent(now -> {
            message = now.back(steps) == 0 ? "This is the start" : "Back at step " + now.steps();
            tell();
        });
    }

    /** The vertex with a breakpoint that the last step entered or fired; empty where it met none. */
    public Optional<Breakpoint> met() {
        return run.flatMap(now -> now.met(breakpoints));
    }

    // ---- Breakpoints

    /** Where runs stop. */
    public Set<Breakpoint> breakpoints() {
        return Set.copyOf(breakpoints);
    }

    /** Sets a breakpoint where there is none, else removes it. */
    public void toggle(Breakpoint at) {
        if (!breakpoints.remove(at)) {
            breakpoints.add(at);
        }
        tell();
    }

    // ---- Who plays

    /** Whether the operator answers by itself while the plan is run on. */
    public boolean isMockOperator() {
        return mockOperator;
    }

    /** Has the operator answer by itself, or has the author answer. */
    public void setMockOperator(boolean on) {
        mockOperator = on;
        tell();
    }

    /** Whether robots and services answer by themselves while the plan is run on. */
    public boolean isMockRobots() {
        return mockRobots;
    }

    /** Has robots and services answer by themselves, or has the author put in what they tell. */
    public void setMockRobots(boolean on) {
        mockRobots = on;
        tell();
    }

    // ---- Questions

    /** The run's stepper, for questions; empty where nothing is tried. */
    public Optional<Stepper> stepper() {
        return run.map(PlanRun::stepper);
    }

    /** The plan that is tried; empty where none is. */
    public Optional<String> plan() {
        return run.map(PlanRun::plan);
    }

    /** The steps that were taken, in order. */
    public List<TryOutLine> lines() {
        return run.map(PlanRun::lines).orElse(List.of());
    }

    /** How many steps were taken. */
    public int steps() {
        return run.map(PlanRun::steps).orElse(0);
    }

    /** What the last step, or the start, did. */
    public List<Effect> lastEffects() {
        return run.map(PlanRun::lastEffects).orElse(List.of());
    }

    /** Whether the mission has ended. */
    public boolean isOver() {
        return run.flatMap(now -> now.stepper().outcome()).isPresent();
    }

    /** How many disabled places and transitions of its plan the run leaves out. */
    public int disabled() {
        return run.isPresent() ? disabled : 0;
    }

    /** Whether the plan has changed since the run began. */
    public boolean isOutdated() {
        return run.filter(PlanRun::isOutdated).isPresent();
    }

    /** What came of the last thing that was done, in one sentence; empty text where nothing was. */
    public String message() {
        return message;
    }

    /** The mission of a plan in the run, such as that of a sub-mission which is looked at: the newest; empty where none runs. */
    public Optional<MissionView> mission(String planId) {
        return run.flatMap(now -> now.mission(planId));
    }

    /** Why a transition of a plan in the run cannot fire, in one line; empty where that plan does not run or the transition can. */
    public Optional<String> whyNot(String planId, String transition) {
        boolean off = document.plan(planId)
                .flatMap(plan -> plan.transition(transition))
                .filter(Transition::disabled)
                .isPresent();
        return mission(planId).isPresent() && off
                ? Optional.of("It is disabled for trying")
                : whyNotFiring(planId, transition);
    }

    private Optional<String> whyNotFiring(String planId, String transition) {
        return mission(planId)
                .filter(mission -> document.plan(planId)
                        .filter(plan -> plan.transition(transition).isPresent())
                        .isPresent())
                .map(mission -> stepper().orElseThrow().whyNot(mission.id(), transition))
                .filter(answer -> !answer.yes())
                .map(answer -> String.join(" ", answer.reasons()));
    }

    /** Tells somebody when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
