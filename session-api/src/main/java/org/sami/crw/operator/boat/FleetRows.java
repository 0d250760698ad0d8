package org.sami.crw.operator.boat;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The rows of a list of boats: those that are known, and those that were to be connected and have never answered. */
public final class FleetRows {
    private FleetRows() {}

    /** A row for each, the boats first. A boat that is known by its name alone says what became of the tries to reach it. */
    public static List<BoatSnapshot> of(
            Collection<BoatSnapshot> boats, Collection<UnreachedBoat> unreached, long nowMillis) {
        Map<String, UnreachedBoat> byName = new HashMap<>();
        unreached.forEach(one -> byName.put(one.name(), one));
        List<BoatSnapshot> rows = new ArrayList<>();
        for (BoatSnapshot boat : boats) {
            UnreachedBoat tried = byName.remove(boat.boat());
            boolean neverAnswered = tried != null && boat.heardAtMillis().isEmpty();
            rows.add(neverAnswered ? tried.row(nowMillis) : boat);
        }
        unreached.stream().filter(byName::containsValue).forEach(one -> rows.add(one.row(nowMillis)));
        return rows;
    }
}
