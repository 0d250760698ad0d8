package org.sami.crw.session.standby;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalFollower;
import org.sami.spn.journal.JournalPart;

/**
 * Reads another base's session while this base waits to go on with it, and applies its entries to an engine of its own, on a daemon thread: no boat and no service is commanded. Where that
 * fails, the session is read when it is taken over. Safe for use by several threads.
 */
public final class WarmStandby implements AutoCloseable {
    private static final long LOOK_MS = 150;

    /** A look that takes longer, once the session is taken over, hangs on a connection that was cut. */
    private static final long LAST_LOOK_MS = 5000;

    private static final long SAY_AGAIN_NS = TimeUnit.MINUTES.toNanos(1);
    private static final long TRY_AGAIN_NS = TimeUnit.SECONDS.toNanos(1);
    private static final double SLOW_S = 2;

    private final JournalFollower follower;
    private final Consumer<String> lines;
    private final LongSupplier nanos;
    private final Runnable whenWarm;
    private final ReentrantLock following = new ReentrantLock();
    private final ScheduledExecutorService thread;
    private final Future<?> looks;
    private volatile Progress progress = new Progress(0, 0, false);
    private boolean over; // this and the following: guarded by the lock
    private boolean failed;
    private String trouble = "";
    private long nextNanos; // no look before
    private String damage = "";
    private long saidIndex;
    private long saidNanos;

    /**
     * How far the session has been applied.
     *
     * @param entry index of the last entry that was applied; 0 where none was
     * @param sinceNanos when the database showed no later one, by the clock of this standby
     * @param warm whether the session has been applied at all
     */
    private record Progress(long entry, long sinceNanos, boolean warm) {}

    /**
     * A standby that begins to read.
     *
     * @param lines how far it is, for people
     * @param nanos a clock that does not jump
     * @param whenWarm called once the session has been applied for the first time; must be quick
     */
    public WarmStandby(JournalAddress journal, Consumer<String> lines, LongSupplier nanos, Runnable whenWarm) {
        this.follower = new JournalFollower(journal);
        this.lines = lines;
        this.nanos = nanos;
        this.nextNanos = nanos.getAsLong();
        this.whenWarm = whenWarm;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "standby of " + journal);
            made.setDaemon(true);
            return made;
        });
        looks = thread.scheduleWithFixedDelay(this::look, 0, LOOK_MS, TimeUnit.MILLISECONDS);
    }

    /** How far it is, such as {@code applied up to entry 4711, 0.2 s behind}. */
    public String progress() {
        return words(progress);
    }

    private String words(Progress at) {
        double behindS = (nanos.getAsLong() - at.sinceNanos) / 1e9;
        return at.warm
                ? String.format(Locale.ROOT, "applied up to entry %d, %.1f s behind", at.entry, behindS)
                : "nothing applied yet";
    }

    private void look() {
        following.lock();
        try {
            if (!over && !failed && nanos.getAsLong() - nextNanos >= 0) {
                follow();
            }
        } finally {
            following.unlock();
        }
    }

    private void follow() {
        long began = nanos.getAsLong();
        try {
            follower.follow();
            boolean first = !progress.warm;
            double slowS = first ? 0 : (began - progress.sinceNanos) / 1e9;
            progress = new Progress(follower.applied(), began, true);
            report(first, began, slowS);
        } catch (JournalException unreadable) {
            nextNanos = nanos.getAsLong() + TRY_AGAIN_NS;
            if (progress.warm) {
                say("cannot read the session: " + unreadable.getMessage());
            }
        } catch (RuntimeException | Error unfit) {
            failed = true; // first: what comes next may fail as well, and the state may be half changed
            progress = new Progress(0, 0, false);
            follower.close();
            lines.accept("cannot apply the session after entry " + follower.applied() + "; it is read when it is taken"
                    + " over: " + Optional.ofNullable(unfit.getMessage()).orElse(unfit.toString()));
        }
    }

    private void report(boolean first, long began, double slowS) {
        String wrong = follower.damage().orElse("");
        if (!wrong.isEmpty() && wrong.equals(damage)) { // found twice: the connection was not cut
            say("the session's journal is damaged: " + wrong + "; applied up to entry " + follower.applied());
        } else if (first) {
            double tookS = (nanos.getAsLong() - began) / 1e9;
            lines.accept(String.format(Locale.ROOT, "warm: %s, read in %.1f s", words(progress), tookS));
            saidIndex = follower.applied();
            saidNanos = began;
            whenWarm.run();
        } else if (!trouble.isEmpty() || slowS > SLOW_S || isNews(began)) {
            lines.accept(words(progress));
            saidIndex = follower.applied();
            saidNanos = began;
            trouble = "";
        }
        damage = wrong;
    }

    private boolean isNews(long now) {
        return follower.applied() != saidIndex && now - saidNanos > SAY_AGAIN_NS;
    }

    private void say(String line) {
        if (!line.equals(trouble)) {
            trouble = line;
            lines.accept(line);
        }
    }

    /**
     * Ends the reading; to be called when nobody else writes the session any more.
     *
     * @return what was read, with the state after the last entry of it; empty where all is to be read
     */
    public Optional<JournalPart> finish() {
        looks.cancel(false);
        thread.shutdown();
        try {
            if (!following.tryLock(LAST_LOOK_MS, TimeUnit.MILLISECONDS)) {
                return Optional.empty();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        }
        try {
            over = true;
            Optional<JournalPart> read = failed ? Optional.empty() : follower.part();
            lines.accept(read.isPresent() ? words(progress) : "reads the session now");
            return read;
        } catch (RuntimeException | Error unfit) {
            failed = true;
            lines.accept("the state that was applied cannot be taken, so the session is read again: " + unfit);
            return Optional.empty();
        } finally {
            follower.close();
            following.unlock();
        }
    }

    /** Ends the reading, where nobody takes what was read. */
    @Override
    public void close() {
        thread.shutdownNow();
    }
}
