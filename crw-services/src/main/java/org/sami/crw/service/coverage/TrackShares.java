package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.allocation.LeastSumAssignment;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Gives pieces of one track to boats. */
final class TrackShares {
    /** A boat whose charge lasts for less of the track than that gets nothing of it. */
    private static final double LEAST_M = 1;

    private final CoverageProblem problem;
    private final List<Coordinate> tour;
    private final Water water;
    private final List<String> names;
    private final List<Optional<Coordinate>> places;
    private final List<Optional<Coordinate>> homes;

    /**
     * What boats get of a track.
     *
     * @param beyond what no charge lasts for
     */
    record Divided(Map<String, CoverageShare> shares, Optional<Coverage.BeyondCharge> beyond) {
        static final Divided NOTHING = new Divided(Map.of(), Optional.empty());
    }

    private TrackShares(CoverageProblem problem, List<Coordinate> tour, Water water) {
        this.problem = problem;
        this.tour = tour;
        this.water = water;
        names = List.copyOf(problem.boats().keySet());
        places = problem.boats().values().stream()
                .map(boat -> boat.map(at -> Areas.coordinate(at, water.plane())))
                .toList();
        homes = names.stream()
                .map(boat -> problem.ranges().home(boat).map(at -> Areas.coordinate(at, water.plane())))
                .toList();
    }

    /**
     * The shares of boats: pieces of equal length, assigned with the least sum of ways to them, each driven from its nearer end; of boats of different
     * speeds or turning circles pieces that take equally long. Where a charge does not last for such a piece, pieces are as long as charges allow: with the ways home where
     * charges last for the whole track with them, otherwise without.
     *
     * @param noWay receives the boats that cannot reach their piece, with reasons; the others divide the track among themselves
     */
    static Divided of(CoverageProblem problem, List<Coordinate> tour, Water water, Map<String, String> noWay) {
        TrackShares shares = new TrackShares(problem, tour, water);
        Map<String, CoverageShare> equal = new LinkedHashMap<>();
        int[] pieceOf = shares.nearestOf(TrackPieces.of(tour, problem.boats().size()), equal, noWay);
        Optional<String> without = problem.boats().keySet().stream()
                .filter(boat -> !equal.containsKey(boat))
                .findFirst();
        if (without.isPresent()) {
            return problem.boats().size() == 1
                    ? Divided.NOTHING
                    : of(problem.without(without.get()), tour, water, noWay);
        }
        boolean areEqual = problem.isOfEquals();
        if (areEqual && shares.allLast(equal, true)) {
            return new Divided(equal, Optional.empty());
        }
        Optional<Divided> withWaysHome = shares.withWaysHome(pieceOf, equal, noWay);
        if (withWaysHome.isPresent()) {
            return withWaysHome.get();
        }
        return areEqual && shares.allLast(equal, false)
                ? new Divided(equal, Optional.empty())
                : shares.asFarAsChargesLast(pieceOf, equal, noWay, false);
    }

    /** All boats get something, and come home from it; empty where charges do not last for that and the ways home need not be kept. */
    private Optional<Divided> withWaysHome(int[] pieceOf, Map<String, CoverageShare> equal, Map<String, String> noWay) {
        if (problem.ranges().homes().isEmpty()) {
            return Optional.empty();
        }
        Map<String, String> without = new LinkedHashMap<>();
        Divided divided = asFarAsChargesLast(pieceOf, equal, without, true);
        if (!problem.ranges().keepHome() && (divided.beyond().isPresent() || !without.isEmpty())) {
            return Optional.empty();
        }
        noWay.putAll(without);
        return Optional.of(divided);
    }

