package org.sami.session.api;

import java.util.concurrent.CompletionException;

/** What was asked of a session was not done; the message says why, in one sentence for the operator. */
public final class RefusedException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** A refusal for a reason. */
    public RefusedException(String reason) {
        super(reason);
    }

    /** Why a stage failed, in one sentence, whatever the stage has wrapped it in. */
    public static String reason(Throwable fault) {
        Throwable cause = fault instanceof CompletionException && fault.getCause() != null ? fault.getCause() : fault;
        return cause instanceof RefusedException || cause instanceof IllegalArgumentException
                ? String.valueOf(cause.getMessage())
                : cause.toString();
    }
}
