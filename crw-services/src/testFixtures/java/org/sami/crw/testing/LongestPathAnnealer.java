package org.sami.crw.testing;

import java.util.Arrays;
import java.util.Random;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.allocation.AllocationProblem;

/**
 * Divides work so that the longest path is short, by simulated annealing as simple as can be: moves a part of a path, exchanges the rests of
 * two, turns a part round, and measures both paths again. What it finds in seconds is what a good division can be compared with. It shares no code with
 * what it judges. Boats that have begun work, and charges, are not for it.
 */
public final class LongestPathAnnealer {
    private static final double HOT_M = 60;
    private static final double COLD_M = 0.3;
    private static final int MOVES_PER_LOOK = 500;
    private static final int LONGEST_PART = 3;

    private final double[][] legM; // from work, then from boats, to work
    private final boolean[][] canDo;
    private final int works;
    private final Random random;
    private int[][] paths;
    private double[] lengthM;

    private LongestPathAnnealer(AllocationProblem problem, long seed) {
        works = problem.work().size();
        int boats = problem.boats().size();
        random = new Random(seed);
        legM = new double[works + boats][works];
        canDo = new boolean[boats][works];
        paths = new int[boats][0];
        lengthM = new double[boats];
        for (int to = 0; to < works; to++) {
            for (int from = 0; from < works; from++) {
                legM[from][to] = Geodesy.distanceM(
                        problem.work().get(from).location(),
                        problem.work().get(to).location());
            }
            for (int boat = 0; boat < boats; boat++) {
                legM[works + boat][to] = Geodesy.distanceM(
                        problem.boats().get(boat).at(), problem.work().get(to).location());
                canDo[boat][to] = problem.boats().get(boat).canDo(problem.work().get(to));
            }
        }
        for (int work = 0; work < works; work++) {
            int boat = random.nextInt(boats);
            while (!canDo[boat][work]) {
                boat = random.nextInt(boats);
            }
            set(boat, with(paths[boat], paths[boat].length, new int[] {work}));
        }
    }

    /** The longest path that it found in such a time, in metres, at least two rounds of it; not the same each time. */
    public static double longestM(AllocationProblem problem, double seconds, long seed) {
        double least = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 2; round++) {
            least = Math.min(least, new LongestPathAnnealer(problem, seed + round).anneal(seconds / 2));
        }
        return least;
    }

    private double anneal(double seconds) {
        long begin = System.nanoTime();
        double least = longestM();
        double part = 0;
        while (part < 1) {
            double heatM = HOT_M * Math.pow(COLD_M / HOT_M, part);
            for (int i = 0; i < MOVES_PER_LOOK; i++) {
                move(heatM);
                least = Math.min(least, longestM());
            }
            part = (System.nanoTime() - begin) / 1e9 / seconds;
        }
        return least;
    }

    private void move(double heatM) {
        int a = random.nextInt(paths.length);
        int b = random.nextInt(paths.length);
        if (paths[a].length == 0) {
            return;
        }
        if (a == b) {
            tryPaths(a, random.nextBoolean() ? turned(paths[a]) : movedWithin(paths[a]), b, paths[b], heatM);
        } else if (random.nextInt(3) > 0) {
            int from = random.nextInt(paths[a].length);
            int to = Math.min(paths[a].length, from + 1 + random.nextInt(LONGEST_PART));
            int[] part = maybeTurned(Arrays.copyOfRange(paths[a], from, to));
            tryPaths(a, without(paths[a], from, to), b, with(paths[b], place(paths[b]), part), heatM);
        } else {
            int i = place(paths[a]);
            int j = place(paths[b]);
            int[] newA = with(Arrays.copyOf(paths[a], i), i, Arrays.copyOfRange(paths[b], j, paths[b].length));
            int[] newB = with(Arrays.copyOf(paths[b], j), j, Arrays.copyOfRange(paths[a], i, paths[a].length));
            tryPaths(a, newA, b, newB, heatM);
        }
    }

    private void tryPaths(int a, int[] newA, int b, int[] newB, double heatM) {
        if (!canDo(a, newA) || !canDo(b, newB)) {
            return;
        }
        int[] oldA = paths[a];
        int[] oldB = paths[b];
        double before = energyM();
        set(a, newA);
        if (a != b) {
            set(b, newB);
        }
        if (energyM() - before > -heatM * Math.log(1 - random.nextDouble())) {
            set(a, oldA);
            set(b, oldB);
        }
    }

    private boolean canDo(int boat, int[] path) {
        for (int work : path) {
            if (!canDo[boat][work]) {
                return false;
            }
        }
        return true;
    }

    /** The longest path; the others count a little, so that they do not get long without need. */
    private double energyM() {
        return longestM() + 0.2 * Arrays.stream(lengthM).sum() / lengthM.length;
    }

    private double longestM() {
        double longest = 0;
        for (double one : lengthM) {
            longest = Math.max(longest, one);
        }
        return longest;
    }

    private void set(int boat, int[] path) {
        paths[boat] = path;
        int from = works + boat;
        double metres = 0;
        for (int work : path) {
            metres += legM[from][work];
            from = work;
        }
        lengthM[boat] = metres;
    }

    private int place(int[] path) {
        return random.nextInt(path.length + 1);
    }

    private int[] turned(int[] path) {
        int i = random.nextInt(path.length);
        int j = random.nextInt(path.length);
        int[] turned = path.clone();
        for (int from = Math.min(i, j), to = Math.max(i, j); from < to; from++, to--) {
            turned[from] = path[to];
            turned[to] = path[from];
        }
        return turned;
    }

    private int[] movedWithin(int[] path) {
        int from = random.nextInt(path.length);
        int to = Math.min(path.length, from + 1 + random.nextInt(LONGEST_PART));
        int[] rest = without(path, from, to);
        return with(rest, place(rest), maybeTurned(Arrays.copyOfRange(path, from, to)));
    }

    private int[] maybeTurned(int[] part) {
        boolean turn = random.nextBoolean();
        int[] stops = part.clone();
        for (int i = 0; turn && i < stops.length; i++) {
            stops[i] = part[part.length - 1 - i];
        }
        return stops;
    }

    private static int[] without(int[] path, int from, int to) {
        int[] rest = new int[path.length - (to - from)];
        System.arraycopy(path, 0, rest, 0, from);
        System.arraycopy(path, to, rest, from, path.length - to);
        return rest;
    }

    private static int[] with(int[] path, int before, int[] part) {
        int[] all = new int[path.length + part.length];
        System.arraycopy(path, 0, all, 0, before);
        System.arraycopy(part, 0, all, before, part.length);
        System.arraycopy(path, before, all, before + part.length, path.length - before);
        return all;
    }
}