    /** The share of each boat that has a way to its piece, up to the first that has none. */
    private int[] nearestOf(
            List<List<Coordinate>> pieces, Map<String, CoverageShare> shares, Map<String, String> noWay) {
        double[][] costs = new double[names.size()][pieces.size()];
        for (int boat = 0; boat < names.size(); boat++) {
            for (int piece = 0; piece < pieces.size(); piece++) {
                costs[boat][piece] = approachM(boat, pieces.get(piece));
            }
        }
        int[] pieceOf = LeastSumAssignment.of(costs);
        for (int boat = 0; boat < names.size(); boat++) {
            if (!give(boat, pieces.get(pieceOf[boat]), false, shares, noWay)) {
                break;
            }
        }
        return pieceOf;
    }

    private boolean give(
            int boat,
            List<Coordinate> piece,
            boolean home,
            Map<String, CoverageShare> shares,
            Map<String, String> noWay) {
        List<GeoPoint> track = driven(boat, piece, home);
        PathAnswer approach = approach(boat, track.get(0));
        if (approach instanceof PathAnswer.NoWay none) {
            noWay.put(names.get(boat), none.reason());
            return false;
        }
        PathAnswer.Way way = (PathAnswer.Way) approach;
        shares.put(
                names.get(boat),
                new CoverageShare(
                        way.points().subList(0, way.points().size() - 1),
                        track,
                        TrackPieces.lengthM(piece),
                        way.lengthM()));
        return true;
    }

    private boolean allLast(Map<String, CoverageShare> shares, boolean home) {
        return shares.entrySet().stream()
                .allMatch(share -> share.getValue().drivenM() + (home ? homeM(share.getKey(), share.getValue()) : 0)
                        <= problem.ranges().of(share.getKey()));
    }

    /** The length of a boat's way home from the end of its share, straight where there is no way around; 0 where that does not count. */
    private double homeM(String boat, CoverageShare share) {
        Optional<GeoPoint> home = problem.ranges().home(boat);
        if (home.isEmpty()) {
            return 0;
        }
        GeoPoint end = share.track().get(share.track().size() - 1);
        PathAnswer way = new ShortestPath().find(new PathProblem(end, home.get(), water.leaving(home.get()), 1));
        return way instanceof PathAnswer.Way found ? found.lengthM() : Geodesy.distanceM(end, home.get());
    }

    /** A boat whose charge is too low for any of it is left out, and the others divide the track among them. */
    private Divided asFarAsChargesLast(
            int[] pieceOf, Map<String, CoverageShare> equal, Map<String, String> noWay, boolean home) {
        double[] rangeM = names.stream().mapToDouble(problem.ranges()::of).toArray();
        double[] detour = IntStream.range(0, names.size())
                .mapToDouble(boat -> detour(boat, share(equal, boat)))
                .toArray();
        double[] homeDetour = IntStream.range(0, names.size())
                .mapToDouble(boat -> home ? homeDetour(boat, share(equal, boat)) : 0)
                .toArray();
        TourDivision.Ways ways = (boat, end, other) -> Math.min(
                detour[boat] * straightM(boat, end) + homeDetour[boat] * straightHomeM(boat, other),
                detour[boat] * straightM(boat, other) + homeDetour[boat] * straightHomeM(boat, end));
        TourPlaces line = new TourPlaces(tour);
        double[] paces = names.stream().mapToDouble(problem::pace).toArray();
        double[] radiiM = names.stream().mapToDouble(problem::turningRadiusM).toArray();
        TourDivision.Cuts cuts = new TourDivision(
                        line, rangeM, paces, radiiM, problem.ranges().recharged(), ways)
                .from(inverse(pieceOf));
        Map<String, CoverageShare> given = new LinkedHashMap<>();
        for (int piece = 0; piece < names.size(); piece++) {
            int boat = cuts.boat(piece);
            if (cuts.lengthM(piece) < LEAST_M) {
                noWay.put(names.get(boat), nothing(names.get(boat), share(equal, boat), home));
            } else {
                give(boat, line.between(cuts.fromM(piece), cuts.fromM(piece + 1)), home, given, noWay);
            }
        }
        Map<String, CoverageShare> shares = new LinkedHashMap<>();
        names.stream().filter(given::containsKey).forEach(boat -> shares.put(boat, given.get(boat)));
        return new Divided(shares, beyond(cuts, line, home));
    }

