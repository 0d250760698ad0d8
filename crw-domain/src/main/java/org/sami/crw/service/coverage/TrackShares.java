package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.allocation.LeastSumAssignment;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Gives pieces of one track to boats. */
final class TrackShares {
    private TrackShares() {}

    /**
     * The shares of boats: pieces of equal length, the boats' ways to them least in sum, each driven from its nearer end.
     *
     * @param noWay gets the boats that cannot get to their piece, and why; the others divide the track among them
     */
    static Map<String, CoverageShare> of(
            CoverageProblem problem, List<Coordinate> tour, Water water, Map<String, String> noWay) {
        Map<String, CoverageShare> shares = new LinkedHashMap<>();
        List<List<Coordinate>> pieces = TrackPieces.of(tour, problem.boats().size());
        List<Optional<GeoPoint>> boats = List.copyOf(problem.boats().values());
        double[][] costs = new double[boats.size()][pieces.size()];
        for (int boat = 0; boat < boats.size(); boat++) {
            for (int piece = 0; piece < pieces.size(); piece++) {
                costs[boat][piece] = approachM(boats.get(boat), pieces.get(piece), water);
            }
        }
        int[] pieceOf = LeastSumAssignment.of(costs);
        int boat = 0;
        for (Map.Entry<String, Optional<GeoPoint>> entry : problem.boats().entrySet()) {
            List<Coordinate> piece = pieces.get(pieceOf[boat++]);
            List<GeoPoint> track = driven(entry.getValue(), piece, water);
            PathAnswer approach = approach(entry.getValue(), track.get(0), water);
            if (approach instanceof PathAnswer.NoWay none) {
                noWay.put(entry.getKey(), none.reason());
                return problem.boats().size() == 1 ? Map.of() : of(problem.without(entry.getKey()), tour, water, noWay);
            }
            List<GeoPoint> way = ((PathAnswer.Way) approach).points();
            shares.put(
                    entry.getKey(),
                    new CoverageShare(way.subList(0, way.size() - 1), track, TrackPieces.lengthM(piece)));
        }
        return shares;
    }

    private static double approachM(Optional<GeoPoint> boat, List<Coordinate> piece, Water water) {
        return boat.map(at -> Areas.coordinate(at, water.plane()))
                .map(at -> Math.min(at.distance(piece.get(0)), at.distance(piece.get(piece.size() - 1))))
                .orElse(0.0);
    }

    private static List<GeoPoint> driven(Optional<GeoPoint> boat, List<Coordinate> piece, Water water) {
        List<GeoPoint> track = new ArrayList<>();
        piece.forEach(place -> track.add(Areas.point(place, water.plane())));
        boat.map(at -> Areas.coordinate(at, water.plane())).ifPresent(at -> {
            if (at.distance(piece.get(piece.size() - 1)) < at.distance(piece.get(0))) {
                Collections.reverse(track);
            }
        });
        return track;
    }

    private static PathAnswer approach(Optional<GeoPoint> boat, GeoPoint to, Water water) {
        GeoPoint from = boat.orElse(to);
        return new ShortestPath().find(new PathProblem(from, to, water, 1));
    }
}
