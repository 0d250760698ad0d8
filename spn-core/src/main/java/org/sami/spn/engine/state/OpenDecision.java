package org.sami.spn.engine.state;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.protocol.Decision;

/** A decision that waits for its answer, with what the answer is for. */
public final class OpenDecision {
    /** What the answer is for. */
    public enum Purpose {
        ACTIVATION,
        PARAMETERS,
        INTERRUPT_CHOICE,
        ABORTED_CHILD,
        DOMAIN
    }

    /** The subject of a choice that offers the robots that stood in its place, for nobody entered it. */
    public static final String STANDING = "standing";

    /** Replaced by one without a deadline where the operator holds it. */
    public Decision decision;

    public final Purpose purpose;
    /** The mission that asks; null where the domain does. */
    public final @Nullable MissionState mission;
    /** The asking activation; for an interrupt's choice the first that offers it; else null. */
    public final @Nullable SentActivation sent;
    /** The aborted child, else null. */
    public final @Nullable Instance instance;
    /** The interrupt whose robots are chosen, or the subject of the domain's question, or {@link #STANDING}; else empty text. */
    public final String subject;

    public @Nullable RunningTimer deadline;

    public OpenDecision(
            Decision decision,
            Purpose purpose,
            @Nullable MissionState mission,
            @Nullable SentActivation sent,
            @Nullable Instance instance,
            String subject) {
        this.decision = decision;
        this.purpose = purpose;
        this.mission = mission;
        this.sent = sent;
        this.instance = instance;
        this.subject = subject;
    }

    /** The mission that asks; not for a question of the domain's. */
    public MissionState asker() {
        return Objects.requireNonNull(mission, "the mission of the domain's question");
    }

    /** The asking activation; only where an activation asks. */
    public SentActivation activation() {
        return Objects.requireNonNull(sent, "the activation of a question that none asks");
    }
}
