package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Notices that somebody else has replaced the mission that a vehicle holds: by the number of items that it reports once a second, by what it says, and by an
 * item that it has reached far from our waypoint. For the gateway's thread.
 *
 * <p>Source: ArduPilot says {@code Auto mission changed, restarted command} in AUTO where one of the next three items is
 * another, and often where any item was written.
 */
final class MissionWatch {
    private static final String CHANGED = "mission changed";
    /** More than a current and a wide turn carry a vehicle past a waypoint, in metres. */
    static final double BESIDE_M = 10;

    private static final long OLD_MS = 5_000; // a position that is older says nothing

    private final DoubleSupplier radiusM;
    private boolean isSeen; // the vehicle has reported the number of items that it was given

    /** A watch of a vehicle that counts a waypoint as reached within a radius, in metres. */
    MissionWatch(DoubleSupplier radiusM) {
        this.radiusM = radiusM;
    }

    /** It is given another mission: what it reports until it has that says nothing. */
    void forget() {
        isSeen = false;
    }

    /**
     * Whether it reports another number of items than it was given and reported before. Said once.
     *
     * @param items that it was given, home included, which ArduPilot does not count
     */
    boolean isReplaced(int items, VehicleSnapshot vehicle) {
        Optional<Integer> reported = vehicle.itemsHeld();
        if (reported.isEmpty()) { // an older firmware
            return false;
        }
        boolean isSame = reported.get() == items || reported.get() == items - 1;
        boolean isReplaced = isSeen && !isSame;
        isSeen = isSame;
        return isReplaced;
    }

    /** Whether a vehicle says by this that its mission is another, whoever has changed it. */
    static boolean isChange(StatusText text) {
        return text.text().toLowerCase(Locale.ROOT).contains(CHANGED);
    }

    /**
     * How far from our waypoint a vehicle is that says to have reached it, in metres, where that is farther than it can be along our mission; empty where it is not, or
     * where it has not said where it is.
     */
    Optional<Double> tooFarM(Waypoint ours, VehicleEvent.ItemReached reached) {
        Optional<VehiclePosition> at = reached.at().filter(place -> reached.heardMs() - place.heardMs() <= OLD_MS);
        if (at.isEmpty()) {
            return Optional.empty();
        }
        double awayM = new LocalFrame(ours.latDeg(), ours.lonDeg())
                .distanceM(at.get().latDeg(), at.get().lonDeg());
        double goneM = at.get().speedMps() * (reached.heardMs() - at.get().heardMs()) / 1000;
        return Optional.of(awayM).filter(metres -> metres > radiusM.getAsDouble() + BESIDE_M + goneM);
    }
}
