package org.sami.crw.operator.boat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The state of the fleet stop. Stopped boats do not move before they are released, whatever the command of a base; a vehicle with an autopilot of its own can be
 * armed by others all the same.
 *
 * @param everyBoat whether this base stopped the whole fleet, including boats that join later
 * @param here boats stopped by this base
 * @param elsewhere boats stopped by another base, or by this one before its restart
 * @param by the clients that stopped those, by boat, where the boats report them
 * @param overridden vehicles that somebody armed after they were stopped, with what is said of each: who did, and whether it moves
 * @param free the other boats
 * @param unreached boats that have never answered, by their names or addresses
 * @param sinceMillis time of the first stop on the session's clock; 0 for none
 */
public record FleetStopState(
        boolean everyBoat,
        List<String> here,
        List<String> elsewhere,
        Map<String, String> by,
        Map<String, String> overridden,
        List<String> free,
        List<String> unreached,
        long sinceMillis) {
    /** Nobody is stopped. */
    public static final FleetStopState NONE =
            new FleetStopState(false, List.of(), List.of(), Map.of(), Map.of(), List.of(), List.of(), 0);

    /** Slower than this a boat may as well drift, in m/s. */
    public static final double MOVES_MPS = 0.3;

    public FleetStopState {
        here = List.copyOf(here);
        elsewhere = List.copyOf(elsewhere);
        by = Collections.unmodifiableMap(new LinkedHashMap<>(by));
        overridden = Collections.unmodifiableMap(new LinkedHashMap<>(overridden));
        free = List.copyOf(free);
        unreached = List.copyOf(unreached);
    }

    /** Whether any boat is stopped, or all are to be. */
    public boolean isLatched() {
        return everyBoat || stopped() > 0 || !overridden.isEmpty();
    }

    /** Whether it is the state of the whole fleet, not of some boats that were stopped one by one. */
    public boolean isOfFleet() {
        return everyBoat || (stopped() + overridden.size() > 0 && free.isEmpty());
    }

    /** Whether a boat is stopped, or will be as soon as it can be reached. */
    public boolean stops(String boat) {
        return everyBoat || here.contains(boat) || elsewhere.contains(boat) || overridden.containsKey(boat);
    }

    /** Why a boat is not to move, or that it moves all the same, such as {@code it is stopped, and nothing moves before the release}; empty text for one that is not stopped. */
    public String words(String boat) {
        String armed = overridden.get(boat);
        if (armed != null) {
            return "it was stopped, and " + armed;
        }
        return stops(boat) ? "it is stopped, and nothing moves before the release" : "";
    }

    private int stopped() {
        return here.size() + elsewhere.size();
    }

    /**
     * Such as {@code FLEET STOP: 3 of 4 boats are stopped; nothing moves before the release; dora has not said so}; empty text where nobody is stopped. A stop that
     * was not sent from here is called so, with who latched it where the boats say that.
     */
    public String words() {
        if (!isLatched()) {
            return "";
        }
        boolean notFromHere = here.isEmpty() && !elsewhere.isEmpty() && !everyBoat;
        String whence = !notFromHere ? "" : areAllNamed() ? " by " + clients() : ", not from here";
        String armed = overridden.entrySet().stream()
                .map(one -> one.getKey() + " " + one.getValue() + "; ")
                .collect(Collectors.joining());
        if (!isOfFleet()) {
            List<String> who = new ArrayList<>(here);
            who.addAll(elsewhere);
            if (who.isEmpty()) {
                return "Stopped, but " + armed.substring(0, armed.length() - 2);
            }
            return "Stopped" + whence + ": " + armed + String.join(", ", who) + "; "
                    + (who.size() == 1 ? "it does" : "they do") + " not move before the release"
                    + (notFromHere ? "" : notFromHere());
        }
        List<String> silent = new ArrayList<>(free);
        silent.addAll(unreached);
        int all = stopped() + overridden.size() + silent.size();
        String counted = all == 0
                ? "whoever joins is stopped"
                : stopped() + " of " + all + (all == 1 ? " boat " : " boats ") + (stopped() == 1 ? "is" : "are")
                        + " stopped";
        String late = silent.isEmpty()
                ? ""
                : "; " + String.join(", ", silent) + (silent.size() == 1 ? " has" : " have") + " not said so";
        String others = armed.isEmpty() ? "nothing" : "nothing else";
        return "FLEET STOP" + whence + ": " + armed + counted + "; " + others + " moves before the release" + late
                + (notFromHere ? "" : notFromHere());
    }

    private String notFromHere() {
        List<String> unnamed =
                elsewhere.stream().filter(boat -> !by.containsKey(boat)).toList();
        StringBuilder words = new StringBuilder();
        by.forEach(
                (boat, client) -> words.append("; ").append(boat).append(" by ").append(client));
        if (!unnamed.isEmpty()) {
            words.append("; ").append(String.join(", ", unnamed)).append(" not from here");
        }
        return words.toString();
    }

    private boolean areAllNamed() {
        return !elsewhere.isEmpty() && by.keySet().containsAll(elsewhere);
    }

    private String clients() {
        return by.values().stream().distinct().collect(Collectors.joining(" and "));
    }

    /** What the operator can do about it: one sentence without a full stop at its end. */
    public String advice() {
        if (!overridden.isEmpty()) {
            return "Stop it again (F12 disarms it at once), or have whoever armed it stop it";
        }
        String release = "elease it in two steps; commands wait until then";
        return elsewhere.isEmpty()
                ? "When all is clear, r" + release
                : "Ask " + (areAllNamed() ? clients() : "the other base") + ", then r" + release;
    }

    /** Who stopped boats that were not stopped from here, as a sentence without a full stop; empty text where there are none. */
    public String details() {
        return elsewhere.isEmpty()
                ? ""
                : (areAllNamed() ? clients() + " stopped it, another base" : "Another base stopped it")
                        + ", or this one before it started anew";
    }
}
