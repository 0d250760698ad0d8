package org.sami.crw.judgement;

import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * A boat that an answer would send, in its present state. Immutable.
 *
 * @param from its position, if known
 * @param charge that of its battery, if known
 * @param home where it returns to, if known
 * @param error how far it may be off its path
 * @param cruiseMps its speed on paths that name none, in m/s
 * @param turningRadiusM the radius of its narrowest turn, in metres; 0 for one that turns on the spot
 * @param capabilities what it cannot do and what it measures, where it says so
 */
public record JudgedBoat(
        String name,
        Optional<GeoPoint> from,
        Optional<Charge> charge,
        Optional<GeoPoint> home,
        CrossTrackError error,
        double cruiseMps,
        double turningRadiusM,
        BoatCapabilities capabilities) {
    public JudgedBoat {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(charge, "charge");
        Objects.requireNonNull(home, "home");
        Objects.requireNonNull(error, "error");
        Objects.requireNonNull(capabilities, "capabilities");
    }

    /** How far its charge is sure to last, in metres; infinite where it is not known. */
    double sureM() {
        return charge.map(Charge::sureM).orElse(Double.POSITIVE_INFINITY);
    }
}
