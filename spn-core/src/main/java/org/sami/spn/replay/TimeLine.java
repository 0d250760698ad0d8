package org.sami.spn.replay;

import java.util.List;
import java.util.NavigableSet;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.TreeSet;
import org.sami.spn.protocol.Ids;

/** When what happened in a session: its end, and marks in order of time. Times are ms of the session's clock, which begins with 0. */
public final class TimeLine {
    private final long endMillis;
    private final List<Mark> marks;
    private final NavigableSet<Long> moments;

    /** What sort of thing happened. */
    public enum Kind {
        MISSION_STARTED,
        MISSION_ENDED,
        DECISION_ASKED,
        DECISION_ANSWERED,
        MESSAGE,
        ALARM,
        /** The operator did something of their own: pressed an interrupt, aborted, wrote a variable, loaded a project. */
        OPERATOR
    }

    /**
     * Something that happened.
     *
     * @param id of the mission or decision; {@link Ids#NONE} where there is none
     * @param text one line
     */
    public record Mark(long atMillis, Kind kind, long id, String text) {
        public Mark {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(text, "text");
        }
    }

    /**
     * A time line.
     *
     * @param marks in order of time
     * @param moments when the engine took a step
     */
    public TimeLine(long endMillis, List<Mark> marks, NavigableSet<Long> moments) {
        this.endMillis = endMillis;
        this.marks = List.copyOf(marks);
        this.moments = new TreeSet<>(moments);
    }

    /** The last moment of which the journal knows. */
    public long endMillis() {
        return endMillis;
    }

    /** What happened, in order of time. */
    public List<Mark> marks() {
        return marks;
    }

    /** When a decision was asked or a mission began, and the like; empty where that never happened. */
    public OptionalLong when(Kind kind, long id) {
        return marks.stream()
                .filter(mark -> mark.kind() == kind && mark.id() == id)
                .mapToLong(Mark::atMillis)
                .findFirst();
    }

    /** The next moment after one at which the engine took a step; the end where there is none. */
    public long stepAfter(long atMillis) {
        Long next = moments.higher(atMillis);
        return next == null ? endMillis : next;
    }

    /** The last moment before one at which the engine took a step; the start where there is none. */
    public long stepBefore(long atMillis) {
        Long last = moments.lower(atMillis);
        return last == null ? 0 : last;
    }

    /** The next mark after a moment; the end where there is none. */
    public long markAfter(long atMillis) {
        return marks.stream()
                .mapToLong(Mark::atMillis)
                .filter(at -> at > atMillis)
                .findFirst()
                .orElse(endMillis);
    }

    /** The last mark before a moment; the start where there is none. */
    public long markBefore(long atMillis) {
        return marks.stream()
                .mapToLong(Mark::atMillis)
                .filter(at -> at < atMillis)
                .max()
                .orElse(0);
    }
}
