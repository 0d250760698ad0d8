package org.sami.crw.handler;

import java.util.Map;
import java.util.Set;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.planning.BoatDemands;

/**
 * The handlers of one domain, in addition to those that every session has. A domain in a module of its own names its class in
 * {@code META-INF/services/org.sami.crw.handler.HandlerModule}; it is found by the name that the vocabulary has (decision 0480).
 */
public interface HandlerModule {
    /** The domain's name, as its {@code domain.json} says. */
    String domain();

    /** The kind of robots that its plans command. */
    RobotKind robots();

    /** The output events that move robots of this kind: no other robot can do what they ask. */
    default Set<String> moves() {
        return Set.of();
    }

    /** The output events, by their types, that demand more of robots of this kind than to move. */
    default Map<String, BoatDemands.Demand> demands() {
        return Map.of();
    }

    /** Adds the handlers for one host. Called once for each host. */
    void addTo(HandlerParts parts);
}