    private static int[] inverse(int[] pieceOf) {
        int[] order = new int[pieceOf.length];
        for (int boat = 0; boat < pieceOf.length; boat++) {
            order[pieceOf[boat]] = boat;
        }
        return order;
    }

    /** By how much a boat's way to its piece is longer than the straight one: more or less the same to a piece near by. */
    private double detour(int boat, CoverageShare share) {
        double straightM = straightM(boat, Areas.coordinate(share.track().get(0), water.plane()));
        return straightM > LEAST_M ? Math.max(1, share.approachM() / straightM) : 1;
    }

    /** Likewise, for the way home from it. */
    private double homeDetour(int boat, CoverageShare share) {
        List<GeoPoint> track = share.track();
        double straightM = straightHomeM(boat, Areas.coordinate(track.get(track.size() - 1), water.plane()));
        return straightM > LEAST_M ? Math.max(1, homeM(names.get(boat), share) / straightM) : 1;
    }

    /** Why a boat gets nothing: it is slow, maybe in its turns, or its charge does not last for the way to where its piece would be. */
    private String nothing(String boat, CoverageShare piece, boolean home) {
        double wayM = piece.approachM() + (home ? homeM(boat, piece) : 0) + LEAST_M;
        boolean mayBeSlow = problem.pace(boat) < 1 || problem.turningRadiusM(boat) > 0;
        if (mayBeSlow && wayM <= problem.ranges().of(boat)) {
            return boat + " is so slow that the others explore its part sooner";
        }
        return String.format(
                Locale.ROOT,
                "%s has charge for %.0f m, and its way to the area%s is longer",
                boat,
                problem.ranges().of(boat),
                home ? " and home" : "");
    }

    private Optional<Coverage.BeyondCharge> beyond(TourDivision.Cuts cuts, TourPlaces line, boolean home) {
        double leftM = line.lengthM() - cuts.endM();
        if (leftM >= LEAST_M) {
            Coordinate middle = line.at(cuts.endM() + leftM / 2);
            return Optional.of(new Coverage.BeyondCharge(Areas.point(middle, water.plane()), leftM, false, home));
        }
        return cuts.beyondM() >= LEAST_M
                ? Optional.of(new Coverage.BeyondCharge(
                        Areas.point(line.at(line.lengthM() / 2), water.plane()), cuts.beyondM(), true, home))
                : Optional.empty();
    }

    private double straightM(int boat, Coordinate place) {
        return places.get(boat).map(place::distance).orElse(0.0);
    }

    private double straightHomeM(int boat, Coordinate place) {
        return homes.get(boat).map(place::distance).orElse(0.0);
    }

    private double approachM(int boat, List<Coordinate> piece) {
        return Math.min(straightM(boat, piece.get(0)), straightM(boat, piece.get(piece.size() - 1)));
    }

    /** From the nearer end, or from where it is shorter with the way home. */
    private List<GeoPoint> driven(int boat, List<Coordinate> piece, boolean home) {
        List<GeoPoint> track = new ArrayList<>();
        piece.forEach(place -> track.add(Areas.point(place, water.plane())));
        Coordinate first = piece.get(0);
        Coordinate last = piece.get(piece.size() - 1);
        double forwardM = straightM(boat, first) + (home ? straightHomeM(boat, last) : 0);
        double backwardM = straightM(boat, last) + (home ? straightHomeM(boat, first) : 0);
        if (backwardM < forwardM) {
            Collections.reverse(track);
        }
        return track;
    }

    private CoverageShare share(Map<String, CoverageShare> shares, int boat) {
        return Objects.requireNonNull(shares.get(names.get(boat)), names.get(boat));
    }

    private PathAnswer approach(int boat, GeoPoint to) {
        String name = names.get(boat);
        GeoPoint from = Objects.requireNonNull(problem.boats().get(name), name).orElse(to);
        return new ShortestPath().find(new PathProblem(from, to, water, 1));
    }
}
