package org.sami.crw.operator.boat;

import java.util.List;

/**
 * How the fleet stop stands. Stopped boats do not move before they are released, whatever they are told.
 *
 * @param everyBoat whether this base stopped the whole fleet, and whoever joins it
 * @param here boats that are stopped from this base
 * @param elsewhere boats that another base stopped, or this one before it started anew
 * @param free the other boats
 * @param sinceMillis when the first of them was stopped, on the session's clock; 0 where none is
 */
public record FleetStopState(
        boolean everyBoat, List<String> here, List<String> elsewhere, List<String> free, long sinceMillis) {
    /** Nobody is stopped. */
    public static final FleetStopState NONE = new FleetStopState(false, List.of(), List.of(), List.of(), 0);

    private static final String RELEASE = "nothing moves before the release";

    public FleetStopState {
        here = List.copyOf(here);
        elsewhere = List.copyOf(elsewhere);
        free = List.copyOf(free);
    }

    /** Whether any boat is stopped, or all are to be. */
    public boolean isLatched() {
        return everyBoat || stopped() > 0;
    }

    /** Whether it is the state of the whole fleet, not of some boats that were stopped one by one. */
    public boolean isOfFleet() {
        return everyBoat || (stopped() > 0 && free.isEmpty());
    }

    /** Whether a boat is stopped, or is to be as soon as it can be told. */
    public boolean stops(String boat) {
        return everyBoat || here.contains(boat) || elsewhere.contains(boat);
    }

    private int stopped() {
        return here.size() + elsewhere.size();
    }

    /** Such as {@code FLEET STOP: 3 of 4 boats are stopped, dora has not said so; nothing moves before the release}; empty text where nobody is stopped. */
    public String words() {
        if (!isLatched()) {
            return "";
        }
        String by = elsewhere.isEmpty()
                ? ""
                : here.isEmpty() && !everyBoat
                        ? " by another base or an earlier start of this one"
                        : ", " + String.join(", ", elsewhere) + " by another base or an earlier start of this one";
        if (!isOfFleet()) {
            String who = String.join(", ", here.isEmpty() ? elsewhere : here);
            int count = here.isEmpty() ? elsewhere.size() : here.size();
            return "Stopped" + (here.isEmpty() ? by : "") + ": " + who + (here.isEmpty() ? "" : by) + "; "
                    + (count == 1 && stopped() == 1 ? "it does" : "they do") + " not move before the release";
        }
        int all = stopped() + free.size();
        String late = free.isEmpty()
                ? ""
                : ", " + String.join(", ", free) + (free.size() == 1 ? " has" : " have") + " not said so";
        String counted = all == 0
                ? "whoever joins is stopped"
                : stopped() + " of " + all + (all == 1 ? " boat " : " boats ") + (stopped() == 1 ? "is" : "are")
                        + " stopped";
        return "FLEET STOP: " + counted + by + late + "; " + RELEASE;
    }
}
