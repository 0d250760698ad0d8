package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.DoubleSupplier;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.Restrictions;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.operator.message.MessageSink;
import org.sami.crw.operator.message.OperatorMessage;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatPose;
import org.sami.crw.proxy.BoatStatus;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * Watches what boats cover of the areas that they explore, by the positions that they report, and tells the operator when the last share is driven, or
 * when the mission ends before that. For the fleet's thread; what it hears of the engine it brings there.
 */
public final class ExploredAreas implements BoatListener, HostListener {
    private static final double STEP_OF_SPACING = 1.0 / 25;
    private static final double LEAST_STEP_M = 0.5;
    private static final int MOST_POINTS = 20_000;

    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;
    private final Executor fleet;
    private final Map<String, Explored> areas = new LinkedHashMap<>(); // by mission and area

    /** An area whose exploration is under way. */
    private static final class Explored {
        private final Activation activation;
        private final HandlerContext context;
        private final AreaCoverage coverage;
        private final double spacingM;
        private final DoubleSupplier plannedM2; // that no path comes near
        private Map<String, GeoPath> shares;
        private final Map<String, List<GeoPoint>> tracks = new LinkedHashMap<>();
        private final List<List<GeoPoint>> assumed = new ArrayList<>();
        private final Set<String> done = new HashSet<>();
        private boolean isTold;

        Explored(
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
            this.shares = shares;
            List<List<GeoPoint>> planned =
                    shares.values().stream().map(GeoPath::points).toList();
            plannedM2 = () -> uncoveredM2.orElseGet(() -> coverage.left(planned).areaM2());
        }
    }

    public ExploredAreas(MessageSink messages, Computations computations, BoatErrors errors, Executor fleet) {
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
        this.fleet = fleet;
    }

    /**
     * Boats of a mission explore an area, from now on or again.
     *
     * @param name names mission and area
     * @param shares the paths of all boats that have one
     * @param uncoveredM2 what of the area they leave; empty where it was not computed with them
     */
    void explore(
            String name,
            Activation activation,
            HandlerContext context,
            GeoArea area,
            double spacingM,
            Map<String, GeoPath> shares,
            OptionalDouble uncoveredM2) {
        Explored one = areas.get(name);
        if (one == null) {
            AreaCoverage coverage = AreaCoverage.of(
                    area,
                    spacingM,
                    context.query(view -> PlanAreas.avoided(activation, view)),
                    Restrictions.within(activation));
            one = new Explored(activation, context, coverage, spacingM, shares, uncoveredM2);
            areas.put(name, one);
            assume(one);
        }
        one.shares = Map.copyOf(shares);
    }

    /** What was visited before this base began counts as driven as it was planned: nobody saw it. */
    private static void assume(Explored one) {
        one.shares.forEach((boat, path) -> {
            List<GeoPoint> points = path.points();
            int visited = PathProgress.visited(
                    one.context, one.activation.mission(), PathProgress.key(boat, path), points.size());
            if (visited > 1) {
                one.assumed.add(points.subList(0, visited));
            }
            if (visited == points.size()) {
                one.done.add(boat);
            }
        });
    }

    @Override
    public void onStatus(BoatStatus status) {
        for (Explored one : areas.values()) {
            if (!one.isTold && one.shares.containsKey(status.boatId())) {
                status.pose().map(BoatPose::position).ifPresent(at -> add(one, status.boatId(), at));
            }
        }
    }

    private static void add(Explored one, String boat, GeoPoint at) {
        List<GeoPoint> track = one.tracks.computeIfAbsent(boat, id -> new ArrayList<>());
        double stepM = Math.max(LEAST_STEP_M, STEP_OF_SPACING * one.spacingM);
        if (track.isEmpty() || one.coverage.distanceM(track.get(track.size() - 1), at) >= stepM) {
            track.add(at);
            if (track.size() > MOST_POINTS) {
                List<GeoPoint> thinned = one.coverage.thinned(track, MOST_POINTS / 2);
                track.clear();
                track.addAll(thinned);
            }
        }
    }

    @Override
    public void onCompleted(String boat, BoatCommand command) {
        for (Explored one : areas.values()) {
            GeoPath share = one.shares.get(boat);
            if (share != null
                    && command instanceof FollowPath path
                    && path.mission() == one.activation.mission()
                    && path.points().equals(share.points())) {
                one.done.add(boat);
                if (one.done.containsAll(one.shares.keySet())) {
                    tell(one, "");
                }
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended) {
                fleet.execute(() -> forget(ended.mission()));
            }
        }
    }

    private void forget(long mission) {
        areas.values().stream()
                .filter(one -> one.activation.mission() == mission && !one.tracks.isEmpty())
                .forEach(one -> tell(one, " until the mission ended"));
        areas.values().removeIf(one -> one.activation.mission() == mission);
    }

    private void tell(Explored one, String when) {
        if (one.isTold) {
            return;
        }
        one.isTold = true;
        List<List<GeoPoint>> tracks = new ArrayList<>(one.assumed);
        tracks.addAll(one.tracks.values());
        List<String> boats = List.copyOf(one.shares.keySet());
        double positionM = errors.of(boats).positionM();
        computations.aside(
                () -> words(one, tracks, when) + one.coverage.likelyMissed(positionM),
                words -> messages.tell(new OperatorMessage(
                        one.context.nowMillis(),
                        one.activation.mission(),
                        OperatorMessage.Source.DOMAIN,
                        Priority.MEDIUM,
                        words,
                        boats,
                        "")));
    }

    private static String words(Explored one, List<List<GeoPoint>> tracks, String when) {
        AreaCoverage.Left left = one.coverage.left(tracks);
        String explored = String.format(
                Locale.ROOT,
                "Explored %.2f %% of %.0f m² by the positions that boats reported%s (planned %.2f %%)",
                one.coverage.percent(left.areaM2()),
                one.coverage.areaM2(),
                when,
                one.coverage.percent(one.plannedM2.getAsDouble()));
        String where = left.inLargest()
                .filter(place -> left.areaM2() >= 1)
                .map(place -> String.format(
                        Locale.ROOT,
                        "; %.0f m² are left, most near %.5f,%.5f",
                        left.areaM2(),
                        place.latDeg(),
                        place.lonDeg()))
                .orElse("");
        String assumed = one.assumed.isEmpty() ? "" : "; what was driven before this base began counts as planned";
        return explored + where + assumed;
    }
}
