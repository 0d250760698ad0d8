package org.sami.mavlink.vehicle;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * The links on which a vehicle is heard. What speaks with its id on a further link is taken for it once time since the start, place and number of the autopilot
 * agree; until then, and where they do not, nothing of it is taken. Used by one thread.
 */
final class OwnLinks {
    private static final int OFTEN = 3; // positions that agree, or do not
    private static final long ANSWER_MS = 3_000; // an autopilot that has not said its number by then says none
    private static final long SILENT_MS = 10_000;

    private final VehicleId id;
    private final VehicleIdentity identity = new VehicleIdentity();
    private final Set<MavlinkAddress> own = new LinkedHashSet<>();
    private final Map<MavlinkAddress, Unsettled> unsettled = new LinkedHashMap<>();
    private long heardMs;

    /** A link on which something speaks with the vehicle's id. */
    private static final class Unsettled {
        private final VehicleIdentity identity = new VehicleIdentity();
        private final long sinceMs;
        private int agreed;
        private int differed;
        private boolean another;

        Unsettled(long sinceMs) {
            this.sinceMs = sinceMs;
        }
    }

    OwnLinks(VehicleId id) {
        this.id = id;
    }

    /**
     * A message has come with the vehicle's id. Whether it is the vehicle's own.
     *
     * @param events receives that a link has been recognized, or that another vehicle has the id
     */
    boolean isOwn(MavlinkAddress link, Object payload, long nowMs, List<VehicleEvent> events) {
        if (own.isEmpty() || own.contains(link)) {
            own.add(link);
            identity.take(payload, nowMs);
            heardMs = nowMs;
            return true;
        }
        Unsettled now = unsettled.computeIfAbsent(link, further -> new Unsettled(nowMs));
        boolean isPosition = now.identity.take(payload, nowMs);
        if (isRecognized(now, isPosition, nowMs)) {
            unsettled.remove(link);
            own.add(link);
            events.add(new VehicleEvent.LinkJoined(id, link));
            return true;
        }
        boolean isAnother = identity.isAnother(now.identity) || now.differed >= OFTEN;
        if (isAnother && !now.another) {
            events.add(new VehicleEvent.OtherVehicle(id, link, own.iterator().next()));
        }
        now.another = isAnother;
        return false;
    }

    private boolean isRecognized(Unsettled one, boolean isPosition, long nowMs) {
        if (identity.isAnother(one.identity)) {
            return false;
        }
        boolean isSameNumber = identity.hasNumberOf(one.identity);
        if (isSameNumber && nowMs - heardMs > SILENT_MS) {
            return true; // it may have started again meanwhile
        }
        if (isPosition && identity.isComparable(one.identity)) {
            boolean agrees = identity.agrees(one.identity);
            one.agreed = agrees ? one.agreed + 1 : 0;
            one.differed = agrees ? 0 : one.differed + 1;
        }
        return one.agreed >= 1 && (isSameNumber || (one.agreed >= OFTEN && nowMs - one.sinceMs >= ANSWER_MS));
    }

    /** A link was replaced by another one at the same port, which counts as the same. */
    void moved(MavlinkAddress before, MavlinkAddress now) {
        unsettled.remove(before);
        if (own.remove(before)) {
            own.add(now);
        }
    }

    /** Whether a link is one of the vehicle's. */
    boolean has(MavlinkAddress link) {
        return own.contains(link);
    }

    /** The vehicle's links. */
    Set<MavlinkAddress> links() {
        return Collections.unmodifiableSet(own);
    }

    /** The number of its autopilot that it said last; empty where it has not said one. */
    Optional<String> number() {
        return identity.number();
    }

    /** Whether its autopilot has said its number. */
    boolean hasNumber() {
        return identity.hasNumber();
    }

    /** The links on which something speaks with its id that is not recognized. */
    List<MavlinkAddress> unsettled() {
        return List.copyOf(unsettled.keySet());
    }

    /** The links on which another vehicle has its id. */
    List<MavlinkAddress> others() {
        List<MavlinkAddress> others = new ArrayList<>();
        unsettled.forEach((link, one) -> {
            if (one.another) {
                others.add(link);
            }
        });
        return others;
    }
}
