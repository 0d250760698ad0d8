package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.sami.crw.handler.CrwDomain;
import org.sami.crw.handler.CrwServices;
import org.sami.crw.handler.ServiceThreads;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.LinkState;
import org.sami.crw.proxy.ProxyConfig;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.session.RealTimeLoop;
import org.sami.crw.session.ScheduledHostClock;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.ReadingResult;
import org.sami.crw.sim.run.ReadingRecorder;
import org.sami.crw.sim.run.RunPlan;
import org.sami.crw.sim.run.RunSettings;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;

/**
 * The base of a run behind TCP: the engine with its host on one thread ({@link #loop}), links, proxies and handlers on another,
 * the base's. What both need is safe for several threads.
 */
final class TcpRuntime implements AutoCloseable {
    /** Visits are told by poses: several while a boat passes a location. */
    private static final double TELEMETRY_HZ = 10;

    private static final long FAREWELL_MS = 3000;
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private final Engine engine;
    private final RealTimeLoop loop;
    private final EngineHost host;
    private final TcpBase base;
    private final ServiceThreads services = new ServiceThreads(ServiceThreads.STANDARD_LIMIT_MILLIS);
    private final CrwDomain domain;
    private final FleetStatus desk = new FleetStatus();
    private final SessionNotes notes;
    private final OperatorNotices notices;
    private final FleetListener ear;
    private final ReadingRecorder readings; // for the base's thread
    private final BoatMonitor watch;

    /** A base that has no boats yet, at the state to which its journal came. */
    TcpRuntime(RunPlan plan, RunSettings settings, SessionJournal journal, SessionStart start) throws IOException {
        engine = new Engine(plan.vocabulary(), plan.project());
        loop = new RealTimeLoop(journal.cameToMillis(), start.clock());
        notes = new SessionNotes(journal, loop::nowMs);
        notices = new OperatorNotices(notes);
        watch = new BoatMonitor(desk, notes, notices);
        readings = new ReadingRecorder(new ScheduledHostClock(loop));
        ear = new FleetListener(desk, notes, notices, loop::nowMs, readings);
        host = EngineHost.builder(engine, journal.restore(engine))
                .journal(journal.inputs())
                .clock(new ScheduledHostClock(loop))
                .executor(loop)
                .build();
        ProxyConfig proxy = ProxyConfig.DEFAULT.withClientId(start.clientId()).withTelemetryHz(TELEMETRY_HZ);
        base = new TcpBase(TcpBaseConfig.of(proxy, settings.fleet().seed()), start.clock(), ear);
        domain = CrwDomain.installInRealTime(
                host, base.boats(), base.executor(), notices, CrwServices.STANDARD, services);
        ear.passTo(domain.boatListener());
    }

    Engine engine() {
        return engine;
    }

    RealTimeLoop loop() {
        return loop;
    }

    EngineHost host() {
        return host;
    }

    TcpBase base() {
        return base;
    }

    FleetStatus desk() {
        return desk;
    }

    SessionNotes notes() {
        return notes;
    }

    OperatorNotices notices() {
        return notices;
    }

    /** What boats have measured, as far as it fits; from any thread. */
    List<ReadingResult> readings() {
        return base.query(boats -> List.copyOf(readings.readings())).join();
    }

    /** Says if some are missing; from any thread. */
    List<NoteResult> missingReadings(long atMillis) {
        return base.query(boats -> readings.notes(atMillis)).join();
    }

    /** What boats had measured in earlier processes. From any thread. */
    void restore(List<ReadingResult> earlier) {
        base.executor().execute(() -> earlier.forEach(readings::add));
    }

    FleetListener ear() {
        return ear;
    }

    /** Whether services compute what boats are to do; from any thread. */
    boolean isComputing() {
        return domain.isComputing();
    }

    /** Looks after all boats. From any thread; done a little later. */
    void lookAfterBoats() {
        lookAfterBoats(() -> {});
    }

    /** The same, and then something on the engine's thread: what was asked of boats before has reached their proxies by then. */
    void lookAfterBoats(Runnable then) {
        base.executor().execute(() -> {
            watch.look(base.boats());
            loop.execute(then);
        });
    }

    /**
     * Asks every proxy why its boat moves or does not, then takes back what missions have for boats, and waits a while until they
     * have stopped. After this nobody commands them from here, and nothing more is told or written down of them.
     */
    void leave() {
        domain.close();
        base.query(boats -> {
                    watch.look(boats);
                    return takeBack(boats);
                })
                .join();
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(FAREWELL_MS);
        while (!base.query(TcpRuntime::haveStopped).join() && System.nanoTime() < end) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
        base.query(TcpRuntime::whoGoesOn).join().forEach(notices::show);
        listenNoLonger();
    }

    private void listenNoLonger() {
        ear.close();
        notices.close();
    }

    private static List<BoatCommand> takeBack(ProxyRegistry boats) {
        List<BoatCommand> taken = new ArrayList<>();
        for (BoatProxy boat : boats.all()) {
            List<BoatCommand> queued = new ArrayList<>(boat.waitingCommands());
            boat.currentCommand().ifPresent(queued::add);
            queued.forEach(command -> taken.addAll(boat.withdraw(command.mission())));
        }
        return taken;
    }

    private static List<String> whoGoesOn(ProxyRegistry boats) {
        return boats.all().stream()
                .filter(boat -> !boat.isAtRest())
                .map(boat -> boat.boatId()
                        + " has not said that it stops; without a link it does what is set for a lost one")
                .toList();
    }

    private static boolean haveStopped(ProxyRegistry boats) {
        return boats.all().stream()
                .allMatch(boat -> boat.isAtRest() || boat.status().link() != LinkState.LINKED);
    }

    @Override
    public void close() {
        listenNoLonger();
        services.close();
        base.close();
        notes.flush();
        host.close();
    }
}
