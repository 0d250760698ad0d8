package org.sami.crw.operator.alarm;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.sami.crw.operator.boat.BoatSnapshot;

/**
 * Which boats of a fleet are ready for a mission. Immutable.
 *
 * @param checks of each boat by its id, in the order of the fleet, without the trial of the motor
 */
public record FleetCheck(Map<String, LaunchCheck> checks) {
    private static final int MOST_NAMES = 4;

    public FleetCheck {
        checks = Collections.unmodifiableMap(new LinkedHashMap<>(checks));
    }

    /** Goes through all boats. */
    public static FleetCheck of(Collection<BoatSnapshot> boats, LaunchFacts known) {
        Map<String, LaunchCheck> checks = new LinkedHashMap<>();
        boats.forEach(boat -> checks.put(boat.boat(), LaunchCheck.of(boat, OptionalDouble.empty(), known)));
        return new FleetCheck(checks);
    }

    /** The boats that are not ready. */
    public List<String> notReady() {
        return checks.entrySet().stream()
                .filter(check -> !check.getValue().isReady())
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Such as {@code 2 of 20 boats are not ready: dora, emil}; empty text where all are. */
    public String words() {
        List<String> names = notReady();
        if (names.isEmpty()) {
            return "";
        }
        String named = names.size() <= MOST_NAMES
                ? String.join(", ", names)
                : String.join(", ", names.subList(0, MOST_NAMES)) + " and " + (names.size() - MOST_NAMES) + " more";
        return names.size() + " of " + checks.size() + (checks.size() == 1 ? " boat" : " boats")
                + (names.size() == 1 ? " is" : " are") + " not ready: " + named;
    }

    /** A line for each boat that is not ready, with the reasons. */
    public List<String> reasons() {
        return checks.entrySet().stream()
                .filter(check -> !check.getValue().isReady())
                .map(check -> check.getKey() + ": " + check.getValue().words())
                .toList();
    }
}
