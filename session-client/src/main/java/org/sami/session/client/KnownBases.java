package org.sami.session.client;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The bases at which a front may find its session, and which base it tries next: first the current base, then the others in turn. The waits between rounds grow. For one
 * thread.
 */
final class KnownBases {
    private static final long FIRST_WAIT_MS = 1000;
    private static final long LONGEST_WAIT_MS = 8000;

    /** With several bases a round costs little, and one of them takes over within seconds. */
    private static final long FIRST_WAIT_OF_SEVERAL_MS = 500;

    private static final long LONGEST_WAIT_OF_SEVERAL_MS = 1000;

    private final List<SessionAddress> all = new ArrayList<>();
    private final Set<SessionAddress> leftOut = new HashSet<>();
    private final Map<SessionAddress, String> faults = new LinkedHashMap<>(); // of this round: why not
    private int at;
    private int rounds;
    private boolean standby; // answered in this round
    private long epoch;

    /** Bases that a person has named; the first is tried first. */
    KnownBases(List<SessionAddress> named) {
        add(named);
        if (all.isEmpty()) {
            throw new IllegalArgumentException("a session is at one address at least");
        }
    }

    /** Takes up bases that one of them has named, but for those that were left out. */
    final void add(List<SessionAddress> announced) {
        announced.stream()
                .filter(one -> !all.contains(one) && !leftOut.contains(one))
                .forEach(all::add);
    }

    /** All of them. */
    List<SessionAddress> all() {
        return List.copyOf(all);
    }

    /** The one that is tried, or that holds the session. */
    SessionAddress current() {
        return all.get(at);
    }

    /** All bases but the current one. */
    List<SessionAddress> others() {
        return all.stream().filter(one -> !one.equals(current())).toList();
    }

    /** Makes a known base the current one, to be tried next. */
    void turnTo(SessionAddress known) {
        at = Math.max(0, all.indexOf(known));
    }

    /** Whether there is more than one base. */
    boolean areSeveral() {
        return all.size() > 1;
    }

    /**
     * A connection that stood is lost. Gives how many milliseconds to wait before the next is made.
     *
     * @param silent whether the base did not answer: the next base is tried first then; else the same one
     */
    long lost(boolean silent) {
        begin();
        if (silent) {
            at = (at + 1) % all.size();
        }
        return areSeveral() ? 0 : FIRST_WAIT_MS;
    }

    private void begin() {
        faults.clear();
        standby = false;
        rounds = 0;
    }

    /** The current base cannot be reached, or is a standby. */
    void failed(String why, boolean isStandby) {
        faults.put(current(), why);
        standby |= isStandby;
    }

    /** Whether all have been tried in this round. */
    boolean isRoundOver() {
        return faults.keySet().containsAll(all);
    }

    /** Whether none of this round's bases said that another holds the session. */
    boolean nobodyWaits() {
        return !standby;
    }

    /** Why none of this round's bases can be used. */
    String faults() {
        return faults.values().stream().distinct().collect(Collectors.joining("; "));
    }

    /** Turns to the next base; gives how many milliseconds to wait before it is tried. */
    long next() {
        boolean over = isRoundOver();
        at = (at + 1) % all.size();
        if (!over) {
            return 0;
        }
        faults.clear();
        standby = false;
        long first = areSeveral() ? FIRST_WAIT_OF_SEVERAL_MS : FIRST_WAIT_MS;
        long longest = areSeveral() ? LONGEST_WAIT_OF_SEVERAL_MS : LONGEST_WAIT_MS;
        return Math.min(longest, first << Math.min(rounds++, 10));
    }

    /** Never tries the current base again: it does not let this person in, or has another session. Gives whether there are others; the next one is current then. */
    boolean leaveOut() {
        if (!areSeveral()) {
            return false;
        }
        faults.remove(current());
        leftOut.add(all.remove(at));
        at %= all.size();
        return true;
    }

    /** Whether another base has held the session after the current one: then the current base holds it no longer, whatever it reports. */
    boolean isSuperseded(long itsEpoch) {
        return itsEpoch < epoch;
    }

    /** The current base holds the session. */
    void holds(long itsEpoch) {
        epoch = itsEpoch;
        begin();
    }
}
