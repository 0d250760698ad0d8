package org.sami.dreamm.issues;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.dreamm.tryout.KeptResults;
import org.sami.dreamm.tryout.RunContent;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs one deep check at a time off the event thread, reports its progress and stops it on request. What it found is kept while the plan runs the same, and is back where
 * an undo makes the plan what it was. Its reports belong to the owner's thread.
 */
public final class DeepSearch {
    private static final int MOST_KEPT = 32;

    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final KeptResults<Asked, Outcome> kept = new KeptResults<>(MOST_KEPT);
    private Optional<Asked> last = Optional.empty();
    private Optional<Run> run = Optional.empty();
    private Optional<Outcome> outcome = Optional.empty();
    private String failure = "";

    /**
     * What came of a check.
     *
     * @param request what was checked: the findings are about that version of the project
     */
    public record Outcome(DeepCheck check, DeepRequest request, DeepResult result) {
        public Outcome {
            Objects.requireNonNull(check, "check");
            Objects.requireNonNull(request, "request");
            Objects.requireNonNull(result, "result");
        }
    }

    private record Asked(
            String check,
            Vocabulary vocabulary,
            List<String> robots,
            List<Integer> locations,
            int mostStates,
            RunContent content) {
        static Asked of(DeepCheck check, DeepRequest request) {
            return new Asked(
                    check.id(),
                    request.vocabulary(),
                    request.robots(),
                    request.locations(),
                    request.mostStates(),
                    RunContent.of(request.project(), request.plan()));
        }

        Asked in(Project project) {
            return new Asked(check, vocabulary, robots, locations, mostStates, RunContent.of(project, content.plan()));
        }
    }

    private static final class Run {
        final DeepCheck check;
        final AtomicBoolean cancelled = new AtomicBoolean();
        int states;
        int waiting;

        Run(DeepCheck check) {
            this.check = check;
        }
    }

    /** A place where nothing runs. */
    public DeepSearch(Executor worker, Executor owner) {
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
    }

    /** Begins a check, or shows what it found when the plan was the same. Where one runs, nothing happens. */
    public void start(DeepCheck check, DeepRequest request) {
        if (run.isPresent()) {
            return;
        }
        Asked asked = Asked.of(check, request);
        last = Optional.of(asked);
        Optional<Outcome> known = kept.find(asked);
        if (known.isPresent()) {
            outcome = known;
            failure = "";
            tell();
            return;
        }
        Run begun = new Run(check);
        run = Optional.of(begun);
        outcome = Optional.empty();
        failure = "";
        SearchWatch watch = new SearchWatch() {
            @Override
            public void looked(int states, int waiting) {
                owner.execute(() -> progress(begun, states, waiting));
            }

            @Override
            public boolean isCancelled() {
                return begun.cancelled.get();
            }
        };
        worker.execute(() -> {
            try {
                DeepResult result = check.run(request, watch);
                owner.execute(() -> {
                    Outcome found = new Outcome(check, request, result);
                    if (!begun.cancelled.get()) {
                        kept.keep(asked, found);
                    }
                    done(Optional.of(found), "");
                });
            } catch (IllegalArgumentException refused) {
                owner.execute(() -> done(Optional.empty(), String.valueOf(refused.getMessage())));
            }
        });
        tell();
    }

    private void progress(Run of, int states, int waiting) {
        of.states = states;
        of.waiting = waiting;
        tell();
    }

    private void done(Optional<Outcome> found, String why) {
        run = Optional.empty();
        outcome = found;
        failure = why;
        tell();
    }

    /** Stops what runs; what was found until then is its result. */
    public void cancel() {
        run.ifPresent(running -> running.cancelled.set(true));
    }

    /** Shows what the last check found in a version of the project; nothing where its plan, or one that it runs, runs otherwise there and was not searched so. */
    public void follow(Project project) {
        Optional<Outcome> next = last.map(asked -> asked.in(project)).flatMap(kept::find);
        boolean isSame = last.map(asked -> asked.in(project)).equals(last);
        if (!isSame || next.isPresent()) { // what a stopped search has found stays, too, while its plan is the same
            last = last.map(asked -> asked.in(project));
            if (!next.equals(outcome)) {
                outcome = next;
                tell();
            }
        }
    }

    /** Whether a check runs. */
    public boolean isRunning() {
        return run.isPresent();
    }

    /** What the last check found; empty while one runs, and where none ran. */
    public Optional<Outcome> outcome() {
        return outcome;
    }

    /** How it stands, in one sentence; empty text where nothing has run. */
    public String status() {
        return run.map(running -> running.check.title() + ": " + running.states + " states looked at, "
                        + running.waiting + " known and waiting")
                .or(() -> outcome.map(found -> found.result().summary()))
                .orElse(failure);
    }

    /** Tells somebody on the owner's thread when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
