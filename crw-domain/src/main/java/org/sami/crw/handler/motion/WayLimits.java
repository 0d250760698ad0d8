package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * The present limits on boats' ways for a mission.
 *
 * @param avoid no-go areas
 * @param within the area to stay in
 */
public record WayLimits(List<GeoArea> avoid, Optional<GeoArea> within) {
    public WayLimits {
        avoid = List.copyOf(avoid);
        Objects.requireNonNull(within, "within");
    }

    /** Those of an activation. */
    static WayLimits of(Activation activation, EngineView view) {
        return new WayLimits(PlanAreas.avoided(activation, view), PlanAreas.within(activation, view));
    }

    /** Those of a mission. */
    public static WayLimits of(long mission, EngineView view) {
        return new WayLimits(PlanAreas.avoided(mission, view), PlanAreas.within(mission, view));
    }

    /**
     * The water of a boat's way. A boat that is outside of the area to stay in, as a quay mostly is, or is sent there, is not kept in. Areas that are no
     * simple polygons keep nobody out: they are named where they are asked with, and by the fence's alarm.
     */
    public Optional<Water> water(Optional<GeoPoint> from, List<GeoPoint> points, CrossTrackError error) {
        GeoPoint origin = from.orElse(points.get(0));
        try {
            Water inside = Water.of(origin, List.of(), within);
            boolean stays =
                    inside.allows(List.of(origin)) && points.stream().allMatch(point -> inside.allows(List.of(point)));
            return Optional.of(
                    Water.of(origin, avoid, stays ? within : Optional.empty()).drivenWith(error));
        } catch (IllegalArgumentException crossed) {
            return Optional.empty();
        }
    }
}
