package org.sami.crw.sim.boat;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Instant;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.file.BoatFiles;
import org.sami.boat.server.log.CommandLogFile;
import org.sami.boat.server.log.LogEntries;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.boat.server.tcp.LogFaultReports;
import org.sami.boat.server.tcp.TcpBoatServer;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.hull.Instruments;
import org.sami.crw.sim.hull.Quay;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.picture.BoatsInSight;
import org.sami.crw.sim.picture.DrawingCamera;
import org.sami.crw.sim.picture.Scene;
import org.sami.spn.value.GeoPoint;

/**
 * A simulated boat that is reached over TCP: a hull, the boat server, its port and its log. The hull moves in the time of this
 * machine.
 *
 * <p>A boat whose log is there already takes back what it had executed, and lies where the settings say: it does not move
 * before a command. Safe for use by several threads.
 */
public final class BoatOnTcp implements Closeable {
    private static final double LONGEST_STEP_S = 1; // after the machine was suspended the hull goes on where it was

    private static final long INSTRUMENTS = 0x67707320L;

    private final SimulatedHull hull;
    private final BoatServer boat;
    private final Instruments instruments;
    private final String bootId = UUID.randomUUID().toString();
    private final Optional<CommandLogFile> log;
    private final Optional<DrawingCamera> camera;
    private final String name;
    private final BoatsInSight water;
    private final TcpBoatServer server;
    private long lastMs;
    private volatile double batteryPercent; // as the boat's thread last set it

    /**
     * Launches the boat.
     *
     * @throws IOException if its port or its log cannot be had
     */
    public BoatOnTcp(BoatSettings settings, SteadyClock clock, TcpServerListener listener) throws IOException {
        this(settings, clock, listener, UnaryOperator.identity());
    }

    /**
     * Launches the boat with links of the caller's choice, such as protected ones.
     *
     * @throws IOException if its port or its log cannot be had
     */
    public BoatOnTcp(
            BoatSettings settings, SteadyClock clock, TcpServerListener listener, UnaryOperator<TcpServerConfig> links)
            throws IOException {
        this(settings, clock, listener, links, new BoatsInSight(), Optional.empty(), WaterLayers.NONE);
    }

    /**
     * Launches the boat on the water of other boats, which its camera sees.
     *
     * @param vessels that it looks out for; empty where there are none
     * @param layers of the water, by place
     * @throws IOException if its port or its log cannot be had
     */
    BoatOnTcp(
            BoatSettings settings,
            SteadyClock clock,
            TcpServerListener listener,
            UnaryOperator<TcpServerConfig> links,
            BoatsInSight water,
            Optional<VesselsAround> vessels,
            WaterLayers layers)
            throws IOException {
        name = settings.name();
        this.water = water;
        LocalFrame frame = new LocalFrame(settings.at().latDeg(), settings.at().lonDeg());
        hull = new SimulatedHull(settings.hull(), settings.conditions(), frame, 0, 0, settings.seed());
        instruments = new Instruments(hull, settings.conditions(), settings.seed() ^ INSTRUMENTS, settings.fieldSeed());
        vessels.filter(any -> hull.altM().isEmpty())
                .map(around -> around.of(hull, clock))
                .ifPresent(lookout -> instruments.lookOut(lookout, lookout::inSight));
        instruments.on(layers);
        hull.setBatteryPercent(settings.batteryPercent());
        batteryPercent = settings.batteryPercent();
        hull.setQuay(Quay.atOrigin());
        boat = new BoatServer(settings.server(bootId), instruments, new Log());
        log = openLog(settings, boat, listener);
        log.ifPresent(file -> boat.restore(file.epoch()));
        try {
            camera = openCamera(settings, listener);
            camera.ifPresent(hull::setCamera);
            server = new TcpBoatServer(
                    settings.name(),
                    boat,
                    links.apply(TcpServerConfig.on(settings.address()).withFiles(files(settings))),
                    clock,
                    this::moveTo,
                    listener);
            lastMs = clock.getAsLong();
            server.start();
        } catch (IOException | RuntimeException e) {
            closeLog();
            throw e;
        }
    }

