package org.sami.crw.session.file;

import java.util.Locale;
import java.util.Objects;
import org.sami.crw.proxy.file.FleetFileFetch;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * Progress of the fetch of one boat's logs. Immutable.
 *
 * @param boat its name
 * @param state the progress
 * @param words the same in words for people
 */
public record LogRow(String boat, BoatAddress address, State state, String words) {
    private static final double MEGABYTE = 1e6;
    private static final double KILOBYTE = 1e3;

    /** Progress of a fetch. */
    public enum State {
        /** Nothing is asked of it. */
        IDLE,
        /** Files come, or are listed. */
        FETCHING,
        /** It does not answer, and is tried again. */
        NO_ANSWER,
        /** All its files are here. */
        HERE,
        /** It keeps no log. */
        NO_LOG,
        /** It does not give all of its files. */
        FAILED,
        /** It was cancelled before all were here. */
        CANCELLED
    }

    /** Refuses a row without its parts. */
    public LogRow {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(address, "address");
        Objects.requireNonNull(state, "state");
        Objects.requireNonNull(words, "words");
    }

    static LogRow idle(String boat, BoatAddress address) {
        return new LogRow(boat, address, State.IDLE, "");
    }

    LogRow asked() {
        return new LogRow(boat, address, State.FETCHING, "asked for its files");
    }

    LogRow come(String name, long here, long bytes) {
        return new LogRow(
                boat, address, State.FETCHING, name + ", " + 100 * here / Math.max(1, bytes) + " % of " + size(bytes));
    }

    LogRow unanswered(String why) {
        return new LogRow(boat, address, State.NO_ANSWER, "no answer (" + why + "); goes on when it answers");
    }

    LogRow ended(FleetFileFetch.Answer answer, boolean cancelled) {
        if (answer.done() && answer.files().isEmpty()) {
            return new LogRow(boat, address, State.NO_LOG, "keeps no log");
        } else if (answer.done()) {
            String files =
                    answer.files().size() == 1 ? "1 file" : answer.files().size() + " files";
            String fetched = answer.bytes() == 0 ? "nothing new" : size(answer.bytes()) + " fetched";
            return new LogRow(boat, address, State.HERE, files + ", " + fetched);
        }
        String faults = String.join("; ", answer.faults());
        String kept = answer.files().isEmpty()
                ? ""
                : "; the other files are here: " + answer.files().size();
        return cancelled
                ? new LogRow(boat, address, State.CANCELLED, "cancelled; what has come is kept")
                : new LogRow(boat, address, State.FAILED, faults + kept);
    }

    private static String size(long bytes) {
        return bytes >= MEGABYTE
                ? String.format(Locale.ROOT, "%.1f MB", bytes / MEGABYTE)
                : String.format(Locale.ROOT, "%.0f kB", Math.ceil(bytes / KILOBYTE));
    }
}
