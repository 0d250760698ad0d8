package org.sami.dreamm.tryout;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.Timer;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.stepping.StepText;
import org.sami.ui.command.Command;

/** What can be done with a plan that is tried, and the timer that runs it on. On the event thread. */
public final class TryOutCommands {
    private static final int STEP_MS = 350;

    private final DreammContext context;
    private final TryOut tryOut;
    private final NextStepSearch steps;
    private final StartMarkingSetup setup;
    private Runnable started = () -> {};
    private final Timer timer = new Timer(STEP_MS, e -> tick());

    /** Adds the commands to a window's. */
    public TryOutCommands(
            DreammContext context,
            TryOut tryOut,
            NextStepSearch steps,
            StartMarkingSetup setup,
            SavedCases cases,
            TryOutOverlay overlay) {
        this.context = context;
        this.tryOut = tryOut;
        this.steps = steps;
        this.setup = setup;
        add("try-start", "Start", "F5", "play", this::start, this::whyNoPlan);
        add(
                "try-restart",
                "Restart with the same steps",
                "ctrl F5",
                "resend",
                () -> tryOut.restart(true),
                this::whyIdle);
        add("try-stop", "End the run", "shift F5", "stop", this::stop, this::whyIdle);
        add("try-step", "Step", "F6", "right", this::step, this::whyNoStep);
        add("try-run", "Run on, or pause", "F9", "run-on", this::toggle, this::whyNoStep);
        add("try-back", "One step back", "F7", "left", this::back, this::whyNoBack);
        add(
                "try-breakpoint",
                "Breakpoint at the selection",
                "ctrl F9",
                "breakpoint",
                this::breakpoint,
                this::whyNoVertex);
        add("try-why", "Why is it not enabled?", "ctrl F6", "help", this::why, this::whyNoTransition);
        add("try-start-at", "Start from the marking", "alt F5", "go-to", this::startAt, this::whyNoMarking);
        add("try-cases", "Run all saved cases", "ctrl F11", "check", cases::runAll, cases::whyNotRun);
        add(
                "try-coverage",
                "Show what no case visits",
                "ctrl shift F11",
                "layers",
                () -> overlay.setCoverage(!overlay.isCoverage()),
                () -> cases.coverage().isPresent() ? Optional.empty() : Optional.of("run the saved cases first"));
        tryOut.addListener(this::refresh);
        setup.addListener(this::refresh);
        cases.addListener(this::refresh);
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                context.editor().planId().ifPresent(setup::of);
            }
        });
        context.document()
                .addListener(
                        change -> context.editor().plan().ifPresent(plan -> setup.keep(plan, context.vocabulary())));
        context.editor().planId().ifPresent(setup::of);
    }

    private void add(
            String id, String title, String key, String icon, Runnable run, Supplier<Optional<String>> whyNot) {
        Command command = new Command(id, title, run).withIcon(icon).unless(whyNot);
        context.commands().add(key.isEmpty() ? command : command.withKey(key));
    }

    private void refresh() {
        if (timer.isRunning() && (tryOut.stepper().isEmpty() || tryOut.isOver())) {
            timer.stop();
        }
        context.commands().refresh();
    }

    /** Whether the run goes on by itself, or what leads on is looked for. */
    boolean isRunning() {
        return timer.isRunning() || steps.isLooking();
    }

    private Optional<String> whyNoPlan() {
        return context.editor().plan().isPresent() ? Optional.empty() : Optional.of("no plan is open");
    }

    private Optional<String> whyIdle() {
        return tryOut.stepper().isPresent() ? Optional.empty() : Optional.of("nothing is tried yet: Start (F5) begins");
    }

    private Optional<String> whyNoStep() {
        return tryOut.isOver()
                ? Optional.of("the mission is over: Start begins again, Back takes steps back")
                : whyIdle();
    }

    private Optional<String> whyNoBack() {
        return tryOut.stepper().isPresent() && tryOut.steps() == 0 ? Optional.of("this is the start") : whyIdle();
    }

    private Optional<String> whyNoVertex() {
        return selected(false).isEmpty() ? Optional.of("select a place or a transition on the net") : Optional.empty();
    }

    private Optional<String> whyNoTransition() {
        return tryOut.stepper().isPresent() && selected(true).isEmpty()
                ? Optional.of("select a transition on the net")
                : whyIdle();
    }

    private Optional<String> whyNoMarking() {
        return setup.start().isEmpty()
                ? Optional.of("put tokens into places first: select a place, then the tab Marking")
                : whyNoPlan()
                        .or(() -> context.editor()
                                .plan()
                                .flatMap(plan -> setup.missing(plan, context.vocabulary()))
                                .map(key ->
                                        "the plan asks for " + asked(key) + " at its start: give it below the tokens"));
    }

    private String asked(String key) {
        return context.editor()
                .planId()
                .map(plan -> StepText.of(context.document().project(), plan, context.vocabulary())
                        .asked(key))
                .orElse(key);
    }

    private List<String> selected(boolean onlyTransitions) {
        Set<String> selection = context.editor().selection();
        return context.editor()
                .plan()
                .map((Plan plan) -> selection.stream()
                        .filter(id -> plan.transition(id).isPresent()
                                || (!onlyTransitions && plan.place(id).isPresent()))
                        .toList())
                .orElse(List.of());
    }

    /** Calls a listener when a command starts a run. */
    public void whenStarted(Runnable listener) {
        started = listener;
    }

    private void start() {
        timer.stop();
        started.run();
        context.editor().planId().ifPresent(plan -> tryOut.start(plan, setup.given()));
    }

    private void startAt() {
        timer.stop();
        started.run();
        setup.start().ifPresent(start -> context.editor().planId().ifPresent(plan -> tryOut.startAt(plan, start)));
    }

    private void stop() {
        timer.stop();
        tryOut.stop();
    }

    private void step() {
        timer.stop();
        steps.stepOn(taken -> context.commands().refresh());
    }

    private void back() {
        timer.stop();
        tryOut.back(1);
    }

    private void toggle() {
        if (isRunning()) {
            timer.stop();
            steps.cancel();
            context.commands().refresh();
        } else {
            timer.start();
            tick();
        }
    }

    private void tick() {
        steps.stepOn(this::stepped);
    }

    private void stepped(boolean taken) {
        if (!taken) {
            timer.stop();
        }
        tryOut.met().ifPresent(at -> {
            timer.stop();
            context.editor().open(at.plan());
            context.editor().highlight(Set.of(at.vertex()));
            context.notices().show("Stopped at the breakpoint at " + name(at.plan(), at.vertex()));
        });
        context.commands().refresh();
    }

    private String name(String plan, String vertex) {
        return context.document()
                .plan(plan)
                .flatMap(of -> new ElementNames(of, context.vocabulary()).of(vertex))
                .orElse(vertex);
    }

    private void breakpoint() {
        String plan = context.editor().planId().orElseThrow();
        selected(false).forEach(vertex -> tryOut.toggle(new Breakpoint(plan, vertex)));
    }

    private void why() {
        String plan = context.editor().planId().orElseThrow();
        String transition = selected(true).get(0);
        context.notices()
                .show(name(plan, transition) + ": "
                        + tryOut.whyNot(plan, transition)
                                .orElse(
                                        tryOut.mission(plan).isPresent()
                                                ? "it can fire when it is looked at next"
                                                : "no mission of the plan " + plan + " runs in what is tried"));
    }
}
