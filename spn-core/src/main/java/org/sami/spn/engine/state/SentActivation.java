package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;

/** An activation as the engine remembers it: with its visit and what the engine itself does for it. */
public final class SentActivation {
    public final Activation activation;
    public final Visit visit;
    public final CompiledOutput output;
    /** Whether task tokens entered. */
    public final boolean hasTasks;

    public boolean open = true;
    /** The id of the open decision that asks for it; {@link Ids#NONE} where none does. */
    public long decision = Ids.NONE;

    public List<RunningTimer> timers = List.of();
    private @Nullable SentActivation next;

    public SentActivation(Activation activation, Visit visit, CompiledOutput output) {
        this.activation = activation;
        this.visit = visit;
        this.output = output;
        this.hasTasks = hasTasks(activation.tokens());
    }

    private static boolean hasTasks(List<Token> tokens) {
        for (Token token : tokens) {
            if (token instanceof Token.Task) {
                return true;
            }
        }
        return false;
    }

    private SentActivation(SentActivation old, Visit visit) {
        this.activation = old.activation;
        this.visit = visit;
        this.output = old.output;
        this.hasTasks = old.hasTasks;
    }

    /** The same activation in the copy of a state, without decision and timers. */
    SentActivation copy(Visit visit) {
        return new SentActivation(this, visit);
    }

    /** The one that was sent next for the visit; null where none was. */
    public @Nullable SentActivation next() {
        return next;
    }

    void isFollowedBy(SentActivation later) {
        next = later;
    }

    public MissionState mission() {
        return visit.place.mission;
    }

    public void add(RunningTimer timer) {
        if (timers.isEmpty()) {
            timers = new ArrayList<>(1);
        }
        timers.add(timer);
    }
}
