package org.sami.crw.sim.boat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.SimulatedBoats;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.picture.BoatsInSight;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.session.record.SessionPictures;
import org.sami.spn.value.GeoPoint;

/**
 * Simulated boats in this process, each with a server of its own on the loopback address, for sessions that want some. They move in
 * real time. Safe for use by several threads.
 */
public final class SimulatedBoatsOnTcp implements SimulatedBoats {
    private final long seed;
    private final Conditions conditions;
    private final RobotKind robots;
    private final SteadyClock clock = SteadyClock.ofThisMachine();
    private final List<BoatOnTcp> boats = new ArrayList<>();
    private final Map<BoatOnTcp, BoatCompanion> companions = new LinkedHashMap<>();
    private Optional<Companions> company = Optional.empty();
    private final BoatsInSight water = new BoatsInSight();
    private WaterLayers layers = WaterLayers.NONE;
    private ForeignVessels foreign = ForeignVessels.NONE;
    private Optional<VesselsAround> vessels = Optional.empty(); // once a boat was launched among them
    private Optional<Path> pictures = Optional.empty();
    private boolean closed;

    /** Makes what works with a boat's server, for each boat. */
    public interface Companions {
        /**
         * For one boat.
         *
         * @param number of the boat among those that were launched, from 1
         * @param boatClock the clock of its server
         */
        BoatCompanion of(String boat, int number, SteadyClock boatClock);
    }

    /** Nobody is launched yet, on still water. */
    public SimulatedBoatsOnTcp(long seed) {
        this(seed, Conditions.CALM);
    }

    /**
     * Nobody is launched yet.
     *
     * @param seed everything random about the boats follows from it
     * @param conditions of water and instruments
     */
    public SimulatedBoatsOnTcp(long seed, Conditions conditions) {
        this(seed, conditions, RobotKind.BOAT);
    }

    /** Nobody is launched yet; who is launched is of a kind, or of the one that its name says where both are together. */
    public SimulatedBoatsOnTcp(long seed, Conditions conditions, RobotKind robots) {
        this.seed = seed;
        this.conditions = conditions;
        this.robots = robots;
    }

    @Override
    public synchronized BoatAddress launch(String boat, GeoPoint at) throws IOException {
        if (closed) {
            throw new IOException("no boats are launched any more");
        }
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings = BoatSettings.of(boat, anyPort, at, seed + boats.size())
                .of(robots.ofName(boat))
                .on(conditions.of(robots))
                .withPicturesIn(pictures().resolve(boat));
        BoatOnTcp launched = new BoatOnTcp(
                settings, clock, TcpServerListener.NONE, UnaryOperator.identity(), water, vessels(at), layers);
        boats.add(launched);
        company.ifPresent(each -> attach(each, launched));
        BaseProtection.ofThisProcess().linkPlainly(launched.address(), true);
        return new BoatAddress(
                launched.address().getAddress().getHostAddress(),
                launched.address().getPort());
    }

    /** Has these vessels on the water, from the launch of the first boat on; to be called before it. */
    public synchronized void among(ForeignVessels others) {
        foreign = others;
    }

    /** Has boats that are launched from now on on water that differs by place. */
    public synchronized void on(WaterLayers newLayers) {
        layers = newLayers;
    }

    private Optional<VesselsAround> vessels(GeoPoint berth) {
        if (vessels.isEmpty() && !foreign.isEmpty()) {
            LocalFrame origin = new LocalFrame(berth.latDeg(), berth.lonDeg());
            vessels = Optional.of(new VesselsAround(foreign, conditions, origin, clock.getAsLong()));
        }
        return vessels;
    }

    /** What is launched. */
    public RobotKind robots() {
        return robots;
    }

    /** Has something work with each boat from now on, also with those that are launched later, until {@link #leaveAlone}. */
    public synchronized void accompany(Companions each) {
        leaveAlone();
        company = Optional.of(each);
        boats.forEach(boat -> attach(each, boat));
    }

    private void attach(Companions each, BoatOnTcp boat) {
        BoatCompanion companion = each.of(boat.name(), boats.indexOf(boat) + 1, clock);
        companions.put(boat, companion);
        boat.attach(companion);
    }

    /** Ends what {@link #accompany} began. */
    public synchronized void leaveAlone() {
        companions.forEach(BoatOnTcp::detach);
        companions.clear();
        company = Optional.empty();
    }

    /** The boats keep their pictures there as long as they are launched. */
    private Path pictures() throws IOException {
        if (pictures.isEmpty()) {
            pictures = Optional.of(Files.createTempDirectory("sami-boats-"));
        }
        return pictures.get();
    }

    @Override
    public synchronized void close() {
        closed = true;
        for (BoatOnTcp boat : boats) {
            BaseProtection.ofThisProcess().linkPlainly(boat.address(), false);
            try {
                boat.close();
            } catch (IOException portStaysOpen) {
                // its threads end with this process
            }
        }
        boats.clear();
        companions.clear();
        try {
            if (pictures.isPresent()) {
                SessionPictures.delete(pictures.get());
            }
        } catch (IOException stays) {
            // it lies among the system's temporary files
        }
    }
}
