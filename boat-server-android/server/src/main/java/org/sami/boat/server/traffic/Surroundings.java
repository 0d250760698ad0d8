package org.sami.boat.server.traffic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Traffic;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.VesselInSight;

/**
 * The boats and no-go edges near this boat, as its base has sent them. Old reports are dropped. For the thread that ticks the server.
 */
public final class Surroundings {
    /** Age in ms at which a report is dropped: a link that is silent for that long is lost. */
    public static final long OLDEST_MS = LinkDefaults.LINK_LOST_AFTER_MS;

    private static final double REACH_M = 2000; // of the plane

    private static final double GIVEN_WAY_WITHIN_M = 25;

    private final String ownId;
    private final List<OtherBoat> others = new ArrayList<>(); // in the order of their first reports
    private final Map<String, OtherBoat> byId = new HashMap<>(); // the same ones
    private long oldestSeenMs = Long.MAX_VALUE; // or earlier: no report is too old before it is
    private LocalFrame plane = new LocalFrame(0, 0);
    private NoGoBorder border = NoGoBorder.NONE;

    /** No boat is known yet. */
    public Surroundings(String ownId) {
        this.ownId = Objects.requireNonNull(ownId, "ownId");
    }

    /** Takes a message of the base. For each boat its newest row counts, for no-go edges the newest message. */
    public void update(Traffic traffic, long nowMs) {
        traffic.boats().forEach(row -> see(row, 0, nowMs));
        if (!others.isEmpty()) { // otherwise the plane may belong to another water
            border = traffic.noGo().map(edges -> NoGoBorder.of(edges, plane)).orElse(NoGoBorder.NONE);
        }
    }

    /** Takes what a lookout on board sees; the no-go edges stay. */
    public void see(List<VesselInSight> vessels, long nowMs) {
        vessels.forEach(vessel -> see(vessel.middle(), vessel.radiusM(), nowMs));
    }

    private void see(NearbyBoat row, double radiusM, long nowMs) {
        if (!row.boatId().equals(ownId) && row.ageMs() < OLDEST_MS && Math.abs(row.latDeg()) <= 85) {
            double eastM = plane.eastM(row.latDeg(), row.lonDeg());
            double northM = plane.northM(row.latDeg(), row.lonDeg());
            if (PlaneMath.length(eastM, northM) >= REACH_M) {
                others.clear(); // they are on another water
                byId.clear();
                border = NoGoBorder.NONE;
                plane = new LocalFrame(row.latDeg(), row.lonDeg());
                eastM = 0;
                northM = 0;
            }
            take(row, radiusM, eastM, northM, nowMs);
        }
    }

    /** Drops the no-go edges: the boat has another command or has moved too far. */
    public void forgetBorder() {
        border = NoGoBorder.NONE;
    }

    private void take(NearbyBoat row, double radiusM, double eastM, double northM, long nowMs) {
        OtherBoat other = known(row.boatId());
        long seenMs = nowMs - row.ageMs();
        if (seenMs >= other.seenMs()) {
            other.update(row, radiusM, eastM, northM, plane, seenMs);
        }
        oldestSeenMs = Math.min(oldestSeenMs, seenMs);
    }

    private OtherBoat known(String boatId) {
        OtherBoat known = byId.get(boatId);
        if (known != null) {
            return known;
        }
        OtherBoat other = new OtherBoat(boatId);
        others.add(other);
        byId.put(boatId, other);
        return other;
    }

    /** Drops old reports. */
    public void tick(long nowMs) {
        if (others.isEmpty() || nowMs - oldestSeenMs <= OLDEST_MS) {
            return;
        }
        oldestSeenMs = Long.MAX_VALUE;
        for (int i = others.size() - 1; i >= 0; i--) {
            OtherBoat other = others.get(i);
            if (nowMs - other.seenMs() > OLDEST_MS) {
                others.remove(i);
                byId.remove(other.boatId());
            } else {
                oldestSeenMs = Math.min(oldestSeenMs, other.seenMs());
            }
        }
    }

    /** Whether no boat is known. */
    public boolean isEmpty() {
        return others.isEmpty();
    }

    /** Whether there is a recent report of this boat. */
    boolean knows(String boatId) {
        return byId.containsKey(boatId);
    }

    /** Whether a boat is closer to a position than {@code metres}. */
    public boolean isNear(double latDeg, double lonDeg, double metres, long nowMs) {
        double eastM = plane.eastM(latDeg, lonDeg);
        double northM = plane.northM(latDeg, lonDeg);
        for (OtherBoat other : others) {
            if (PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < metres) {
                return true;
            }
        }
        return false;
    }

    /** The name of the boat nearest to a position; empty where no boat is known. */
    public Optional<String> nearest(double latDeg, double lonDeg, long nowMs) {
        double eastM = plane.eastM(latDeg, lonDeg);
        double northM = plane.northM(latDeg, lonDeg);
        return others.stream()
                .min(Comparator.comparingDouble(
                        other -> PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM)))
                .map(OtherBoat::boatId);
    }

    /** The name of the boat nearest to a position of those that have the right of way over this one; empty where none is near. */
    public Optional<String> nearestWithRightOfWay(double latDeg, double lonDeg, long nowMs) {
        double eastM = plane.eastM(latDeg, lonDeg);
        double northM = plane.northM(latDeg, lonDeg);
        double nearestM = GIVEN_WAY_WITHIN_M;
        Optional<String> nearest = Optional.empty();
        for (OtherBoat other : others) {
            boolean isFirst = !other.isUnderWay() || other.boatId().compareTo(ownId) < 0;
            double awayM = PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM);
            if (isFirst && awayM < nearestM) {
                nearestM = awayM;
                nearest = Optional.of(other.boatId());
            }
        }
        return nearest;
    }

    /** Whether no-go edges are known near this boat. */
    public boolean hasEdges() {
        return !border.isEmpty();
    }

    /** The no-go edges near this boat. */
    NoGoBorder border() {
        return border;
    }

    String ownId() {
        return ownId;
    }

    List<OtherBoat> others() {
        return others;
    }

    /** The plane in whose metres the others are given. */
    LocalFrame plane() {
        return plane;
    }
}
