package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Notices that somebody else than the base arms a vehicle, and that it moves then. For the gateway's thread. */
final class ForeignStart {
    private static final double MOVES_MPS = 0.3; // slower it may as well drift

    private final String name;
    private boolean wasArmed;
    private Optional<String> by = Optional.empty(); // who armed it, while it has not moved since

    ForeignStart(String name, boolean armed) {
        this.name = name;
        wasArmed = armed;
    }

    /** Who armed it is known better now than it was said before. */
    void known(String before, String who) {
        by = by.map(named -> named.equals(before) ? who : named);
    }

    /**
     * This is how the vehicle reports itself. What the operator must know of it now: that it was armed by others, then, once, that it moves.
     *
     * @param isTheirs whether somebody else than the base has the vehicle
     * @param isStopped whether a fleet stop is latched on it
     * @param who says who has it, in words; asked only where somebody has armed it
     */
    Optional<String> seen(VehicleSnapshot now, boolean isTheirs, boolean isStopped, Supplier<String> who) {
        boolean isStart = now.armed() && !wasArmed && (isTheirs || isStopped);
        wasArmed = now.armed();
        if (isStart) {
            by = Optional.of(who.get());
            return Optional.of(
                    name + " is armed by " + by.get() + (isStopped ? " though it was stopped" : "") + ": it may move");
        }
        double mps = now.position().map(VehiclePosition::speedMps).orElse(0.0);
        if (!now.armed()) {
            by = Optional.empty();
        } else if (by.isPresent() && mps > MOVES_MPS) {
            String words = String.format(Locale.ROOT, "%s moves at %.1f m/s, armed by %s", name, mps, by.get());
            by = Optional.empty();
            return Optional.of(words);
        }
        return Optional.empty();
    }
}
