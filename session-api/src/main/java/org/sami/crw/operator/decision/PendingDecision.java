package org.sami.crw.operator.decision;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.markup.Attention;
import org.sami.crw.operator.DecisionQueue;
import org.sami.spn.protocol.Decision;

/**
 * A decision that waits for the operator.
 *
 * @param presentation how it is to be shown
 * @param openedAtMillis when it was asked, on the session's clock
 * @param attended whether the operator has turned to it ({@link DecisionQueue#attend})
 */
public record PendingDecision(DecisionPresentation presentation, long openedAtMillis, boolean attended) {
    public PendingDecision {
        Objects.requireNonNull(presentation, "presentation");
    }

    /** A decision to which nobody has turned, and of which it is not known what asks it. */
    public PendingDecision(Decision decision, long openedAtMillis) {
        this(DecisionPresenter.plain(decision), openedAtMillis, false);
    }

    /** The decision, with its question as it is asked. */
    public Decision decision() {
        return presentation.decision();
    }

    /** Id of the plan whose mission asks; empty text where the domain asks. */
    public String plan() {
        return presentation.asker().plan();
    }

    /** Name of the mission that asks; empty text where the domain asks. */
    public String mission() {
        return presentation.asker().mission();
    }

    /** Id of the place whose output event asks; empty text where none does. */
    public String place() {
        return presentation.asker().place();
    }

    /** How attention is drawn to it now: no longer when the operator has turned to it. */
    public Optional<Attention> attention() {
        return attended ? Optional.empty() : presentation.attention();
    }

    /** For how many milliseconds it has waited. */
    public long ageMillis(long nowMillis) {
        return Math.max(0, nowMillis - openedAtMillis);
    }

    /** After how many milliseconds autonomy answers; empty where it never does. */
    public OptionalLong autonomyInMillis(long nowMillis) {
        return presentation.autonomy().remainingMillis(nowMillis);
    }
}
