package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.report.ClosestApproach;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapPath;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.RunMap;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/**
 * Records what the map of the run shows: areas and points in the plan's output events, the project's no-go areas, and where boats were commanded to
 * gather. Lists of places for each boat are left out: services computed them from others.
 */
final class PlanMap implements ReportFold {
    /** A map with more points or areas would be unreadable. */
    private static final int MOST = 2000;

    private static final int MOST_EXPLORATIONS = 100;

    private static final String EXPLORE = "ProxyExploreArea";
    private static final String ASSEMBLED = "AssembleLocationResponse";
    private static final String AVOID = "avoid";
    private static final String WITHIN = "within";
    private static final String AREA = "area";
    private static final String SPACING = "spacing";

    private final LocalFrame plane;
    private final Set<MapArea> areas = new LinkedHashSet<>();
    private final Map<GeoPoint, MapSpot> assembly = new LinkedHashMap<>();
    private final Map<GeoPoint, MapSpot> points = new LinkedHashMap<>();
    private final Map<GeoArea, ExplorationRequest> explorations = new LinkedHashMap<>();
    private final List<MapPath> paths = new ArrayList<>();

    /**
     * A listener.
     *
     * @param plane around the area's centre
     */
    PlanMap(LocalFrame plane) {
        this.plane = plane;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.Received received
                && received.occurrence().type().equals(ASSEMBLED)) {
            received.occurrence().values().values().forEach(this::addAssembly);
        }
        explorations.values().forEach(one -> one.hear(input));
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated) {
                add(activated.activation(), atMillis, view);
            }
        }
    }

    private void add(Activation activation, long atMillis, EngineView view) {
        Optional.ofNullable(view.globals().get(OperatingArea.NO_GO)).ifPresent(noGo -> add(MapArea.Kind.AVOIDED, noGo));
        boolean explores = activation.type().equals(EXPLORE);
        activation.values().values().forEach(value -> addPaths(activation.mission(), value, atMillis));
        activation.values().forEach((field, value) -> add(kind(field, explores), value));
        if (explores
                && activation.values().get(AREA) instanceof GeoArea area
                && activation.values().get(SPACING) instanceof RealValue spacing
                && !explorations.containsKey(area)
                && explorations.size() < MOST_EXPLORATIONS) {
            explorationOf(activation, area, spacing.value(), atMillis, view)
                    .ifPresent(one -> explorations.put(area, one));
        }
    }

    /** Empty for areas that are no simple polygons, which cannot be explored: the plan gets the reason. */
    private static Optional<ExplorationRequest> explorationOf(
            Activation activation, GeoArea area, double spacingM, long atMillis, EngineView view) {
        Optional<GeoArea> within =
                activation.value(WITHIN).filter(GeoArea.class::isInstance).map(GeoArea.class::cast);
        try {
            return Optional.of(
                    new ExplorationRequest(atMillis, spacingM, area, PlanAreas.avoided(activation, view), within));
        } catch (IllegalArgumentException crossed) {
            return Optional.empty();
        }
    }

    private static MapArea.Kind kind(String field, boolean explores) {
        return switch (field) {
            case AVOID -> MapArea.Kind.AVOIDED;
            case WITHIN -> MapArea.Kind.LIMIT;
            default -> explores && field.equals(AREA) ? MapArea.Kind.EXPLORED : MapArea.Kind.OTHER;
        };
    }

    private void add(MapArea.Kind kind, Value value) {
        if (value instanceof GeoArea area && areas.size() < MOST) {
            areas.add(area(kind, area));
        } else if (value instanceof GeoPoint point) {
            if (!assembly.containsKey(point) && points.size() < MOST) {
                points.putIfAbsent(point, new MapSpot(MapSpot.Kind.PLAN, "", point(point)));
            }
        } else if (value instanceof GeoPath path) {
            path.points().forEach(point -> add(kind, point));
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> add(kind, item));
        } else if (value instanceof MapValue map) {
            map.entries().values().stream().filter(GeoPoint.class::isInstance).forEach(point -> add(kind, point));
        }
    }

    private void addPaths(long mission, Value value, long atMillis) {
        if (value instanceof MapValue map) {
            map.entries().forEach((boat, path) -> {
                if (boat instanceof ProxyValue proxy && path instanceof GeoPath given && paths.size() < MOST) {
                    paths.add(new MapPath(proxy.proxy(), mission, atMillis, points(given.points())));
                }
            });
        }
    }

    private void addAssembly(Value value) {
        if (value instanceof MapValue map) {
            map.entries().forEach((boat, place) -> {
                if (place instanceof GeoPoint point && assembly.size() < MOST) {
                    String whose = boat instanceof ProxyValue proxy ? proxy.proxy() : "";
                    assembly.put(point, new MapSpot(MapSpot.Kind.ASSEMBLY, whose, point(point)));
                }
            });
        }
    }

    private MapArea area(MapArea.Kind kind, GeoArea area) {
        return new MapArea(
                kind,
                points(area.outline()),
                area.holes().stream().map(this::points).toList());
    }

    private List<MapPoint> points(List<GeoPoint> points) {
        return points.stream().map(this::point).toList();
    }

    private MapPoint point(GeoPoint at) {
        return new MapPoint(
                at.latDeg(),
                at.lonDeg(),
                plane.eastM(at.latDeg(), at.lonDeg()),
                plane.northM(at.latDeg(), at.lonDeg()));
    }

    /** Uses tracks, locations and the announced depth, and so comes after their folds. */
    @Override
    public void addTo(ReportDraft report) {
        report.map(map(report.tracks(), report.locations(), report.announcedM()));
    }

    /** Whether boats were to explore areas. */
    boolean hasExplorations() {
        return !explorations.isEmpty();
    }

    /**
     * The map at the end of a run.
     *
     * @param locations are shown as such, and not as points of the plan
     */
    private RunMap map(KnownTracks tracks, List<LocationResult> locations, OptionalDouble announcedM) {
        // takes long for large fleets; uncovered areas are computed meanwhile
        CompletableFuture<ClosestApproach> closest =
                CompletableFuture.supplyAsync(() -> ClosestApproach.of(tracks.best()));
        List<MapSpot> spots = new ArrayList<>(assembly.values());
        points.values().stream()
                .filter(spot -> locations.stream()
                        .noneMatch(l -> l.latDeg() == spot.at().latDeg()
                                && l.lonDeg() == spot.at().lonDeg()))
                .forEach(spots::add);
        return new RunMap(
                List.copyOf(areas),
                spots,
                explorations.values().stream()
                        .map(asked -> asked.result(tracks, left -> area(MapArea.Kind.UNCOVERED, left)))
                        .toList(),
                closest.join(),
                paths,
                announcedM);
    }
}
