package org.sami.dreamm.tryout;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.Turns;

/**
 * Takes the next step of what is tried. Where nothing that is expected leads on, what does is looked for on another thread, as that takes
 * some tenths of a second; it can be stopped, and is given up when the run goes on otherwise. On the document's thread.
 */
public final class NextStepSearch {
    private final TryOut tryOut;
    private final Executor worker;
    private final Executor owner;
    private Optional<Look> look = Optional.empty();

    /** A look for a step behind one moment of a run. */
    private record Look(Stepper of, int steps, AtomicBoolean cancelled) {}

    /**
     * The steps of a window.
     *
     * @param worker looks for what leads on
     * @param owner the document's thread
     */
    public NextStepSearch(TryOut tryOut, Executor worker, Executor owner) {
        this.tryOut = Objects.requireNonNull(tryOut, "tryOut");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        tryOut.addListener(() -> {
            if (look.filter(at -> !isAt(at)).isPresent()) {
                giveUp();
            }
        });
    }

    private boolean isAt(Look at) {
        return tryOut.stepper().equals(Optional.of(at.of)) && tryOut.steps() == at.steps;
    }

    /** Whether something that leads on is being looked for. */
    public boolean isLooking() {
        return look.isPresent();
    }

    /**
     * Takes the next step of those that the run plays (operator, boats, services); does nothing while it searches for one.
     *
     * @param then receives whether one was taken, at once or when it was found; never where the look is given up
     */
    public void stepOn(Consumer<Boolean> then) {
        if (isLooking()) {
            return;
        }
        if (tryOut.isOver()) {
            then.accept(tryOut.stepOn());
            return;
        }
        Turns turns = tryOut.turns();
        Optional<Turns.Turn> expected = turns.expected();
        if (expected.isPresent()) {
            then.accept(tryOut.take(expected.get()));
            return;
        }
        Look mine = new Look(tryOut.stepper().orElseThrow(), tryOut.steps(), new AtomicBoolean());
        look = Optional.of(mine);
        tryOut.say("Looking for what leads on… (F9 stops it)");
        worker.execute(() -> {
            Turns.Turn found = turns.leadOut(mine.cancelled::get);
            owner.execute(() -> {
                if (look.equals(Optional.of(mine))) {
                    look = Optional.empty();
                    then.accept(tryOut.take(found));
                }
            });
        });
    }

    /** Stops looking; nothing is taken. */
    public void cancel() {
        if (isLooking()) {
            giveUp();
            tryOut.say("The look for what leads on was stopped");
        }
    }

    private void giveUp() {
        look.ifPresent(at -> at.cancelled.set(true));
        look = Optional.empty();
    }
}
