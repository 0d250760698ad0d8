package org.sami.crw.sim.bench;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.allocation.Division;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.testing.AllocationScene;
import org.sami.crw.testing.LongestPathAnnealer;
import org.sami.figures.Figure;

/** How long the longest path of a balanced allocation is, next to what an annealer finds in seconds, and what it costs. */
final class BalanceBenchmark {
    private static final String NAME = "service.balance";
    private static final int[][] SIZES = {
        {2, 12}, {3, 20}, {10, 20}, {5, 40}, {3, 50}, {10, 50}, {20, 50}, {2, 100}, {5, 100}, {20, 100}
    };
    private static final int[][] FEW_SIZES = {{3, 20}, {5, 40}, {10, 100}};

    private final boolean quick;

    BalanceBenchmark(boolean quick) {
        this.quick = quick;
    }

    /** For each size the longest path in parts of the annealer's in eight seconds, and the processor time in ms. */
    List<Figure> run() {
        System.out.println("boats locations skills quay  balanced  annealer  ratio  processor time");
        List<Figure> figures = new ArrayList<>();
        for (int[] size : quick ? FEW_SIZES : SIZES) {
            for (int kind = 0; kind < 4; kind += quick ? 3 : 1) {
                figures.addAll(compare(new AllocationScene(size[0], size[1], (kind & 1) == 1, (kind & 2) == 2, 1)));
            }
        }
        return figures;
    }

    private static List<Figure> compare(AllocationScene scene) {
        AllocationProblem problem = scene.problem();
        long begin = processorNanos();
        Division division = AllocationService.STANDARD
                .solve(problem, Optional.of(Criterion.EXECUTION_TIME), 1)
                .best();
        double millis = (processorNanos() - begin) / 1e6;
        double annealedM = LongestPathAnnealer.longestM(problem, 8, 1);
        double ratio = division.longestM() / annealedM;
        System.out.printf(
                Locale.ROOT,
                "%5d %9d %6b %5b %7.1f m %7.1f m %6.3f %8.0f ms%n",
                scene.boats(),
                scene.locations(),
                scene.skills(),
                scene.quay(),
                division.longestM(),
                annealedM,
                ratio,
                millis);
        Map<String, Integer> params = new LinkedHashMap<>();
        params.put("boats", scene.boats());
        params.put("locations", scene.locations());
        params.put("skills", scene.skills() ? 1 : 0);
        params.put("quay", scene.quay() ? 1 : 0);
        return List.of(
                new Figure(NAME + ".longest", params, ratio, "of an annealer's in 8 s", 0),
                new Figure(NAME + ".time", params, millis, "ms of processor time", 0));
    }

    private static long processorNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
