package org.sami.crw.gui.file;

import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.RefusedException;

/**
 * Asks a session now and then which boats it has links to: not before it has answered, and not again once it refused. A base of an older version does not know the question and does not say
 * which of its requests that was; it ends the connection of a window that goes on asking. On the event thread.
 */
final class LinkQuestion {
    private static final int PATIENCE = 10; // looks without an answer

    private final Supplier<CompletionStage<List<LinkedBoat>>> question;
    private final Consumer<List<LinkedBoat>> answered;
    private final Consumer<String> unanswered;
    private boolean waiting;
    private boolean refused;
    private int looks;

    /**
     * Asks nothing yet.
     *
     * @param question is answered on the event thread
     * @param answered receives the boats
     * @param unanswered receives in words why none are known; empty once they are
     */
    LinkQuestion(
            Supplier<CompletionStage<List<LinkedBoat>>> question,
            Consumer<List<LinkedBoat>> answered,
            Consumer<String> unanswered) {
        this.question = question;
        this.answered = answered;
        this.unanswered = unanswered;
    }

    /** Asks, also where it was refused before; for who opens the view anew. */
    void begin() {
        refused = false;
        look();
    }

    /** Asks unless an answer is still to come or it was refused; to be called now and then. */
    void look() {
        if (refused) {
            return;
        }
        if (waiting) {
            if (++looks == PATIENCE) {
                unanswered.accept(
                        "the session does not say which boats it has links to; bring its base to this version");
            }
            return;
        }
        waiting = true;
        looks = 0;
        question.get().whenComplete((boats, fault) -> take(boats, fault));
    }

    private void take(List<LinkedBoat> boats, @Nullable Throwable fault) {
        waiting = false;
        if (fault != null) {
            refused = true;
            unanswered.accept(RefusedException.reason(fault));
        } else {
            unanswered.accept("");
            answered.accept(boats);
        }
    }

    /** Whether nothing more is asked until it is begun anew. */
    boolean isRefused() {
        return refused;
    }
}
