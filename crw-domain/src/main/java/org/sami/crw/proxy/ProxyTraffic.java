package org.sami.crw.proxy;

import java.util.Optional;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.link.Traffic;
import org.sami.crw.proxy.execution.CommandDriver;
import org.sami.crw.proxy.execution.CommandRun;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.spn.value.GeoPoint;

/**
 * A boat in traffic, as its proxy knows it: its last position, its destination and no-go edges, and the messages about nearby boats that it receives.
 * For the proxy's thread.
 */
final class ProxyTraffic {
    private static final long EDGES_PERIOD_MS = 1000;

    private final BoatCondition condition;
    private final CommandDriver driver;
    private final ProxyLink link;
    private long edgesSentMs = Long.MIN_VALUE / 2; // for the sake of a vessel

    ProxyTraffic(BoatCondition condition, CommandDriver driver, ProxyLink link) {
        this.condition = condition;
        this.driver = driver;
        this.link = link;
    }

    /** Where the boat was seen last, and when; empty as long as it has not said where it is. */
    Optional<Sighting> sighting() {
        return condition.sighting;
    }

    /** The point to which the boat drives now. */
    Optional<GeoPoint> target() {
        return driver.isDriving() ? driver.run().flatMap(CommandRun::target) : Optional.empty();
    }

    /** The edges of what the boat is not to enter, near where it was seen last. */
    Optional<NoGoEdges> noGoEdges() {
        return driver.noGoEdges()
                .flatMap(edges -> condition.sighting.flatMap(at -> edges.near(GeoPoint.of(at.latDeg(), at.lonDeg()))));
    }

    /** Whether the boat sees a vessel that is not of the base, and has not received no-go edges for a second. */
    boolean isDueToEdges(long nowMs) {
        boolean isDue =
                nowMs - condition.vesselSeenMs <= TrafficRelay.MAX_AGE_MS && nowMs - edgesSentMs >= EDGES_PERIOD_MS;
        if (isDue) {
            edgesSentMs = nowMs;
        }
        return isDue;
    }

    /** Whether the boat wishes to know of others. */
    boolean takesTraffic() {
        return link.takesTraffic();
    }

    /** Tells the boat which others are near it. */
    void tell(Traffic others) {
        link.send(others, condition.nowMs);
    }
}
