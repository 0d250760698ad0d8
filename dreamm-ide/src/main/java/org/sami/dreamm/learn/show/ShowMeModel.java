package org.sami.dreamm.learn.show;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.lessons.script.ScriptElement;
import org.sami.lessons.script.ScriptRun;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * Plays the edits of a script one after another: where it is, what the project is by then, where the pointer is on its way to, and what is said.
 * Time is given to it ({@link #tick}); it knows no clock and no window. On one thread.
 */
public final class ShowMeModel {
    /** The way of the pointer from one stop to the next, in ms. */
    static final int MOVE_MS = 650;

    /** How long the pointer rests at a stop before it goes on, in ms. */
    static final int REST_MS = 350;

    private static final int LEAST_READ_MS = 900;
    private static final int WORD_MS = 260;

    /** How fast it plays. */
    public enum Speed {
        /** Half as fast. */
        SLOW(0.5, "slow"),
        /** As fast as one reads. */
        NORMAL(1, "normal"),
        /** Twice as fast. */
        FAST(2, "fast");

        private final double factor;
        private final String word;

        Speed(double factor, String word) {
            this.factor = factor;
            this.word = word;
        }

        /** The word for it. */
        public String word() {
            return word;
        }

        /** The next faster one; the slowest after the fastest. */
        Speed next() {
            return this == SLOW ? NORMAL : this == NORMAL ? FAST : SLOW;
        }
    }

    /** What happens now. */
    private enum Phase {
        /** Nothing. */
        STILL,
        /** The pointer is on its way. */
        MOVE,
        /** The pointer rests at a stop. */
        REST,
        /** The edit is made; what was said can be read. */
        READ
    }

    private final ScriptRun run;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Speed speed = Speed.NORMAL;
    private Phase phase = Phase.STILL;
    private boolean playing;
    private int done;
    private int stop;
    private double left;

    /** A player at the beginning of a script; where an element of it cannot be done, it ends there and says so. */
    public ShowMeModel(ScriptRun run) {
        this.run = Objects.requireNonNull(run, "run");
    }

    /** How many edits there are. */
    public int size() {
        return run.done().size();
    }

    /** How many edits are made. */
    public int done() {
        return done;
    }

    /** Whether all edits are made. */
    public boolean isAtEnd() {
        return done == size();
    }

    /** Whether it plays on by itself. */
    public boolean isPlaying() {
        return playing;
    }

    /** Whether something moves, so that {@link #tick} is to be called. */
    public boolean isMoving() {
        return phase != Phase.STILL;
    }

    /** How fast it plays. */
    public Speed speed() {
        return speed;
    }

    /** The project after the edits that are made. */
    public Project project() {
        return done == 0 ? run.start() : run.done().get(done - 1).project();
    }

    /** The plan that is open by then. */
    public Optional<Plan> plan() {
        Optional<String> id = done == 0
                ? run.start().plans().stream().map(Plan::id).findFirst()
                : run.done().get(done - 1).plan();
        return id.flatMap(project()::plan);
    }

    /** The edit that was made last. */
    public Optional<ScriptRun.Done> last() {
        return done == 0 ? Optional.empty() : Optional.of(run.done().get(done - 1));
    }

    /** The stops of the edit that is made next, or while its sentence is read, of the one that was made. */
    public List<ShowStop> stops() {
        return stops(done);
    }

    private List<ShowStop> stops(int index) {
        return index >= size()
                ? List.of()
                : plan().map(plan -> ShowStops.of(run.done().get(index).element(), plan))
                        .orElse(List.of());
    }

    /** The stop at which the pointer is, or to which it is on its way; empty where it stays where it is. */
    public Optional<ShowStop> stop() {
        List<ShowStop> stops = stops();
        return (phase == Phase.MOVE || phase == Phase.REST) && stop < stops.size()
                ? Optional.of(stops.get(stop))
                : Optional.empty();
    }

    /** How far the pointer is on its way to the stop: from 0 to 1. */
    public double way() {
        return phase == Phase.MOVE ? 1 - left / MOVE_MS : 1;
    }

    /** What is said: the sentence of the edit that is shown; why it ends where it cannot go on; empty text where nothing is. */
    public String sentence() {
        if (phase == Phase.STILL && isAtEnd() && run.refusal().isPresent()) {
            return run.refusal().get().message();
        }
        boolean coming = phase == Phase.MOVE || phase == Phase.REST;
        int index = coming ? done : done - 1;
        return index < 0 || index >= size()
                ? ""
                : run.done().get(index).element().say().orElse("");
    }

    /** Plays on by itself; from the beginning where it is at its end. */
    public void play() {
        if (size() == 0) {
            return;
        }
        if (isAtEnd()) {
            done = 0;
        }
        playing = true;
        if (phase == Phase.STILL) {
            begin();
        }
        tell();
    }

    /** Stays where it is; an edit that has begun is not made. */
    public void pause() {
        playing = false;
        phase = Phase.STILL;
        tell();
    }

    /** Shows one edit and stays there; where one is shown already, makes it at once. */
    public void forward() {
        if (phase == Phase.MOVE || phase == Phase.REST) {
            make();
            return;
        }
        if (!isAtEnd()) {
            begin();
            tell();
        }
    }

    /** Takes the last edit back, or the beginning of one, and stays there. */
    public void back() {
        boolean begun = phase == Phase.MOVE || phase == Phase.REST;
        playing = false;
        phase = Phase.STILL;
        if (!begun && done > 0) {
            done--;
        }
        tell();
    }

    /** Plays slower or faster. */
    public void setSpeed(Speed next) {
        speed = Objects.requireNonNull(next, "next");
        tell();
    }

    /** The sentence of an edit and its place, for those who do not see the pointer. */
    public String title() {
        boolean coming = phase == Phase.MOVE || phase == Phase.REST;
        return "Show me: " + Math.min(size(), coming ? done + 1 : done) + " of " + size();
    }

    /** What is done with the element that is shown or was shown last. */
    public Optional<ScriptElement> element() {
        boolean coming = phase == Phase.MOVE || phase == Phase.REST;
        int index = coming ? done : done - 1;
        return index < 0 || index >= size()
                ? Optional.empty()
                : Optional.of(run.done().get(index).element());
    }

    /** Goes on by some time, in ms. */
    public void tick(double ms) {
        double rest = ms * speed.factor;
        while (rest > 0 && phase != Phase.STILL) {
            if (left > rest) {
                left -= rest;
                return;
            }
            rest -= left;
            left = 0;
            next();
        }
    }

    private void begin() {
        stop = 0;
        if (stops().isEmpty()) {
            enter(Phase.REST, REST_MS);
        } else {
            enter(Phase.MOVE, MOVE_MS);
        }
    }

    private void next() {
        switch (phase) {
            case MOVE -> enter(Phase.REST, REST_MS);
            case REST -> {
                stop++;
                if (stop < stops().size()) {
                    enter(Phase.MOVE, MOVE_MS);
                } else {
                    make();
                }
            }
            default -> afterReading();
        }
    }

    private void afterReading() {
        if (playing && !isAtEnd()) {
            begin();
        } else {
            playing = false;
            phase = Phase.STILL;
        }
        tell();
    }

    private void make() {
        int words = run.done()
                .get(done)
                .element()
                .say()
                .map(say -> say.split("\\s+").length)
                .orElse(0);
        done++;
        enter(Phase.READ, Math.max(LEAST_READ_MS, words * WORD_MS));
        tell();
    }

    private void enter(Phase next, double ms) {
        phase = next;
        left = ms;
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }

    /** Adds a listener that is notified when another edit is shown, or it plays on or stays. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
