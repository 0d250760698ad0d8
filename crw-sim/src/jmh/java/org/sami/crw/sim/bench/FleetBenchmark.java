package org.sami.crw.sim.bench;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.TlsLinks;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.figures.Figure;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A fleet on its way behind TCP: what its base costs, and how long a command takes to be acknowledged meanwhile. */
final class FleetBenchmark {
    private static final String NAME = "link.boats";
    private static final int HZ = 10;
    private static final long COMMAND_EVERY_NANOS = 10_000_000;

    private final int boats;
    private final double warmUpS;
    private final double measuredS;

    FleetBenchmark(int boats, double warmUpS, double measuredS) {
        this.boats = boats;
        this.warmUpS = warmUpS;
        this.measuredS = measuredS;
    }

    /** CPU of this process, in parts of one core, the 99th percentile of an acknowledgement, and the poses that came. */
    List<Figure> run() throws Exception {
        Measured measured = measure(Optional.empty());
        Map<String, Integer> params = Map.of("boats", boats, "hz", HZ);
        return List.of(
                new Figure(NAME, params, measured.baseCores, "of one core, CPU of the base", 0),
                new Figure(NAME, params, measured.medianMs, "ms, acknowledgement, median", 0),
                new Figure(NAME, params, measured.p99Ms, "ms, acknowledgement, p99", 0),
                new Figure(NAME, params, measured.posesPerS, "poses/s received", 0));
    }

    /**
     * What a fleet costs.
     *
     * @param baseCores processor time of the base, in parts of one core
     * @param boatsCores the same of all boats together
     * @param linkedAfterS from the first connection until all boats have said where they are
     */
    record Measured(
            double baseCores, double boatsCores, double medianMs, double p99Ms, double posesPerS, double linkedAfterS) {
        /** Processor time of the base for each pose, in us: fewer poses come where the machine has no time for all. */
        double baseMicrosAPose() {
            return baseCores * 1e6 / posesPerS;
        }

        /** The same of the boats. */
        double boatsMicrosAPose() {
            return boatsCores * 1e6 / posesPerS;
        }
    }

    /** Measures a fleet with plain links, or with those of a base's keys. */
    Measured measure(Optional<KeyRing> keys) throws Exception {
        LinkSecurity links = keys.isPresent() ? TlsLinks.of(keys.get()) : new OpenLinks();
        try (FleetProcess fleet = new FleetProcess(boats, keys);
                MeasuredBase base = new MeasuredBase("bench-fleet", HZ, links)) {
            long connectNanos = System.nanoTime();
            base.connect(fleet);
            double linkedAfterS = (System.nanoTime() - connectNanos) / 1e9;
            for (int i = 1; i <= boats; i++) {
                base.submit("boat" + i, farAway(i));
            }
            command(base, warmUpS);
            base.takeAnswers();
            long poses = base.poses();
            long cpuNanos = cpuNanos();
            long boatsNanos = fleet.cpuNanos();
            long startNanos = System.nanoTime();
            command(base, measuredS);
            double seconds = (System.nanoTime() - startNanos) / 1e9;
            double cores = (cpuNanos() - cpuNanos) / 1e9 / seconds;
            double boatsCores = (fleet.cpuNanos() - boatsNanos) / 1e9 / seconds;
            double posesPerS = (base.poses() - poses) / seconds;
            List<Double> answersMs = new ArrayList<>(base.takeAnswers());
            Collections.sort(answersMs);
            return new Measured(
                    cores,
                    boatsCores,
                    percentile(answersMs, 0.5),
                    percentile(answersMs, 0.99),
                    posesPerS,
                    linkedAfterS);
        }
    }

    private static FollowPath farAway(int boat) {
        GeoPoint berth = FleetProcess.berth(boat);
        GeoPoint there = GeoPoint.of(berth.latDeg() + 0.1, berth.lonDeg());
        return FollowPath.of("m1-a1-boat" + boat, 1, 1, List.of(there), Priority.MEDIUM);
    }

    /** Commands one boat after the other, a hundred a second. */
    private void command(MeasuredBase base, double seconds) {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        long next = System.nanoTime();
        for (int i = 0; next < end; i++) {
            next += COMMAND_EVERY_NANOS;
            LockSupport.parkNanos(next - System.nanoTime());
            base.command("boat" + (i % boats + 1), 1 - 0.01 * (i / boats % 2));
        }
    }

    private static double percentile(List<Double> sorted, double part) {
        if (sorted.isEmpty()) {
            throw new IllegalStateException("no boat has answered");
        }
        return sorted.get((int) Math.ceil(part * sorted.size()) - 1);
    }

    private static long cpuNanos() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }
}
