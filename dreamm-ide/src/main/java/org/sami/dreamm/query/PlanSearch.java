package org.sami.dreamm.query;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.tryout.NetChanges;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.ui.command.Command;

/**
 * A search of the open plan that a command begins and ends, off the owner's thread. What it found is forgotten where the plan runs otherwise, or another is opened. All
 * else on the owner's thread.
 */
final class PlanSearch<T> {
    private final DreammContext context;
    private final Supplier<List<String>> robots;
    private final Executor worker;
    private final Executor owner;
    private final Subject<T> subject;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<T> result = Optional.empty();
    private Optional<AtomicBoolean> searching = Optional.empty();
    private String words = "";

    /** What is searched for, and what is done with it. */
    interface Subject<T> {
        /** What is said while it is searched. */
        String begun();

        /**
         * Searches, off the owner's thread.
         *
         * @throws PlanNetTooLargeException if the plan's net is too large
         * @throws IllegalArgumentException if the plan cannot be searched
         * @throws CancellationException if it was stopped
         */
        T search(PlanNetRequest request, BooleanSupplier stop) throws PlanNetTooLargeException;

        /** What is said of what was found, once it is there. */
        String found(T result);

        /** What is said where the search is refused. */
        String refused(String why);

        /**
         * What was found, or is searched, is shown no more.
         *
         * @param wasFound whether something was found
         */
        void forgotten(boolean wasFound);
    }

    /**
     * Adds its command to a window's.
     *
     * @param command the command that begins and ends a search
     * @param robots names of the robots with which a plan is searched
     */
    PlanSearch(
            DreammContext context,
            Supplier<List<String>> robots,
            Executor worker,
            Executor owner,
            CommandWords command,
            Subject<T> subject) {
        this.context = Objects.requireNonNull(context, "context");
        this.robots = Objects.requireNonNull(robots, "robots");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        this.subject = Objects.requireNonNull(subject, "subject");
        context.commands()
                .add(new Command(command.id(), command.label(), this::toggle)
                        .withIcon(command.icon())
                        .withKey(command.key())
                        .unless(() -> context.editor().planId().isPresent()
                                ? Optional.empty()
                                : Optional.of("no plan is open")));
        context.document().addListener((DocumentChange change) -> {
            if (NetChanges.in(change)) {
                forget();
            }
        });
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                forget();
            }
        });
    }

    /** The command that begins and ends a search. */
    record CommandWords(String id, String label, String icon, String key) {}

    /** What was found; empty while it is searched, or where nobody asks for it. */
    Optional<T> result() {
        return result;
    }

    /** Whether something was found, or is searched. */
    boolean isShown() {
        return result.isPresent() || searching.isPresent();
    }

    /** What was found, that it is searched, or why not; empty where nobody asks for it. */
    String words() {
        return words;
    }

    private void toggle() {
        if (isShown()) {
            forget();
            return;
        }
        AtomicBoolean stop = new AtomicBoolean();
        searching = Optional.of(stop);
        words = subject.begun();
        PlanNetRequest request = new PlanNetRequest(
                context.document().project(),
                context.document().vocabulary(),
                context.editor().planId().orElseThrow(),
                robots.get());
        worker.execute(() -> search(request, stop));
        changed();
    }

    private void search(PlanNetRequest request, AtomicBoolean stop) {
        try {
            T found = subject.search(request, stop::get);
            owner.execute(() -> end(Optional.of(found), "", stop));
        } catch (PlanNetTooLargeException | IllegalArgumentException | CancellationException refused) {
            String why = String.valueOf(refused.getMessage());
            owner.execute(() -> end(Optional.empty(), why, stop));
        }
    }

    private void end(Optional<T> found, String why, AtomicBoolean stop) {
        if (stop.get()) {
            return;
        }
        searching = Optional.empty();
        result = found;
        words = found.map(subject::found).orElseGet(() -> subject.refused(why));
        changed();
    }

    private void forget() {
        searching.ifPresent(stop -> stop.set(true));
        boolean wasFound = result.isPresent();
        boolean wasShown = isShown();
        boolean wasSaid = !words.isEmpty();
        searching = Optional.empty();
        result = Optional.empty();
        words = "";
        if (wasShown) {
            subject.forgotten(wasFound);
        }
        if (wasShown || wasSaid) {
            changed();
        }
    }

    /** Tells somebody when something else is shown. */
    void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** Tells the listeners that something else is shown. */
    void changed() {
        listeners.forEach(Runnable::run);
    }
}
