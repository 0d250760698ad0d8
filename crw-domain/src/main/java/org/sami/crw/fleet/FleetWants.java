package org.sami.crw.fleet;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Work outside the engine that missions wait for, at a moment.
 *
 * @param commands ids of the boats with a running or waiting command, by mission
 * @param computing missions for which a service computes
 * @param asking missions whose commands wait for the operator's answer about a boat's way
 */
public record FleetWants(Map<Long, Set<String>> commands, Set<Long> computing, Set<Long> asking) {
    /** Nothing is under way. */
    public static final FleetWants NOTHING = new FleetWants(Map.of(), Set.of(), Set.of());

    public FleetWants {
        commands = Collections.unmodifiableMap(new LinkedHashMap<>(commands));
        computing = Set.copyOf(computing);
        asking = Set.copyOf(asking);
    }

    /** The boats that have a command of a mission. */
    public Set<String> boatsOf(long mission) {
        return commands.getOrDefault(mission, Set.of());
    }

    /** Whether something is under way for a mission. */
    public boolean wantsSomething(long mission) {
        return commands.containsKey(mission) || computing.contains(mission) || asking.contains(mission);
    }
}
