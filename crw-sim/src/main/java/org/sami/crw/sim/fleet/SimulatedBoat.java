package org.sami.crw.sim.fleet;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.sim.clock.VirtualScheduler;
import org.sami.crw.sim.hull.Instruments;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.link.InMemoryPipe;
import org.sami.crw.sim.picture.RecordingCamera;
import org.sami.crw.sim.picture.Scene;
import org.sami.crw.sim.vessel.Lookout;
import org.sami.spn.value.GeoPoint;

/**
 * One boat of a simulated fleet: its hull, the server on it, the pipes to the base, and its proxy there. The hull has the
 * true state; the proxy knows the reported one.
 *
 * <p>A tick of the boat begins at one moment of the fleet's time and is over by the next; another thread may do it meanwhile. Whoever asks what the
 * boat truly does gets it as of the end of the tick that has begun last.
 */
public final class SimulatedBoat {
    /** So much of its past a boat remembers. */
    public static final int NEWEST = 4096;

    /** Pictures of simulated time are of this day. */
    private static final Instant DAY = Instant.parse("2026-06-01T10:00:00Z");

    private final String id;
    private final Runnable awaitTick;
    private final SimulatedHull hull;
    private final Instruments instruments;
    private final BoatServer server;
    private final BoatProxy proxy;
    private final InMemoryPipe toBoat;
    private final InMemoryPipe toBase;
    private final LinkEnd linkEnd;
    private final RecordingCamera camera;
    private long nowMs; // when the tick on board began
    private final long trackEveryMs;
    private final Deque<TruePosition> track = new ArrayDeque<>();
    private final Deque<ExecutedCommand> executed = new ArrayDeque<>();

    SimulatedBoat(
            String id,
            VirtualScheduler clock,
            FleetConfig config,
            LocalFrame frame,
            double eastM,
            double northM,
            BoatSeeds seeds,
            long fieldSeed,
            Consumer<FleetEvent> listener,
            Runnable awaitTick) {
        this.id = id;
        this.awaitTick = awaitTick;
        trackEveryMs = config.trackEveryMs();
        hull = new SimulatedHull(config.hull(), config.conditions(), frame, eastM, northM, seeds.hull());
        instruments = new Instruments(hull, config.conditions(), seeds.instruments(), fieldSeed);
        if (!config.vessels().isEmpty() && hull.altM().isEmpty()) {
            Lookout lookout = new Lookout(
                    config.vessels(), config.conditions(), frame, hull::eastM, hull::northM, () -> nowMs / 1000.0);
            instruments.lookOut(lookout, lookout::inSight);
        }
        instruments.on(config.layers());
        GeoPoint home = GeoPoint.of(hull.latDeg(), hull.lonDeg());
        camera = new RecordingCamera(id, () -> ahead(fieldSeed, home));
        hull.setCamera(camera);
        ServerConfig.Builder defaults =
                config.conditions().describeTo(config.hull().describeTo(ServerConfig.of(id, id + "-boot1")));
        server = new BoatServer(config.server().apply(defaults).build(), instruments, this::answered);
        toBoat = new InMemoryPipe(clock, config.pipe(), seeds.toBoat());
        toBase = new InMemoryPipe(clock, config.pipe(), seeds.toBase());
        proxy = new BoatProxy(id, toBoat, listener, config.proxy());
        linkEnd = new LinkEnd(toBase);
        linkEnd.connect(server.connect(linkEnd));
        toBoat.connect((message, nowMs) -> linkEnd.receive(message));
        toBase.connect(proxy::receive);
    }

    private Scene ahead(long fieldSeed, GeoPoint home) {
        return new Scene(
                id,
                new GeoPoint(hull.latDeg(), hull.lonDeg(), hull.altM().orElse(0)),
                hull.headingRad(),
                DAY.plusMillis(nowMs),
                fieldSeed,
                home,
                List.of());
    }

    private void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
        keep(executed, new ExecutedCommand(nowMs, command.commandId(), command, answer));
        if (command instanceof StartWaypoints && answer instanceof Ack) {
            hull.putToUse();
        }
    }

    /** Names the boat. */
    public String id() {
        return id;
    }

    /** The hull, with its true position and battery; for recharging it, too. */
    public SimulatedHull hull() {
        awaitTick.run();
        return hull;
    }

    /** The server on the boat. */
    public BoatServer server() {
        awaitTick.run();
        return server;
    }

    /** The base's side. */
    public BoatProxy proxy() {
        return proxy;
    }

    /** The camera on the boat, with what was before it when it took its pictures. */
    public RecordingCamera camera() {
        awaitTick.run();
        return camera;
    }

    /** The pipe from base to boat, for cutting it. */
    public InMemoryPipe toBoat() {
        return toBoat;
    }

    /** The pipe from boat to base, for cutting it. */
    public InMemoryPipe toBase() {
        return toBase;
    }

    /** The boat is, or is not, within range of the base's radio. */
    void setInRange(boolean isInRange) {
        toBoat.setCut(!isInRange);
        toBase.setCut(!isInRange);
    }

    /** Where the boat truly is; of one that flies with its height above the place of its take-off. */
    public GeoPoint position() {
        awaitTick.run();
        return new GeoPoint(hull.latDeg(), hull.lonDeg(), hull.altM().orElse(0));
    }

    /** Metres driven. */
    public double distanceM() {
        awaitTick.run();
        return hull.distanceM();
    }

    /** True charge in percent of full. */
    public double batteryPercent() {
        awaitTick.run();
        return hull.batteryPercent();
    }

    /** How often the battery was recharged. */
    public int recharges() {
        awaitTick.run();
        return hull.recharges();
    }

    private static <T> void keep(Deque<T> rows, T row) {
        if (rows.size() == NEWEST) {
            rows.removeFirst();
        }
        rows.addLast(row);
    }

    /** Where the boat has truly been, in regular steps of time, the newest {@link #NEWEST} points. */
    public List<TruePosition> track() {
        awaitTick.run();
        return List.copyOf(track);
    }

    /** What the boat's server has executed or refused, each command id once, in order, the newest {@link #NEWEST}. */
    public List<ExecutedCommand> executed() {
        awaitTick.run();
        return List.copyOf(executed);
    }

    /** A tick is about to begin; on the clock's thread. */
    void beginTick() {
        linkEnd.beginTick();
    }

    /**
     * Lets time pass on board: the boat takes in what had arrived, moves, and controls. It touches nothing of other boats or of the base, so that all boats
     * may do so side by side, while the base goes on.
     *
     * @param nowMs when the tick begins
     * @param tickMs how long it lasts
     */
    void tickOnBoard(long nowMs, long tickMs) {
        if (nowMs % trackEveryMs == 0) {
            keep(track, new TruePosition(nowMs, hull.latDeg(), hull.lonDeg(), hull.eastM(), hull.northM()));
        }
        this.nowMs = nowMs;
        linkEnd.takeIn(nowMs);
        double seconds = tickMs / 1000.0;
        hull.step(seconds);
        instruments.step(seconds);
        server.tick(nowMs + tickMs);
        hull.setUnderWay(server.mode().isUnderWay());
    }

    /**
     * The tick is over: the boat's messages leave, on the clock's thread, boat by boat in order.
     *
     * @param others says where the other boats are now, for a camera that has taken a picture
     */
    void endTick(Function<String, List<Scene.SeenBoat>> others) {
        camera.finish(others);
        linkEnd.endTick();
    }
}
