package org.sami.crw.testing;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.Candidate;
import org.sami.crw.service.allocation.WorkItem;
import org.sami.spn.value.GeoPoint;

/**
 * A seeded problem in a square of 600 m.
 *
 * @param skills whether a third of the work needs some of three capabilities, of which each boat has some; the first has all
 * @param quay whether the boats lie side by side at a quay, else anywhere
 */
public record AllocationScene(int boats, int locations, boolean skills, boolean quay, long seed) {
    private static final LocalPlane PLANE = new LocalPlane(GeoPoint.of(45.4, 10.9));
    private static final double SIDE_M = 600;
    private static final int SKILLS = 3;
    private static final int SETS = 1 << SKILLS;

    /** The problem; equal scenes have equal ones. */
    public AllocationProblem problem() {
        Random random = new Random(seed * 1_000_003 + boats * 1009L + locations);
        List<GeoPoint> places = points(random, locations);
        List<GeoPoint> starts = quay ? alongQuay() : points(random, boats);
        int[] offers = new int[boats];
        for (int i = 0; skills && i < boats; i++) {
            offers[i] = i == 0 ? SETS - 1 : random.nextInt(SETS);
        }
        List<Candidate> candidates = new ArrayList<>();
        for (int i = 0; i < boats; i++) {
            candidates.add(new Candidate("boat-" + i, starts.get(i), names(offers[i]), List.of()));
        }
        List<WorkItem> work = new ArrayList<>();
        for (int i = 0; i < locations; i++) {
            int needs = skills && random.nextInt(3) == 0 ? random.nextInt(SETS) : 0;
            work.add(new WorkItem("location " + (i + 1), places.get(i), names(needs)));
        }
        return new AllocationProblem(candidates, work);
    }

    private static List<GeoPoint> points(Random random, int count) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            points.add(PLANE.point(random.nextDouble() * SIDE_M, random.nextDouble() * SIDE_M));
        }
        return points;
    }

    private List<GeoPoint> alongQuay() {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < boats; i++) {
            points.add(PLANE.point(SIDE_M / 2 + 5 * i, -20));
        }
        return points;
    }

    private static Set<String> names(int set) {
        Set<String> names = new TreeSet<>();
        for (int i = 0; i < SKILLS; i++) {
            if ((set >> i & 1) == 1) {
                names.add("skill " + i);
            }
        }
        return names;
    }
}
