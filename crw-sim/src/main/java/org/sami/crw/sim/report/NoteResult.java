package org.sami.crw.sim.report;

import java.util.Objects;

/**
 * Something that was noted while the run went on.
 *
 * @param kind the engine's word for it, in lower case, such as {@code late}
 */
public record NoteResult(long atMillis, String kind, long mission, String message) {
    /** News that nobody had asked for and no transition waited for: nothing is lost by it. */
    public static final String NEWS = "news";

    public NoteResult {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(message, "message");
    }
}
