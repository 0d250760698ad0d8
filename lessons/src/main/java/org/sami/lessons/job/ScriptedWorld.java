package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.PriorityQueue;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.TestCase;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;

/**
 * Runs a plan on the engine with the operator, robots and services of a hidden case. Time is the engine's own and passes at once; equal plans run
 * alike. What happens in one instant happens in an order that does not depend on the plan's ids, names or order of events. A run has a budget of
 * steps, tokens and time, so that no plan runs for ever.
 */
final class ScriptedWorld {
    /** A mission that fires so often without anything happening meanwhile never comes to rest. */
    static final int MOST_FIRINGS = 300;

    private static final int MOST_STEPS = 1500;
    private static final int MOST_TOKENS = 1000;
    private static final int MOST_MISSIONS = 100;
    private static final long MOST_MILLIS = 10 * 60_000L;

    private final Stepper stepper;
    private final JobCase job;
    private final BooleanSupplier isCancelled;
    private final WorldTrace trace;
    private final WorldAnswers answers;
    private final TaskNewsWatch news;
    private final PriorityQueue<Due> queue = new PriorityQueue<>(
            Comparator.comparingLong(Due::at).thenComparing(Due::key).thenComparingLong(Due::number));
    private final Map<Long, Activation> activations = new HashMap<>();
    private long numbers;
    private int questions;

    /**
     * Something that is to happen.
     *
     * @param key what goes first of what happens at one time
     * @param number in order of asking, where nothing else tells two apart
     */
    private record Due(long at, String key, long number, Act act) {}

    /** Something that happens; says what came of it. */
    private interface Act {
        List<TakenStep> act();
    }

    private ScriptedWorld(Stepper stepper, Engine engine, JobCase job, BooleanSupplier isCancelled) {
        this.stepper = stepper;
        this.job = job;
        this.isCancelled = isCancelled;
        trace = new WorldTrace(engine.project(), engine.vocabulary());
        news = new TaskNewsWatch(engine.vocabulary());
        answers = new WorldAnswers(stepper, job, trace);
    }

    /**
     * Runs a case.
     *
     * @param engine with a limit of firings of {@link #MOST_FIRINGS}
     * @throws CancellationException if it is cancelled meanwhile
     */
    static CaseRun run(Engine engine, String plan, JobCase job, BooleanSupplier isCancelled) {
        Stepper stepper;
        try {
            stepper = Stepper.start(engine, plan, job.name(), job.robots());
        } catch (IllegalArgumentException refused) {
            TestCase nothing = new TestCase(job.name(), job.robots(), List.of());
            return new CaseRun(
                    List.of(), List.of(), 0, CaseRun.End.REFUSED, 0, String.valueOf(refused.getMessage()), nothing);
        }
        return new ScriptedWorld(stepper, engine, job, isCancelled).run();
    }

    private CaseRun run() {
        job.happenings()
                .forEach(happening -> due(
                        happening.atMillis(), "4", () -> answers.happenings().happen(happening.what())));
        saw(stepper.startEffects());
        long last = job.happenings().stream()
                .mapToLong(JobCase.Happening::atMillis)
                .max()
                .orElse(0);
        for (int steps = 0; stepper.outcome().isEmpty(); steps++) {
            if (isCancelled.getAsBoolean()) {
                throw new CancellationException("The run was cancelled");
            }
            Optional<String> excess = excess(steps);
            if (excess.isPresent()) {
                return end(CaseRun.End.ENDLESS, excess.get());
            }
            OptionalLong next = next();
            if (next.isEmpty()) {
                return end(CaseRun.End.WAITS, "");
            }
            if (next.getAsLong() > last + MOST_MILLIS) {
                return end(CaseRun.End.GOES_ON, "");
            }
            step(next.getAsLong());
        }
        Outcome outcome = stepper.outcome().get();
        return outcome == Outcome.HALTED
                ? end(CaseRun.End.ENDLESS, "transitions fire again and again although nothing happens")
                : end(outcome == Outcome.ENDED ? CaseRun.End.ENDED : CaseRun.End.ABORTED, "");
    }

    private CaseRun end(CaseRun.End how, String why) {
        return new CaseRun(
                trace.items(), trace.answers(), questions, how, stepper.nowMillis(), why, stepper.asTried(job.name()));
    }

    private Optional<String> excess(int steps) {
        EngineView view = stepper.view();
        int tokens = view.missions().stream()
                .flatMap(mission -> mission.marking().values().stream())
                .mapToInt(List::size)
                .sum();
        if (tokens > MOST_TOKENS) {
            return Optional.of("tokens pile up, there are more than " + MOST_TOKENS + " of them");
        } else if (view.missions().size() > MOST_MISSIONS) {
            return Optional.of("sub-missions pile up, there are more than " + MOST_MISSIONS + " of them");
        }
        return steps > MOST_STEPS ? Optional.of("after " + MOST_STEPS + " steps it has not ended") : Optional.empty();
    }

    private OptionalLong next() {
        OptionalLong engine = stepper.view().nextDueMillis();
        Due first = queue.peek();
        return first == null
                ? engine
                : engine.isEmpty()
                        ? OptionalLong.of(first.at())
                        : OptionalLong.of(Math.min(first.at(), engine.getAsLong()));
    }

    private void step(long at) {
        OptionalLong engine = stepper.view().nextDueMillis();
        if (at > stepper.nowMillis() || (engine.isPresent() && engine.getAsLong() <= at)) {
            saw(stepper.advance(Math.max(0, at - stepper.nowMillis())).effects());
        } else {
            queue.remove().act().act().forEach(taken -> saw(taken.effects()));
        }
    }

    private void due(long at, String key, Act act) {
        queue.add(new Due(at, key, numbers++, act));
    }

    private void saw(List<Effect> effects) {
        EngineView view = stepper.view();
        long now = stepper.nowMillis();
        List<Asked> asked = new ArrayList<>();
        for (Effect effect : effects) {
            trace.saw(effect, view);
            news.saw(effect);
            if (effect instanceof Effect.Activated activated) {
                activations.put(activated.activation().id(), activated.activation());
                trace.activated(now, activated.activation(), view);
                asked.addAll(answers.asked(activated.activation()));
            } else if (effect instanceof Effect.TasksAllocated allocated) {
                trace.allocated(now, allocated, view);
            } else if (effect instanceof Effect.DecisionOpened opened) {
                asked.add(decision(opened.decision(), now));
            }
        }
        asked.sort(Comparator.comparing(Asked::key));
        for (Asked one : asked) {
            answers.answer(one, now).ifPresent(answer -> due(answer.at(), answer.key(), answer::act));
        }
        for (TaskNewsWatch.News one : news.take()) {
            due(
                    now,
                    "1 " + one.type() + trace.number(one.task(), view),
                    () -> answers.happenings().tell(one));
        }
    }

    private Asked decision(Decision decision, long now) {
        Optional<Activation> activation = Optional.ofNullable(activations.get(decision.activation()));
        boolean byAutonomy = decision.deadlineMillis().isPresent()
                && decision.deadlineMillis().getAsLong() <= now;
        if (!byAutonomy) {
            questions++;
        }
        if (activation.isEmpty() && decision.activation() == Ids.NONE) {
            answers.fieldsAsked(decision).ifPresent(fields -> trace.askedAtStart(now, fields));
        }
        return answers.asked(decision, activation);
    }
}
