package org.sami.crw.mavlink.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.figures.Figure;
import org.sami.mavlink.testing.SmallBoatProcess;

/**
 * A base with boats that speak MAVLink, each on a TCP link of its own, that report as often as a base asks for. Measured is processor time of the base's
 * threads, in parts of one core; those of the Java machine (compilation, garbage) are a figure of their own.
 */
final class VehicleBenchmark {
    static final String NAME = "vehicles.base";
    private static final int HZ = 4;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final int boats;
    private final double warmUpS;
    private final double measuredS;

    VehicleBenchmark(int boats, double warmUpS, double measuredS) {
        this.boats = boats;
        this.warmUpS = warmUpS;
        this.measuredS = measuredS;
    }

    List<Figure> run() throws Exception {
        Path home = Files.createTempDirectory("vehicles");
        System.setProperty("sami.vehicles", home.toString()); // what is kept of each vehicle is no user's
        try (SmallBoatProcess fleet = new SmallBoatProcess(boats);
                CountingBase base = new CountingBase()) {
            base.connect(fleet.addresses());
            pass(warmUpS);
            long poses = base.poses.get();
            Times before = Times.now();
            pass(measuredS);
            Times after = Times.now();
            double seconds = (after.atNanos - before.atNanos) / 1e9;
            Map<String, Integer> params = Map.of("boats", boats, "hz", HZ);
            return List.of(
                    figure("", params, cores(before, after, name -> true), "of one core, all of the base's threads"),
                    figure(".links", params, cores(before, after, VehicleBenchmark::isLink), "of one core, reading"),
                    figure(
                            ".known",
                            params,
                            cores(before, after, "mavlink base"::equals),
                            "of one core, what is known"),
                    figure(".boats", params, cores(before, after, "mavlink boats"::equals), "of one core, as boats"),
                    figure(
                            ".process",
                            params,
                            (after.processNanos - before.processNanos) / 1e9 / seconds,
                            "of one core, with the Java machine's"),
                    figure(".poses", params, (base.poses.get() - poses) / seconds, "poses/s received"));
        }
    }

    private static boolean isLink(String thread) {
        return thread.startsWith("mavlink mavlink:");
    }

    private static Figure figure(String what, Map<String, Integer> params, double value, String unit) {
        return new Figure(NAME + what, params, value, unit, 0);
    }

    private static double cores(Times before, Times after, Predicate<String> threads) {
        long nanos = after.threadNanos.entrySet().stream()
                .filter(thread -> threads.test(after.names.get(thread.getKey())))
                .mapToLong(thread -> thread.getValue() - before.threadNanos.getOrDefault(thread.getKey(), 0L))
                .sum();
        return (double) nanos / (after.atNanos - before.atNanos);
    }

    private static void pass(double seconds) {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
    }

    /** Processor time used so far, by thread. */
    private record Times(long atNanos, long processNanos, Map<Long, Long> threadNanos, Map<Long, String> names) {
        static Times now() {
            Map<Long, Long> nanos = new ConcurrentHashMap<>();
            Map<Long, String> names = new ConcurrentHashMap<>();
            Arrays.stream(THREADS.getThreadInfo(THREADS.getAllThreadIds()))
                    .filter(Objects::nonNull)
                    .forEach(thread -> note(thread, nanos, names));
            long process = ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean.class)
                    .getProcessCpuTime();
            return new Times(System.nanoTime(), process, nanos, names);
        }

        private static void note(ThreadInfo thread, Map<Long, Long> nanos, Map<Long, String> names) {
            long used = THREADS.getThreadCpuTime(thread.getThreadId());
            if (used >= 0) {
                nanos.put(thread.getThreadId(), used);
                names.put(thread.getThreadId(), thread.getThreadName());
            }
        }
    }

    /** A base that counts the poses that reach it. */
    private static final class CountingBase implements BaseListener, Consumer<FleetEvent>, AutoCloseable {
        private final AtomicLong poses = new AtomicLong();
        private final Set<String> placed = ConcurrentHashMap.newKeySet();
        private final TcpBase base = new TcpBase(
                TcpBaseConfig.of(
                        ProxyConfig.DEFAULT.withClientId("bench-vehicles").withTelemetryHz(HZ), 1),
                SteadyClock.ofThisMachine(),
                this);

        void connect(List<String> addresses) {
            new ArrayList<>(addresses)
                    .forEach(address -> base.connect(BoatAddress.parse(address).toSocketAddress()));
            long end = System.nanoTime() + 60_000_000_000L;
            while (placed.size() < addresses.size()) {
                if (System.nanoTime() > end) {
                    throw new IllegalStateException("of the boats only " + placed + " say where they are");
                }
                pass(0.05);
            }
        }

        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return this;
        }

        @Override
        public void onFailure(String what, RuntimeException cause) {
            throw new IllegalStateException(what, cause);
        }

        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.StatusReported reported) {
                BoatStatus status = reported.status();
                poses.incrementAndGet();
                status.pose().ifPresent(pose -> placed.add(status.boatId()));
            }
        }

        @Override
        public void close() {
            base.close();
        }
    }
}
