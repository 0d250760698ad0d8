package org.sami.dreamm.issues;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;

/**
 * Runs one deep check at a time off the event thread, reports its progress and stops it on request. Its reports belong to the
 * owner's thread.
 */
public final class DeepSearch {
    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
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

    /** Begins a check; what was found before is forgotten. Where one runs, nothing happens. */
    public void start(DeepCheck check, DeepRequest request) {
        if (run.isPresent()) {
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
                owner.execute(() -> done(Optional.of(new Outcome(check, request, result)), ""));
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

    /** Forgets what was found, as the plan is another one now. */
    public void forget() {
        if (outcome.isPresent()) {
            outcome = Optional.empty();
            tell();
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