    /** What its clients may fetch: its log and its pictures, where it keeps some. */
    private static BoatFiles files(BoatSettings settings) {
        BoatFiles logs = settings.logPlace()
                .map(place -> CommandLogFile.files(place.file()))
                .orElseGet(BoatFiles::none);
        return settings.pictureFolder()
                .map(folder -> logs.with(KeptFile.PICTURE, folder, name -> name.endsWith(".jpg")))
                .orElse(logs);
    }

    /** Writes the server's log entries to the file, where there is one. */
    private final class Log implements ServerLog {
        @Override
        public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
            BoatOnTcp.this.answered(nowMs, clientId, command, answer);
        }

        @Override
        public void appointed(CommandEpoch epoch) {
            log.ifPresent(file -> file.appointed(epoch));
        }

        @Override
        public void leftOut(long nowMs, long count) {
            log.ifPresent(file -> file.leftOut(nowMs, count));
        }
    }

    private void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
        log.ifPresent(file -> file.answered(nowMs, clientId, command, answer));
        if (command instanceof StartWaypoints && answer instanceof Ack) {
            hull.putToUse();
        }
    }

    private GeoPoint position() {
        return new GeoPoint(hull.latDeg(), hull.lonDeg(), hull.altM().orElse(0));
    }

    /** The camera of a boat that keeps pictures. */
    private Optional<DrawingCamera> openCamera(BoatSettings settings, TcpServerListener listener) throws IOException {
        if (settings.pictureFolder().isEmpty()) {
            return Optional.empty();
        }
        PictureFolder folder = PictureFolder.open(settings.pictureFolder().get(), settings.name());
        Supplier<Scene> ahead = () -> new Scene(
                settings.name(),
                position(),
                hull.headingRad(),
                Instant.now(),
                settings.fieldSeed(),
                settings.at(),
                water.others(settings.name()));
        return Optional.of(new DrawingCamera(settings.name(), folder, ahead, listener::failed));
    }

    private Optional<CommandLogFile> openLog(BoatSettings settings, BoatServer boat, TcpServerListener listener)
            throws IOException {
        Optional<LogPlace> place = settings.logPlace();
        if (place.isEmpty()) {
            return Optional.empty();
        }
        place.get().makeFolder();
        return Optional.of(CommandLogFile.open(
                place.get(),
                bootId,
                LogEntries.restoring(boat),
                new LogFaultReports(place.get().file(), listener)));
    }

    /** Where the boat listens, with the port that it got. */
    public InetSocketAddress address() {
        return server.address();
    }

    /** The boat's name. */
    public String name() {
        return name;
    }

    /** Has something work with the boat's server from now on, until it is detached or the boat ends. */
    public void attach(BoatCompanion companion) {
        server.attach(companion);
    }

    /** Ends what {@link #attach} began. */
    public void detach(BoatCompanion companion) {
        server.detach(companion);
    }

    /** Its charge in percent, a moment ago. */
    public double batteryPercent() {
        return batteryPercent;
    }

    /** Names this start of the boat's server. */
    public String bootId() {
        return bootId;
    }

    /** How many commands of earlier starts the boat knows from its log. */
    public int restored() {
        return log.map(CommandLogFile::restored).orElse(0);
    }

    /** How many lines of the log are damaged; their content is lost. */
    public int unreadLogLines() {
        return log.map(CommandLogFile::unreadLines).orElse(0);
    }

    /** How many connections were refused because they could not be protected, or for the client's key. */
    public long refusedConnections() {
        return server.refusedConnections();
    }

    private void moveTo(long nowMs) {
        double seconds = Math.min(LONGEST_STEP_S, (nowMs - lastMs) / 1000.0);
        lastMs = nowMs;
        if (seconds > 0) {
            hull.setUnderWay(boat.mode().isUnderWay());
            hull.step(seconds);
            instruments.step(seconds);
            batteryPercent = hull.batteryPercent();
            water.seen(new Scene.SeenBoat(
                    name, position(), hull.headingRad(), hull.altM().isPresent()));
        }
    }

    /** Stops the server, ends its threads and closes the log. */
    @Override
    public void close() throws IOException {
        try {
            server.close();
        } finally {
            camera.ifPresent(DrawingCamera::close);
            water.gone(name);
            closeLog();
        }
    }

    private void closeLog() throws IOException {
        if (log.isPresent()) {
            log.get().close();
        }
    }
}
