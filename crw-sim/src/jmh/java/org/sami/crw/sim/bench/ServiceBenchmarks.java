package org.sami.crw.sim.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.crw.service.coverage.LawnMower;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.PathService;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What the operator waits for when a plan asks a service. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@State(Scope.Thread)
public class ServiceBenchmarks {
    private static final GeoPoint CENTRE = GeoPoint.of(45.7, 10.72);

    private final AllocationProblem visits;
    private final CoverageProblem area;
    private final PathProblem way;

    /** The same problems each time. */
    public ServiceBenchmarks() {
        Random random = new Random(11);
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        Map<String, Optional<GeoPoint>> explorers = new LinkedHashMap<>();
        for (int i = 0; i < 20; i++) {
            boats.put("boat-" + i, at(i * 5, -520));
            explorers.put("boat-" + i, Optional.of(at(i * 5, -520)));
        }
        List<GeoPoint> locations = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            locations.add(at(random.nextDouble() * 1000 - 500, random.nextDouble() * 1000 - 500));
        }
        visits = AllocationProblem.ofVisits(boats, locations);
        GeoArea square = new GeoArea(
                List.of(at(-500, -500), at(500, -500), at(500, 500), at(-500, 500)),
                List.of(hexagon(-200, 100, 60), hexagon(150, -120, 80), hexagon(220, 260, 40)));
        area = CoverageProblem.of(explorers, square, 3);
        List<GeoArea> obstacles = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            obstacles.add(new GeoArea(
                    hexagon(i % 20 * 50 - 475, i / 20 * 100 - 450, 10 + random.nextDouble() * 25), List.of()));
        }
        Water water = Water.of(CENTRE, obstacles, Optional.empty());
        way = new PathProblem(at(-560, -560), at(560, 560), water, 5);
    }

    /** 100 locations to 20 boats, as fast as it goes. */
    @Benchmark
    public AllocationService.Options allocation() {
        return AllocationService.STANDARD.solve(visits, Optional.of(Criterion.COMPUTATION_TIME), 1);
    }

    /** The same so that the last boat is done early. */
    @Benchmark
    public AllocationService.Options allocationBalanced() {
        return AllocationService.STANDARD.solve(visits, Optional.of(Criterion.EXECUTION_TIME), 1);
    }

    /** One square kilometre with three islands in lanes 3 m apart, for 20 boats. */
    @Benchmark
    public Coverage coverage() {
        return new LawnMower().cover(area);
    }

    /** The shortest way around 200 obstacles. */
    @Benchmark
    public PathService.Options path() {
        return PathService.STANDARD.find(way, Optional.empty(), 1);
    }

    private static List<GeoPoint> hexagon(double eastM, double northM, double radiusM) {
        List<GeoPoint> ring = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            double angle = Math.PI / 3 * i + 0.2;
            ring.add(at(eastM + radiusM * Math.cos(angle), northM + radiusM * Math.sin(angle)));
        }
        return ring;
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(CENTRE, eastM, northM);
    }
}
