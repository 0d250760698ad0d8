package org.sami.crw.judgement;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * A boat that an answer would send, in its present state. Immutable.
 *
 * @param from its position, if known
 * @param batteryPercent its charge in percent of full, if known
 * @param home where it returns to, if known
 * @param error how far it may be off its path
 * @param cruiseMps its speed on paths that name none, in m/s
 */
public record JudgedBoat(
        String name,
        Optional<GeoPoint> from,
        OptionalDouble batteryPercent,
        Optional<GeoPoint> home,
        CrossTrackError error,
        double cruiseMps) {
    public JudgedBoat {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(batteryPercent, "batteryPercent");
        Objects.requireNonNull(home, "home");
        Objects.requireNonNull(error, "error");
    }
}
