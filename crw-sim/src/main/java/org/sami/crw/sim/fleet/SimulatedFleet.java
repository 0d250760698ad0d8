package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.TrafficRelay;
import org.sami.crw.sim.clock.VirtualScheduler;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.Quay;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.picture.Scene.SeenBoat;

/**
 * Boats {@code boat1} to {@code boatN} on one virtual clock: each with a hull, the boat server, two pipes and the base's
 * proxy. They lie on a line, 5 m apart, eastward from a base point, bows to the north, batteries full.
 * The line is their {@link Quay}: who comes back to it and lies still gets a full battery.
 *
 * <p>{@link #start} has every boat ticked at 10 Hz of virtual time, in order, for as long as somebody drives the clock:
 *
 * <pre>{@code
 * VirtualClock clock = new VirtualClock();
 * SimulatedFleet fleet = new SimulatedFleet(clock, 42, 5, 45.4, 10.9, id -> listener);
 * fleet.start();
 * fleet.boat("boat1").orElseThrow().proxy().commands().submit(FollowPath.of("m1-a1-boat1", 1, 1, points, Priority.MEDIUM));
 * clock.runUntil(600_000);
 * }</pre>
 *
 * <p>A tick lasts from one of these moments to the next: boats take in what had arrived when it began, and what they say leaves at its end. The base goes
 * on meanwhile (docs/decisions, 0316).
 *
 * <p>The links are up after about 400 virtual milliseconds; commands that are submitted earlier wait. Listeners are called
 * inside actions of the clock. Equal seeds and equal commands at equal virtual times give equal tracks, to the last bit.
 * For the thread that drives the clock.
 */
public final class SimulatedFleet {
    /** Virtual time between two ticks of a boat. */
    public static final long TICK_MS = 100;

    /** Between two boats on the line, in metres. */
    public static final double SPACING_M = 5;

    private final VirtualScheduler clock;
    private final long seed;
    private final SplittableRandom seeds;
    private final Function<String, Consumer<FleetEvent>> listeners;
    private final FleetConfig config;
    private final LocalFrame frame;
    private final double shoreEastM; // the base's radio, in the middle of the quay
    private final List<SimulatedBoat> boats = new ArrayList<>();
    private final ProxyRegistry proxies = new ProxyRegistry();
    private final TrafficRelay traffic = new TrafficRelay();
    private List<SimulatedBoat> ticked = List.of(); // in the tick that has begun last
    private TickHelpers helpers = new TickHelpers(0);
    private Optional<Object> run = Optional.empty(); // the present start; a tick of an earlier one does nothing

    /**
     * A fleet of default boats.
     *
     * @param seed everything random about the boats follows from it
     * @param boatCount how many, from 0 up
     * @param baseLatDeg latitude of the base point in degrees
     * @param baseLonDeg longitude of the base point in degrees
     * @param listeners gives each boat's id its listener; called once per boat, in order
     */
    public SimulatedFleet(
            VirtualScheduler clock,
            long seed,
            int boatCount,
            double baseLatDeg,
            double baseLonDeg,
            Function<String, Consumer<FleetEvent>> listeners) {
        this(clock, seed, boatCount, baseLatDeg, baseLonDeg, listeners, FleetConfig.DEFAULT);
    }

    /** A fleet of other than default boats; the rest as above. */
    public SimulatedFleet(
            VirtualScheduler clock,
            long seed,
            int boatCount,
            double baseLatDeg,
            double baseLonDeg,
            Function<String, Consumer<FleetEvent>> listeners,
            FleetConfig config) {
        this.clock = Objects.requireNonNull(clock, "clock");
        if (boatCount < 0) {
            throw new IllegalArgumentException("a fleet of " + boatCount + " boats");
        }
        this.seed = seed;
        this.listeners = listeners;
        this.config = config;
        frame = new LocalFrame(baseLatDeg, baseLonDeg);
        shoreEastM = Math.max(0, boatCount - 1) * SPACING_M / 2;
        seeds = new SplittableRandom(seed);
        for (int i = 0; i < boatCount; i++) {
            add(config.robots().nameOf(i), i * SPACING_M, 0)
                    .setQuay(new Quay(0, (boatCount - 1) * SPACING_M, 0, Quay.REACH_M));
        }
    }

    private SimulatedHull add(String id, double eastM, double northM) {
        return add(id, eastM, northM, config.hull());
    }

