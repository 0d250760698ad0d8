package org.sami.dreamm.learn;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;
import org.sami.lessons.progress.StepProgress;

/**
 * The progress of one learner while he learns: each change is written at once, off the thread that makes it. Its methods are called on one thread.
 */
public final class LearnerRecord implements AutoCloseable {
    /** Who looks at one step for longer than this does something else. */
    private static final long LONGEST_MS = TimeUnit.MINUTES.toMillis(10);

    private static final int END_S = 10;

    private final Learners learners;
    private final LongSupplier clock;
    private final ExecutorService writer = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "learner-progress");
        thread.setDaemon(true);
        return thread;
    });
    private volatile LearnerProgress progress;
    private Consumer<String> failed = why -> {};
    private long shownSince;

    /**
     * The record of a learner.
     *
     * @param opened what was kept of him
     * @param clock milliseconds that pass
     */
    public LearnerRecord(Learners learners, LearnerProgress opened, LongSupplier clock) {
        this.learners = Objects.requireNonNull(learners, "learners");
        progress = Objects.requireNonNull(opened, "opened");
        this.clock = Objects.requireNonNull(clock, "clock");
        shownSince = clock.getAsLong();
    }

    /**
     * Tells somebody, in a sentence, why progress cannot be kept.
     *
     * @param told is called on the thread that writes
     */
    public void whenFailed(Consumer<String> told) {
        failed = Objects.requireNonNull(told, "told");
    }

    /** The name of the learner. */
    public String learner() {
        return progress.learner();
    }

    /** Where he goes on in a course; empty where it has no step. */
    public Optional<StepAddress> resume(Course course) {
        return progress.resume(course);
    }

    /** The file in which his plan of a job is kept. */
    public Path planOf(StepAddress step, String job) {
        try {
            return learners.planOf(learner(), step.lesson(), job);
        } catch (IOException noName) {
            throw new IllegalStateException("the progress of " + learner() + " was opened under that name", noName);
        }
    }

    /** What he has done on a step. */
    public StepProgress on(StepAddress step) {
        return progress.on(step);
    }

    /** He looks at a step now, and at the one before no longer. */
    public void at(StepAddress step) {
        spend();
        change(now -> now.movedTo(step));
    }

    /** Counts the time since he came to the step at which he is. */
    private void spend() {
        long now = clock.getAsLong();
        long spent = Math.min(LONGEST_MS, now - shownSince);
        shownSince = now;
        progress.at()
                .map(address -> address.split("/", 2))
                .filter(parts -> parts.length == 2)
                .ifPresent(parts -> progress = progress.spent(new StepAddress(parts[0], parts[1]), spent));
    }

    /** He has read, looked at or played a step. */
    public void read(StepAddress step) {
        change(now -> now.read(step));
    }

    /** He has answered a quiz, or had a job checked. */
    public void attempted(StepAddress step, boolean right) {
        change(now -> now.attempted(step, right));
    }

    /** He was shown one more hint. */
    public void hinted(StepAddress step) {
        change(now -> now.hinted(step));
    }

    /** He was shown the solution. */
    public void solved(StepAddress step) {
        change(now -> now.solved(step));
    }

    private void change(UnaryOperator<LearnerProgress> how) {
        LearnerProgress next = how.apply(progress);
        if (!next.equals(progress)) {
            progress = next;
            writer.execute(() -> write(next));
        }
    }

    /** What is not the newest any longer is not written. */
    @SuppressWarnings("ReferenceEquality") // each change makes another object
    private void write(LearnerProgress changed) {
        if (changed != progress) {
            return;
        }
        try {
            learners.keep(changed);
        } catch (IOException full) {
            failed.accept("progress cannot be kept: " + full.getMessage());
        }
    }

    /** Writes what is left. */
    @Override
    public void close() {
        if (writer.isShutdown()) {
            return;
        }
        spend();
        LearnerProgress last = progress;
        writer.execute(() -> write(last));
        writer.shutdown();
        try {
            if (!writer.awaitTermination(END_S, TimeUnit.SECONDS)) {
                failed.accept("progress is still being written");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
