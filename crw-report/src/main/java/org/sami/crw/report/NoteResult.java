package org.sami.crw.report;

import java.util.Objects;

/**
 * Something that was noted while the run went on.
 *
 * @param kind the engine's word for it, in lower case, such as {@code late}
 */
public record NoteResult(long atMillis, String kind, long mission, String message) {
    /** News that nobody had asked for and no transition waited for: nothing is lost by it. */
    public static final String NEWS = "news";

    /** A question that the simulated operator could not answer by its rules. */
    public static final String UNANSWERED = "unanswered";

    /** What a plan asked and nobody could do. */
    public static final String HANDLER_FAILED = "handler_failed";

    /** A boat was, or was sent, where it may not be. */
    public static final String FENCE = "fence";

    /** A mission could not go on by itself, or went on. */
    public static final String STUCK = "stuck";

    /** A message of a handler or service to the operator. */
    public static final String DOMAIN_MESSAGE = "domain message";

    /** What could not be written to the journal. */
    public static final String JOURNAL = "journal";

    /** Whether it is a problem that no plan hears of: a run with one has problems, however it ends. */
    public boolean isProblem() {
        return kind.equals(HANDLER_FAILED) || kind.equals(UNANSWERED) || kind.equals(JOURNAL);
    }

    public NoteResult {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(message, "message");
    }
}
