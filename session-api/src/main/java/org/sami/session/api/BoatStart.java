package org.sami.session.api;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** Where a boat is, and how far it may be off its ways: what a way that it has not been sent yet depends on. Immutable. */
public record BoatStart(GeoPoint at, CrossTrackError error) {
    /** The way along a path from a boat's position, within these limits. Computes ways around no-go areas. */
    public List<GeoPoint> way(GeoPath path, WayLimits limits) {
        List<GeoPoint> way = new ArrayList<>(List.of(at));
        if (!path.points().isEmpty()) {
            FollowPath along = FollowPath.of("preview", Ids.NONE, Ids.NONE, path.points(), Priority.MEDIUM);
            Optional<Water> water = limits.water(Optional.of(at), path.points(), error);
            way.addAll(water.map(along::in).orElse(along).way(at));
        }
        return way;
    }
}
