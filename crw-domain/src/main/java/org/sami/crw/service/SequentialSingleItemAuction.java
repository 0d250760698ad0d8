package org.sami.crw.service;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.event.Allocation;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * Sequential single-item auction with nearest-neighbour insertion (thesis 7.0.3). Locations are auctioned in the order in
 * which they are given. A boat bids the length of its whole path if the location were added to those it has won: the
 * nearest-neighbour path from its position. The lowest bid wins; of equal bids, that of the boat named first.
 *
 * <p>As a bid is the length of the whole path and not what the location adds to it, long paths lose and the work spreads.
 *
 * <p>Cost: L locations and B boats with k locations each take O(L B k²) steps at most; a bid looks only at the part of
 * the path that the location changes, and stops where it has lost.
 */
public final class SequentialSingleItemAuction implements AllocationAlgorithm {
    @Override
    public String name() {
        return "Sequential single-item auction";
    }

    @Override
    public Allocation allocate(AllocationProblem problem) {
        if (problem.boats().isEmpty()) {
            return new Allocation(Map.of(), 0, 0, name());
        }
        List<Bidder> bidders = bidders(problem);
        for (int location = 0; location < problem.locations().size(); location++) {
            auction(location, bidders);
        }
        return result(problem, bidders);
    }

    private static List<Bidder> bidders(AllocationProblem problem) {
        LocalPlane plane = new LocalPlane(problem.boats().values().iterator().next());
        double[] x = problem.locations().stream().mapToDouble(plane::x).toArray();
        double[] y = problem.locations().stream().mapToDouble(plane::y).toArray();
        List<Bidder> bidders = new ArrayList<>();
        problem.boats()
                .forEach((boat, at) ->
                        bidders.add(new Bidder(boat, new NearestNeighbourPath(plane.x(at), plane.y(at), x, y))));
        return bidders;
    }

    private static void auction(int location, List<Bidder> bidders) {
        double best = Double.POSITIVE_INFINITY;
        Bidder winner = bidders.get(0);
        for (Bidder bidder : bidders) {
            double bid = bidder.path().lengthWith(location, best);
            if (bid < best) {
                best = bid;
                winner = bidder;
            }
        }
        winner.path().add(location);
    }

    private Allocation result(AllocationProblem problem, List<Bidder> bidders) {
        Map<String, GeoPath> paths = new LinkedHashMap<>();
        double total = 0;
        double longest = 0;
        for (Bidder bidder : bidders) {
            List<GeoPoint> points = bidder.path().locations().stream()
                    .map(problem.locations()::get)
                    .toList();
            double length = Geodesy.lengthM(problem.boats().get(bidder.boat()), points);
            total += length;
            longest = Math.max(longest, length);
            paths.put(bidder.boat(), new GeoPath(points));
        }
        return new Allocation(paths, total, longest, name());
    }

    private record Bidder(String boat, NearestNeighbourPath path) {}
}
