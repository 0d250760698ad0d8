package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;

/**
 * Which address each port of this machine, and each port of another one, is open with. One that is asked for anew takes the place of one that differs in its
 * speed alone. The earlier one goes on being asked for, as bases try all their addresses again: it gets its place back only where nothing has come on the
 * later one. A link that has brought nothing is closed once nobody asks for it. For the gateway's thread.
 */
final class OpenedAddresses {
    /** For so long an earlier address leaves the place to the later one: two attempts. */
    private static final long TURN_MS = 8_000;

    /** An address that was not asked for within this time was given up: longer than a base waits between two attempts. */
    private static final long GIVEN_UP_MS = 15_000;

    private final MavlinkBase base;
    private final Map<String, MavlinkAddress> open = new HashMap<>(); // by place
    private final Map<String, Long> openedMs = new HashMap<>(); // by place
    private final Map<MavlinkAddress, Long> askedMs = new HashMap<>();

    OpenedAddresses(MavlinkBase base) {
        this.base = base;
    }

    /**
     * An address is asked for: it is opened, unless its place is open already and is to stay so.
     *
     * @param isHome whether a vehicle was found at it before; it is asked for again as the way to that one was lost
     */
    void ask(MavlinkAddress address, boolean isHome, long nowMs) {
        Optional<MavlinkAddress> present = Optional.ofNullable(open.get(address.place()));
        boolean isNew = !isHome && !isAsked(address, nowMs);
        askedMs.put(address, nowMs);
        boolean isOtherTurn = present.isPresent()
                && !hasBroughtSomething(present.get())
                && nowMs - openedMs.getOrDefault(address.place(), nowMs) >= TURN_MS;
        if (present.isEmpty() || (!present.get().equals(address) && (isNew || isOtherTurn))) {
            base.open(address);
            open.put(address.place(), address);
            openedMs.put(address.place(), nowMs);
        }
    }

    private boolean isAsked(MavlinkAddress address, long nowMs) {
        return Optional.ofNullable(askedMs.get(address))
                .filter(atMs -> nowMs - atMs <= GIVEN_UP_MS)
                .isPresent();
    }

    /** The address with which the place of an address is open; the address itself where it is not. */
    MavlinkAddress present(MavlinkAddress address) {
        return open.getOrDefault(address.place(), address);
    }

    private boolean hasBroughtSomething(MavlinkAddress link) {
        return base.links().stream()
                .filter(report -> report.address().equals(link))
                .anyMatch(report -> report.messages() > 0 || !report.refused().isEmpty());
    }

    /**
     * Closes what nobody has asked for lately, and on which nothing has come.
     *
     * @param isWaited whether a connection waits for what comes on a link
     */
    void closeUnused(Predicate<MavlinkAddress> isWaited, long nowMs) {
        open.values().removeIf(link -> {
            boolean isLeft = !isWaited.test(link) && !isPlaceAsked(link.place(), nowMs) && !hasBroughtSomething(link);
            if (isLeft) {
                base.close(link);
            }
            return isLeft;
        });
    }

    private boolean isPlaceAsked(String place, long nowMs) {
        return askedMs.keySet().stream().anyMatch(one -> one.place().equals(place) && isAsked(one, nowMs));
    }
}
