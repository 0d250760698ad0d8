package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.crw.event.Numbers;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.Candidate;
import org.sami.crw.service.allocation.Division;
import org.sami.crw.service.allocation.SequentialSingleItemAuction;
import org.sami.crw.service.allocation.WorkItem;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.crw.service.coverage.Ranges;
import org.sami.crw.service.reach.Way;
import org.sami.crw.service.reach.WayCheck;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/** What requests would have boats do, and what that takes. Computes ways, divisions of areas and of places. */
final class WorkRemarks {
    /** Longer tracks are not divided: they are far beyond what a fleet drives, and would take long to compute. */
    static final double MOST_TRACK_M = 400_000;

    private static final int MOST_PLACES = 200;

    private final JudgedQuestion question;
    private final CrwServices services;
    private final List<JudgedBoat> boats;

    /**
     * The work of some boats.
     *
     * @param boats that would go, of which it is known where they are
     */
    WorkRemarks(JudgedQuestion question, CrwServices services, List<JudgedBoat> boats) {
        this.question = question;
        this.services = services;
        this.boats = boats;
    }

    /** The remarks on what a request with these values would have the boats do; none where it moves nobody, or too little is known. */
    List<Remark> of(String request, Map<String, Value> values) {
        if (boats.isEmpty()) {
            return List.of();
        }
        return switch (request) {
            case "ProxyExploreArea" -> explore(values);
            case "AllocationRequest", "DistributeLocationsRequest" -> visit(places(values.get("locations")));
            case "ProxyGotoLatLon", "AssembleLocationRequest" -> go(values.get("location"));
            case "ProxyExecutePath",
                    "ProxyExecutePathAndBlock",
                    "ProxyGotoPoint",
                    "ProxyGotoPointAndBlock",
                    "ProxyStationKeep",
                    "PathRequest" -> ways(List.copyOf(values.values()));
            default -> List.of();
        };
    }

    // ---- an area

    private List<Remark> explore(Map<String, Value> values) {
        if (!(values.get("area") instanceof GeoArea area)) {
            return List.of();
        }
        Value spacing = values.get("spacing");
        double spacingM = spacing instanceof RealValue || spacing instanceof IntegerValue ? Numbers.real(spacing) : 0;
        if (!(spacingM >= 0.1) || spacingM > 10_000) {
            return List.of();
        }
        double trackM = Areas.polygon(area, new LocalPlane(area.outline().get(0)), "The area")
                        .getArea()
                / spacingM;
        double lastsM = boats.stream().mapToDouble(JudgedBoat::sureM).sum();
        if (trackM > MOST_TRACK_M) {
            return List.of(Remark.doubt("The area takes about " + Amounts.length(trackM) + " of track in lanes "
                    + Amounts.length(spacingM) + " apart"
                    + (lastsM < trackM ? ", and all charges together last for " + Amounts.length(lastsM) : "")));
        }
        try {
            return explore(services.coverage().cover(problem(area, spacingM, values)), spacingM);
        } catch (IllegalArgumentException impossible) {
            return List.of(Remark.refusal(String.valueOf(impossible.getMessage())));
        }
    }

    private CoverageProblem problem(GeoArea area, double spacingM, Map<String, Value> values) {
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        Map<String, Double> metres = new LinkedHashMap<>();
        Map<String, GeoPoint> homes = new LinkedHashMap<>();
        Map<String, Double> speedsMps = new LinkedHashMap<>();
        Map<String, Double> radiiM = new LinkedHashMap<>();
        for (JudgedBoat boat : boats) {
            from.put(boat.name(), boat.from());
            boat.charge().ifPresent(charge -> metres.put(boat.name(), charge.sureM()));
            boat.home().ifPresent(home -> homes.put(boat.name(), home));
            speedsMps.put(boat.name(), boat.cruiseMps());
            radiiM.put(boat.name(), boat.turningRadiusM());
        }
        Optional<Boolean> keep =
                values.get("keepHome") instanceof BooleanValue flag ? Optional.of(flag.value()) : Optional.empty();
        boolean looksHome = keep.orElse(true) && !question.swaps();
        Ranges ranges =
                looksHome ? new Ranges(metres, homes, false, keep.orElse(false)) : Ranges.out(metres, question.swaps());
        Optional<GeoArea> within =
                values.get(JudgedRequest.WITHIN) instanceof GeoArea one ? Optional.of(one) : Optional.empty();
        List<GeoArea> avoid = new ArrayList<>(question.limits().avoid());
        area.holes().forEach(hole -> avoid.add(new GeoArea(hole, List.of())));
        CrossTrackError error = boats.stream()
                .map(JudgedBoat::error)
                .reduce(CrossTrackError::atLeast)
                .orElse(CrossTrackError.NONE);
        return new CoverageProblem(from, area, spacingM, avoid, within, error, ranges, speedsMps, radiiM);
    }

