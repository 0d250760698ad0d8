package org.sami.crw.gui;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.ToLongFunction;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.session.Session;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.palette.Theme;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.testing.TemporaryFolder;
import org.sami.ui.EventThread;

/**
 * How soon the event thread of the real window serves what is posted to it, while a large fleet behind TCP sails for many missions and all panels
 * are shown as they lie at first.
 */
final class LatencyBenchmark {
    private static final String NAME = "window.latency"; // of the largest fleet; others add a word of theirs
    private static final String PLAN = "station-keep";
    private static final long PROBE_EVERY_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    private static final int PATIENCE_S = 180;
    private static final int SETTLE_S = 10;

    private final String name;
    private final int boats;
    private final int missions;
    private final int seconds;

    private LatencyBenchmark(String kind, int boats, int missions, int seconds) {
        this.name = kind.isEmpty() ? NAME : NAME + "." + kind;
        this.boats = boats;
        this.missions = missions;
        this.seconds = seconds;
    }

    /**
     * Measures.
     *
     * @param args boats, missions, seconds, and for a further measurement {@code ours} or {@code vehicles}, which speak MAVLink
     */
    public static void main(String[] args) throws Exception {
        String kind = args.length > 3 ? args[3] : "";
        LatencyBenchmark benchmark = new LatencyBenchmark(
                kind, Integer.parseInt(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2]));
        try (TemporaryFolder folder = new TemporaryFolder("window-latency")) {
            System.setProperty(
                    "sami.vehicles", folder.path().resolve("vehicles").toString()); // no user's
            benchmark.run(folder.path(), kind.equals("vehicles"));
        }
        System.exit(0);
    }

    private void run(Path folder, boolean vehicles) throws Exception {
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        Path project = folder.resolve("project.json");
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Files.writeString(
                project,
                new ProjectWriter(library.vocabulary())
                        .text(library.projectOf(PLAN).orElseThrow()));
        try (BenchmarkFleet fleet = vehicles ? BenchmarkFleet.vehicles(boats) : BenchmarkFleet.ours(boats)) {
            StartOptions options = new StartOptions(
                    fleet.addresses(),
                    Optional.of(project),
                    Optional.of(Theme.LIGHT),
                    Optional.of(100),
                    Optional.of(false));
            OperatorWindow window =
                    WindowStart.open(options, DataDirectory.open(folder.resolve("data")), ended::complete);
            Session session = window.session();
            await("all boats are linked", () -> linked(session) == boats);
            session.execute(() -> session.addOperator(new SharingOperator(session, missions, fleet.pier())));
            for (int i = 1; i <= missions; i++) {
                session.start(PLAN, "mission " + i, Map.of());
            }
            await(
                    "all missions have their boats under way",
                    () -> session.models().fleet().snapshot().stream()
                            .allMatch(boat -> boat.command().isPresent()));
            probe(SETTLE_S);
            figures(probe(seconds), fleet.hz());
            int running = session.models().missions().snapshot().running().size();
            if (running < missions) {
                throw new IllegalStateException("only " + running + " missions ran to the end of the measurement");
            }
            EventThread.get(() -> {
                window.end();
                return null;
            });
            ended.get(PATIENCE_S, TimeUnit.SECONDS);
        }
    }

    private static long linked(Session session) {
        return session.models().fleet().snapshot().stream()
                .filter(boat -> boat.link() == LinkState.LINKED && boat.pose().isPresent())
                .count();
    }

    private static void await(String what, BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new IllegalStateException("not within " + PATIENCE_S + " s: " + what);
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(20));
        }
    }

    /** How long a probe waited, by the clock and in CPU time of the event thread: what others on the machine take is not in the latter. */
    private record Wait(long nanos, long cpuNanos) {}

    /** What was measured, and how much of the time the event thread worked. */
    private record Probed(List<Wait> waits, double busy) {}

    private static Probed probe(int seconds) {
        int probes = (int) (TimeUnit.SECONDS.toNanos(seconds) / PROBE_EVERY_NANOS);
        List<CompletableFuture<Wait>> waits = new ArrayList<>();
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long eventThread = EventThread.get(() -> Thread.currentThread().getId());
        long start = System.nanoTime();
        long busy = threads.getThreadCpuTime(eventThread);
        for (int i = 0; i < probes; i++) {
            long due = start + i * PROBE_EVERY_NANOS;
            LockSupport.parkNanos(due - System.nanoTime());
            CompletableFuture<Wait> served = new CompletableFuture<>();
            waits.add(served);
            long posted = System.nanoTime();
            long cpu = threads.getThreadCpuTime(eventThread);
            EventThread.later(() ->
                    served.complete(new Wait(System.nanoTime() - posted, threads.getCurrentThreadCpuTime() - cpu)));
        }
        List<Wait> all = waits.stream().map(CompletableFuture::join).toList();
        double worked = threads.getThreadCpuTime(eventThread) - busy;
        return new Probed(all, worked / (System.nanoTime() - start));
    }

    private void figures(Probed probed, int hz) throws Exception {
        Map<String, Integer> params = Map.of("boats", boats, "hz", hz, "missions", missions);
        List<Figure> figures = List.of(
                new Figure(name, params, ms(probed, Wait::nanos, 0.5), "ms, event thread, median", 0),
                new Figure(name, params, ms(probed, Wait::nanos, 0.99), "ms, event thread, p99", 0),
                new Figure(name, params, ms(probed, Wait::nanos, 1), "ms, event thread, most", 0),
                new Figure(name, params, ms(probed, Wait::cpuNanos, 0.99), "ms of its CPU time, p99", 0),
                new Figure(name, params, probed.busy(), "of one core, event thread", 0));
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), name, figures);
    }

    private static double ms(Probed probed, ToLongFunction<Wait> what, double part) {
        long[] nanos = probed.waits().stream().mapToLong(what).sorted().toArray();
        return nanos[(int) Math.ceil(part * nanos.length) - 1] / 1e6;
    }
}