    private SimulatedHull add(String id, double eastM, double northM, HullConfig hull) {
        SimulatedBoat boat = new SimulatedBoat(
                id,
                clock,
                config.withHull(hull),
                frame,
                eastM,
                northM,
                BoatSeeds.next(seeds),
                seed,
                listeners.apply(id),
                this::awaitTick);
        boats.add(boat);
        proxies.add(boat.proxy());
        return boat.hull();
    }

    /**
     * Another boat joins, from now on, at so many metres from the base point; that is its quay.
     *
     * @throws IllegalArgumentException if there is one with its id
     */
    public SimulatedBoat join(String id, double eastM, double northM) {
        return join(id, eastM, northM, config.hull());
    }

    /**
     * Another robot joins, which may be of another kind.
     *
     * @throws IllegalArgumentException if there is one with its id
     */
    public SimulatedBoat join(String id, double eastM, double northM, HullConfig hull) {
        if (boat(id).isPresent()) {
            throw new IllegalArgumentException("there is a boat " + id + " already");
        }
        add(id, eastM, northM, hull).setQuay(new Quay(eastM, eastM, northM, Quay.REACH_M));
        return boats.get(boats.size() - 1);
    }

    /** The id of a boat of such a fleet, counted from 0. */
    public static String idOf(int index) {
        return "boat" + (index + 1);
    }

    /**
     * Lets further threads tick the boats, until they are ended; runs are equal with any number of them.
     *
     * @param count of threads in addition to the clock's
     */
    public void startHelpers(int count) {
        use(new TickHelpers(count));
    }

    /** From now on these tick the boats. */
    void use(TickHelpers others) {
        awaitTick();
        helpers.close();
        helpers = others;
    }

    /** Ends these threads. Boats are ticked on the clock's thread alone from then on. */
    public void endHelpers() {
        startHelpers(0);
    }

    /** Begins to tick the boats, at the present virtual time and every 100 ms from then on. */
    public void start() {
        if (run.isEmpty()) {
            Object started = new Object();
            run = Optional.of(started);
            clock.at(clock.nowMs(), () -> tick(started));
        }
    }

    /** Ends the ticking: the world of these boats stands still, and nothing of theirs waits on the clock but what is under way. */
    public void stop() {
        run = Optional.empty();
    }

    /** All boats, in order. */
    public List<SimulatedBoat> boats() {
        return List.copyOf(boats);
    }

    /** The boat with this id. */
    public Optional<SimulatedBoat> boat(String id) {
        return boats.stream().filter(boat -> boat.id().equals(id)).findFirst();
    }

    /** The base's proxies, in order. */
    public ProxyRegistry proxies() {
        return proxies;
    }

    /** The plane in metres around the base point, on which the hulls move. */
    public LocalFrame frame() {
        return frame;
    }

    private void tick(Object started) {
        if (run.isEmpty() || run.get() != started) {
            return;
        }
        long nowMs = clock.nowMs();
        awaitTick();
        if (config.radio().rangeM().isPresent()) {
            boats.forEach(this::reach);
        }
        ticked.forEach(boat -> boat.endTick(this::others));
        beginTick(nowMs);
        for (SimulatedBoat boat : ticked) {
            boat.proxy().tick(nowMs);
        }
        traffic.tick(proxies.all(), nowMs);
        clock.after(TICK_MS, () -> tick(started));
    }

    private void reach(SimulatedBoat boat) {
        SimulatedHull hull = boat.hull();
        boat.setInRange(config.radio().reaches(Math.hypot(hull.eastM() - shoreEastM, hull.northM())));
    }

    private List<SeenBoat> others(String boat) {
        return boats.stream()
                .filter(one -> !one.id().equals(boat))
                .map(one -> new SeenBoat(
                        one.id(),
                        one.position(),
                        one.hull().headingRad(),
                        one.hull().altM().isPresent()))
                .toList();
    }

    /** Boats take part in a tick from its beginning: those that join meanwhile do so in the next one. */
    private void beginTick(long nowMs) {
        List<SimulatedBoat> all = boats();
        ticked = all;
        all.forEach(SimulatedBoat::beginTick);
        helpers.begin(all.size(), i -> all.get(i).tickOnBoard(nowMs, TICK_MS));
    }

    private void awaitTick() {
        helpers.await();
    }
}