    private List<Remark> explore(Coverage coverage, double spacingM) {
        WorkCost cost = new WorkCost(question.swaps());
        List<Remark> remarks = new ArrayList<>();
        remarks.add(Remark.cost(
                String.format(Locale.ROOT, "%,.0f m² in lanes %s apart", coverage.areaM2(), Amounts.length(spacingM))));
        Map<String, JudgedBoat> named = WorkCost.byName(boats);
        coverage.shares().forEach((name, share) -> {
            JudgedBoat boat = Objects.requireNonNull(named.get(name), name);
            List<GeoPoint> way = share.path().points();
            if (boat.from().isPresent() && !way.isEmpty()) {
                cost.add(boat, share.approachM() + share.trackM(), way, water(boat, way));
                far(boat, way).ifPresent(remarks::add);
            }
        });
        remarks.addAll(cost.remarks());
        coverage.doubt().map(words -> Remark.doubt(words)).ifPresent(remarks::add);
        coverage.noWay().forEach((boat, why) -> remarks.add(Remark.doubt(boat + " does not get there: " + why)));
        coverage.unreached()
                .forEach(part -> remarks.add(Remark.doubt(String.format(
                        Locale.ROOT,
                        "No boat can reach %.0f m² near %.5f,%.5f",
                        part.areaM2(),
                        part.near().latDeg(),
                        part.near().lonDeg()))));
        return remarks;
    }

    // ---- places and paths

    private List<Remark> visit(List<GeoPoint> places) {
        if (places.isEmpty() || places.size() > MOST_PLACES) {
            return List.of();
        }
        List<Candidate> candidates = new ArrayList<>();
        List<WorkItem> work = new ArrayList<>();
        for (JudgedBoat boat : boats) {
            if (boat.from().isPresent()) {
                Candidate candidate = Candidate.at(boat.name(), boat.from().get())
                        .atSpeed(boat.cruiseMps())
                        .turningIn(boat.turningRadiusM());
                candidates.add(boat.charge()
                        .map(charge -> candidate.within(charge.sureM()))
                        .orElse(candidate));
            }
        }
        places.forEach(place -> work.add(WorkItem.visit("place " + (work.size() + 1), place)));
        if (candidates.isEmpty()) {
            return List.of();
        }
        Division division = new SequentialSingleItemAuction().divide(new AllocationProblem(candidates, work));
        Map<String, List<GeoPoint>> ways = new LinkedHashMap<>();
        division.paths()
                .forEach((boat, items) ->
                        ways.put(boat, items.stream().map(WorkItem::location).toList()));
        return drive(ways);
    }

    private List<Remark> go(@Nullable Value place) {
        if (!(place instanceof GeoPoint point)) {
            return List.of();
        }
        Map<String, List<GeoPoint>> ways = new LinkedHashMap<>();
        boats.forEach(boat -> ways.put(boat.name(), List.of(point)));
        return drive(ways);
    }

    /** The remarks on the paths that values have for boats, wherever they stand in them. */
    List<Remark> ways(List<Value> values) {
        Map<String, List<GeoPoint>> ways = new LinkedHashMap<>();
        values.forEach(value -> collect(value, ways));
        return drive(ways);
    }

    private static void collect(Value value, Map<String, List<GeoPoint>> ways) {
        if (value instanceof MapValue map) {
            map.entries().forEach((key, one) -> {
                if (key instanceof ProxyValue boat && one instanceof GeoPath path) {
                    ways.put(boat.proxy(), path.points());
                } else if (key instanceof ProxyValue boat && one instanceof GeoPoint point) {
                    ways.put(boat.proxy(), List.of(point));
                }
            });
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(part -> collect(part, ways));
        }
    }

    private List<Remark> drive(Map<String, List<GeoPoint>> ways) {
        WorkCost cost = new WorkCost(question.swaps());
        List<Remark> remarks = new ArrayList<>();
        Map<String, JudgedBoat> named = WorkCost.byName(boats);
        ways.forEach((name, points) -> {
            JudgedBoat boat = named.get(name);
            if (boat != null && !points.isEmpty()) {
                cost.add(boat, points, water(boat, points));
                far(boat, points).ifPresent(remarks::add);
            }
        });
        remarks.addAll(cost.remarks());
        return remarks;
    }

    private Optional<Water> water(JudgedBoat boat, List<GeoPoint> points) {
        return question.limits().water(boat.from(), points, boat.error());
    }

    /** A place that is nowhere near, or to which there is no way. */
    private Optional<Remark> far(JudgedBoat boat, List<GeoPoint> points) {
        Way way = new Way(
                boat.name(),
                boat.from(),
                boat.charge(),
                points,
                List.of(),
                points.size() <= MOST_PLACES ? water(boat, points) : Optional.empty());
        return WayCheck.doubt(way)
                .filter(doubt -> doubt.kind() == WayDoubt.Kind.PLACE)
                .map(doubt -> Remark.doubt(doubt.words()));
    }

    static List<GeoPoint> places(@Nullable Value value) {
        if (value instanceof GeoPoint point) {
            return List.of(point);
        } else if (value instanceof GeoPath path) {
            return path.points();
        }
        return value instanceof ListValue list
                ? list.items().stream()
                        .filter(GeoPoint.class::isInstance)
                        .map(GeoPoint.class::cast)
                        .toList()
                : List.of();
    }
}
