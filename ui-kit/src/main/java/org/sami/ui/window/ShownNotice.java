package org.sami.ui.window;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.sami.ui.window.Notices.Notice;

/** The last notice, for as long as it is news: what was done for 10 s, why something was not done for 30 s. On one thread. */
final class ShownNotice {
    private static final long DONE_NS = TimeUnit.SECONDS.toNanos(10);
    private static final long REFUSED_NS = TimeUnit.SECONDS.toNanos(30);

    private final LongSupplier nanos;
    private Optional<Notice> last = Optional.empty();
    private long shownAt;

    /**
     * Nothing was reported yet.
     *
     * @param nanos a clock that only goes on, in ns
     */
    ShownNotice(LongSupplier nanos) {
        this.nanos = nanos;
    }

    /** Shows a notice from now on, instead of the one before. */
    void tell(Notice notice) {
        last = Optional.of(notice);
        shownAt = nanos.getAsLong();
    }

    /** The notice to show now; empty where none was reported, or it has been shown long enough. */
    Optional<Notice> now() {
        return leftMillis() > 0 ? last : Optional.empty();
    }

    /** For how long it is to be shown yet, in ms; 0 where nothing is. */
    long leftMillis() {
        long age = nanos.getAsLong() - shownAt;
        return last.map(notice -> (notice.refused() ? REFUSED_NS : DONE_NS) - age)
                .map(left -> left <= 0 ? 0 : Math.max(1, TimeUnit.NANOSECONDS.toMillis(left)))
                .orElse(0L);
    }
}
