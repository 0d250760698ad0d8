package org.sami.session.server.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.bench.FleetProcess;
import org.sami.figures.Figure;
import org.sami.session.person.People;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.value.GeoPoint;

/** A fleet on its way behind TCP and a session that shows it: what the host needs without fronts and with them, and what each front is sent. */
final class FrontsBenchmark {
    private static final String NAME = "session.fronts";

    private final int boats;
    private final int fronts;
    private final double warmUpS;
    private final double measuredS;

    /**
     * Says what is measured.
     *
     * @param warmUpS seconds before each measurement
     * @param measuredS seconds of each
     */
    FrontsBenchmark(int boats, int fronts, double warmUpS, double measuredS) {
        this.boats = boats;
        this.fronts = fronts;
        this.warmUpS = warmUpS;
        this.measuredS = measuredS;
    }

    /** Processor time of the host in parts of one core, without and with fronts, and bytes a second to a front: mean and most. */
    List<Figure> run() throws Exception {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        try (FleetProcess fleet = new FleetProcess(boats);
                Session session = Session.open(SessionSetup.of(
                        library.vocabulary(), library.projectOf("station-keep").orElseThrow()));
                SessionServer server =
                        SessionServer.start(session, People.ofThisMachine(), ServerAddress.onThisMachine(0))) {
            session.begin();
            send(session, fleet);
            double without = cores(warmUpS);
            try (FrontsProcess all = new FrontsProcess(server.url(), fronts)) {
                cores(warmUpS);
                List<Long> before = all.bytes();
                long startNanos = System.nanoTime();
                double with = cores(measuredS);
                List<Long> after = all.bytes();
                double seconds = (System.nanoTime() - startNanos) / 1e9;
                long moving = session.models().fleet().snapshot().stream()
                        .filter(boat -> boat.speedMps().orElse(0) > 0.3)
                        .count();
                double[] kilobytes = IntStream.range(0, fronts)
                        .mapToDouble(i -> (after.get(i) - before.get(i)) / seconds / 1000)
                        .toArray();
                return List.of(
                        figure(0, without, "of one core, CPU of the host"),
                        figure(fronts, with, "of one core, CPU of the host"),
                        figure(
                                fronts,
                                IntStream.range(0, fronts)
                                        .mapToDouble(i -> kilobytes[i])
                                        .average()
                                        .orElse(0),
                                "kB/s to a front, mean"),
                        figure(
                                fronts,
                                IntStream.range(0, fronts)
                                        .mapToDouble(i -> kilobytes[i])
                                        .max()
                                        .orElse(0),
                                "kB/s to a front, most"),
                        figure(fronts, (double) moving, "boats on their way"));
            }
        }
    }

    private Figure figure(int of, double value, String unit) {
        return new Figure(NAME, Map.of("boats", boats, "fronts", of), value, unit, 0);
    }

    /** Links all boats and sends each far away, on ways that are parallel. */
    private static void send(Session session, FleetProcess fleet) throws IOException {
        List<CompletionStage<String>> linked = new ArrayList<>();
        for (InetSocketAddress at : fleet.addresses()) {
            linked.add(session.fleet().connect(new BoatAddress(at.getAddress().getHostAddress(), at.getPort())));
        }
        int i = 0;
        for (CompletionStage<String> one : linked) {
            String boat = one.toCompletableFuture().join();
            i++;
            GeoPoint berth = FleetProcess.berth(i);
            session.byHand()
                    .goTo(boat, GeoPoint.of(berth.latDeg() + 0.02, berth.lonDeg()))
                    .toCompletableFuture()
                    .join();
        }
    }

    /** Processor time of this process over a time, in parts of one core. */
    private static double cores(double seconds) {
        long cpuNanos = cpuNanos();
        long startNanos = System.nanoTime();
        long endNanos = startNanos + (long) (seconds * 1e9);
        while (System.nanoTime() < endNanos) {
            LockSupport.parkNanos(endNanos - System.nanoTime());
        }
        return (double) (cpuNanos() - cpuNanos) / (System.nanoTime() - startNanos);
    }

    private static long cpuNanos() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }
}
