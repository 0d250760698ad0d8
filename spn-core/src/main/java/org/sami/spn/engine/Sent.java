package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Token;

/** An activation as the engine remembers it: with its visit and what the engine itself does for it. */
final class Sent {
    final Activation activation;
    final Visit visit;
    final CompiledOutput output;
    /** Whether task tokens entered. */
    final boolean hasTasks;

    boolean open = true;
    OpenDecision decision;
    List<Timer> timers = List.of();

    Sent(Activation activation, Visit visit, CompiledOutput output) {
        this.activation = activation;
        this.visit = visit;
        this.output = output;
        this.hasTasks = activation.tokens().stream().anyMatch(Token.Task.class::isInstance);
    }

    Mission mission() {
        return visit.place.mission;
    }

    void add(Timer timer) {
        if (timers.isEmpty()) {
            timers = new ArrayList<>(1);
        }
        timers.add(timer);
    }
}
