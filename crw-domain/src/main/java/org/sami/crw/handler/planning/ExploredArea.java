package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** An area under exploration: the shares of its boats, their reported positions, and the finished shares. For the fleet's thread. */
final class ExploredArea {
    private static final double STEP_OF_SPACING = 1.0 / 25;
    private static final double LEAST_STEP_M = 0.5;
    private static final int MOST_POINTS = 20_000;

    private final Activation activation;
    private final HandlerContext context;
    private final AreaCoverage coverage;
    private final double spacingM;
    private final DoubleSupplier plannedM2; // that no path comes near
    private Map<String, GeoPath> shares;
    private final Map<String, List<GeoPoint>> tracks = new LinkedHashMap<>();
    private final List<List<GeoPoint>> assumed = new ArrayList<>();
    private final Set<String> done = new HashSet<>();
    private boolean isReported;

    /**
     * An area that boats begin to explore, or go on with.
     *
     * @param activation that asks for it first
     * @param shares the paths of all boats that have one
     * @param uncoveredM2 what of the area they leave; empty where it was not computed with them
     */
    ExploredArea(
            Activation activation,
            HandlerContext context,
            AreaCoverage coverage,
            double spacingM,
            Map<String, GeoPath> shares,
            OptionalDouble uncoveredM2) {
        this.activation = activation;
        this.context = context;
        this.coverage = coverage;
        this.spacingM = spacingM;
        this.shares = Map.copyOf(shares);
        List<List<GeoPoint>> planned =
                shares.values().stream().map(GeoPath::points).toList();
        plannedM2 = () -> uncoveredM2.orElseGet(() -> coverage.left(planned).areaM2());
        shares.forEach(this::assume);
    }

    /** Counts points visited before this base started as driven as planned: no positions are known from that time. */
    private void assume(String boat, GeoPath path) {
        List<GeoPoint> points = path.points();
        int visited = PathProgress.visited(context, mission(), PathProgress.key(boat, path), points.size());
        if (visited > 1) {
            assumed.add(points.subList(0, visited));
        }
        if (visited == points.size()) {
            done.add(boat);
        }
    }

    long mission() {
        return activation.mission();
    }

    long nowMillis() {
        return context.nowMillis();
    }

    /** The boats that have a share now. */
    List<String> boats() {
        return List.copyOf(shares.keySet());
    }

    /** Whether a boat has reported a position in it. */
    boolean hasTracks() {
        return !tracks.isEmpty();
    }

    /** The area is divided among its boats again. */
    void divide(Map<String, GeoPath> newShares) {
        shares = Map.copyOf(newShares);
    }

    /** Takes where a boat reports to be, if it has a share and no message has given the result yet. */
    void add(String boat, GeoPoint at) {
        if (isReported || !shares.containsKey(boat)) {
            return;
        }
        List<GeoPoint> track = tracks.computeIfAbsent(boat, id -> new ArrayList<>());
        double stepM = Math.max(LEAST_STEP_M, STEP_OF_SPACING * spacingM);
        if (track.isEmpty() || coverage.distanceM(track.get(track.size() - 1), at) >= stepM) {
            track.add(at);
            if (track.size() > MOST_POINTS) {
                List<GeoPoint> thinned = coverage.thinned(track, MOST_POINTS / 2);
                track.clear();
                track.addAll(thinned);
            }
        }
    }

    /** Takes that a boat has driven a path. Gives whether that was a share of this area, and the last one. */
    boolean complete(String boat, FollowPath path) {
        GeoPath share = shares.get(boat);
        if (share == null || path.mission() != mission() || !path.points().equals(share.points())) {
            return false;
        }
        done.add(boat);
        return done.containsAll(shares.keySet());
    }

    /**
     * Ends the measurement. Returns the message for the operator; empty where it was given before.
     *
     * @param when words on the time of the end; empty text where all shares are driven
     * @param positionM stated standard deviation of the boats' positions, in metres
     * @return computes the words, which takes a while; on any thread
     */
    Optional<Supplier<String>> end(String when, double positionM) {
        if (isReported) {
            return Optional.empty();
        }
        isReported = true;
        List<List<GeoPoint>> driven = new ArrayList<>(assumed);
        driven.addAll(tracks.values());
        return Optional.of(() -> words(driven, when) + coverage.likelyMissed(positionM));
    }

    private String words(List<List<GeoPoint>> driven, String when) {
        AreaCoverage.Left left = coverage.left(driven);
        String explored = String.format(
                Locale.ROOT,
                "Explored %.2f %% of %.0f m² by the positions that boats reported%s (planned %.2f %%)",
                coverage.percent(left.areaM2()),
                coverage.areaM2(),
                when,
                coverage.percent(plannedM2.getAsDouble()));
        String where = left.inLargest()
                .filter(place -> left.areaM2() >= 1)
                .map(place -> String.format(
                        Locale.ROOT,
                        "; %.0f m² are left, most near %.5f,%.5f",
                        left.areaM2(),
                        place.latDeg(),
                        place.lonDeg()))
                .orElse("");
        String unseen = assumed.isEmpty() ? "" : "; what was driven before this base began counts as planned";
        return explored + where + unseen;
    }
}
