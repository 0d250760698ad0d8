package org.sami.boat.app.boat;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sami.boat.hull.board.BoardListener;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.board.BoardVehicle;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.settings.HullFile;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.log.CommandLogFile;
import org.sami.boat.server.log.LogEntries;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.tcp.TcpBoatServer;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * The boat on a phone: board, position, server and log, in the files of the app. It begins to serve once it knows where it is, for that is its home at the
 * first start; where port or log cannot be had, it says so and tries again. A boat that is begun again has the name, commands, stop and home that it had, and
 * does not move before a new command. Safe for use by several threads.
 */
public final class BoatOnPhone implements Closeable {
    private static final long LOOK_MS = 100;
    private static final long RETRY_MS = 5000;
    private static final long COMPASS_WAIT_MS = 3000;
    private static final double LEAST_ERROR_M = 1;
    private static final int CHARGE_STEP = 10;
    private static final double USUAL_DRIFT_MPS = 0.2;

    private final AppFiles files;
    private final PhoneSettings settings;
    private final InetAddress address;
    private final PhoneHealth health;
    private final SteadyClock clock;
    private final PhoneNews listener;
    private final PhoneStop stop;
    private final PhoneKeys keys;
    private final PositionFilter position = new PositionFilter();
    private final BoardVehicle board;
    private final PhoneVehicle vehicle;
    private final PhoneCamera camera;
    private final String bootId = UUID.randomUUID().toString();
    private final ScheduledExecutorService starter;
    private long locatedMs = Long.MIN_VALUE; // these two for the starter's thread
    private long retryMs = Long.MIN_VALUE;
    private volatile Optional<Running> running = Optional.empty();
    private volatile String fault = "";
    private volatile Future<?> looking = CompletableFuture.completedFuture(null);
    private volatile boolean closed;

    /**
     * A boat that is not begun yet.
     *
     * @param address where it listens; the wildcard address is all networks of the phone
     * @param boardPort where the control board is, or will be
     * @param pictures takes pictures of what is ahead
     * @throws IOException if the hull's settings cannot be read, for a wrong kind of hull would be driven wrongly, or the keys, or the folder of the pictures
     */
    public BoatOnPhone(
            AppFiles files,
            PhoneSettings settings,
            InetAddress address,
            StreamPort boardPort,
            PictureSource pictures,
            PhoneHealth health,
            SteadyClock clock,
            PhoneNews listener)
            throws IOException {
        this.files = Objects.requireNonNull(files, "files");
        this.settings = Objects.requireNonNull(settings, "settings");
        this.address = Objects.requireNonNull(address, "address");
        this.health = Objects.requireNonNull(health, "health");
        this.clock = Objects.requireNonNull(clock, "clock");
        this.listener = Objects.requireNonNull(listener, "listener");
        stop = new PhoneStop(files);
        keys = new PhoneKeys(files, settings.name());
        board = new BoardVehicle(hullSettings(), position, boardPort, clock, new Board());
        camera = new PhoneCamera(pictures, PictureFolder.open(files.pictures(), settings.name()), listener);
        vehicle = new PhoneVehicle(board, health, stop, camera);
        starter = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread thread = new Thread(work, "boat-starter");
            thread.setDaemon(true);
            return thread;
        });
    }

    private HullSettings hullSettings() throws IOException {
        return Files.exists(files.hull())
                ? HullFile.read(files.hull())
                : HullSettings.of(HullKind.DIFFERENTIAL).build();
    }

    /** Begins to command the board, and to serve as soon as the position is known; once only. */
    public void start() {
        board.start();
        looking = starter.scheduleWithFixedDelay(this::look, 0, LOOK_MS, TimeUnit.MILLISECONDS);
    }

    private void look() {
        long nowMs = clock.getAsLong();
        if (running.isPresent() || closed || nowMs < retryMs) {
            return;
        }
        try {
            Pose pose = position.pose(nowMs);
            if (isReady(pose, nowMs)) {
                running = Optional.of(new Running(pose));
                fault = "";
                listener.said("serves on port " + port());
            }
        } catch (IOException | RuntimeException e) {
            fault = "the boat's server cannot begin: " + e.getMessage();
            retryMs = nowMs + RETRY_MS;
            listener.said(fault);
        }
    }

    private boolean isReady(Pose pose, long nowMs) {
        if (!pose.isLocated()) {
            locatedMs = Long.MIN_VALUE;
            return false;
        }
        locatedMs = locatedMs == Long.MIN_VALUE ? nowMs : locatedMs;
        if (!pose.isComplete() && nowMs - locatedMs >= COMPASS_WAIT_MS) {
            position.assumeHeading();
        }
        return pose.isComplete();
    }

    /** What the phone's sensors measure goes in there. */
    public PositionFilter position() {
        return position;
    }

    /** The control board. */
    public BoardVehicle board() {
        return board;
    }

    /** How the phone is. */
    public PhoneHealth health() {
        return health;
    }

    /** Name and port. */
    public PhoneSettings settings() {
        return settings;
    }

    /** Whether it is stopped on board. */
    public PhoneStop stop() {
        return stop;
    }

    /** Its key, and the bases that are paired with it. */
    public PhoneKeys keys() {
        return keys;
    }

    /** The boat's clock, in ms. */
    public long nowMs() {
        return clock.getAsLong();
    }

    /** Stops the motors at once, until {@link #release}. */
    public void stopNow() {
        try {
            stop.latch();
        } catch (IOException e) {
            listener.said("the stop cannot be kept over a restart: " + e.getMessage());
        }
        board.setMotors(0, 0);
        board.drive(0, 0, 0);
    }

    /** Lets the boat server drive the motors again. */
    public void release() {
        try {
            stop.release();
        } catch (IOException e) {
            listener.said("the stop cannot be released: " + e.getMessage());
        }
    }

    /**
     * Other settings of the hull from now on.
     *
     * @throws IOException if they cannot be kept; those before then stay
     */
    public void setHull(HullSettings hull) throws IOException {
        HullFile.write(files.hull(), hull);
        board.setHull(hull);
    }

    /** Drives motors for a test, unless the boat is stopped on board or commanded to move; whether it does. */
    public boolean drive(double port, double starboard, long forMs) {
        return !stop.isLatched() && board.drive(port, starboard, forMs);
    }

    /** How the boat is. */
    public PhoneStatus status() {
        Optional<Running> now = running;
        PhoneStatus.Serving serving = now.isPresent()
                ? PhoneStatus.Serving.SERVES
                : fault.isEmpty() ? PhoneStatus.Serving.WAITS_FOR_POSITION : PhoneStatus.Serving.FAILED;
        long nowMs = clock.getAsLong();
        return new PhoneStatus(
                settings,
                port(),
                serving,
                now.map(run -> run.mode),
                now.flatMap(run -> run.commandedBy),
                now.map(run -> run.tcp.clientCount()).orElse(0),
                keys,
                position.pose(nowMs),
                position.doubts(nowMs),
                board,
                health.batteryPercent(),
                troubles(),
                stop.isLatched());
    }

    /** What it announces on its network; empty while it does not serve. The charge is announced in steps of ten percent: each change is a new announcement. */
    public Optional<BoatAnnouncement> announcement() {
        if (!running.isPresent()) {
            return Optional.empty();
        }
        String hull = board.hull().kind().name().toLowerCase(Locale.ROOT);
        BoatAnnouncement boat =
                BoatAnnouncement.of(settings.name(), keys.own().shortText(), keys.access(clock.getAsLong()), hull);
        double percent = vehicle.batteryPercent();
        boolean known = percent >= 0 && percent <= 100;
        return Optional.of(known ? boat.withBattery(CHARGE_STEP * (int) (percent / CHARGE_STEP)) : boat);
    }

    /** The port on which it serves, or will. */
    private int port() {
        return running.map(run -> run.tcp.address().getPort()).orElse(settings.port());
    }

    private List<String> troubles() {
        List<String> troubles = new ArrayList<>(health.troubles());
        if (!fault.isEmpty()) {
            troubles.add(0, fault);
        }
        if (!camera.trouble().isEmpty()) {
            troubles.add("no pictures: " + camera.trouble());
        } else if (!camera.failure().isEmpty()) {
            troubles.add("the last picture was not taken: " + camera.failure());
        }
        return troubles;
    }

    /** Stops the motors, and ends all threads. */
    @Override
    public void close() throws IOException {
        closed = true;
        looking.cancel(false);
        starter.shutdown();
        try {
            starter.awaitTermination(RETRY_MS, TimeUnit.MILLISECONDS);
            if (running.isPresent()) {
                running.get().close();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            starter.shutdownNow();
            camera.close();
            board.close();
        }
    }

    /** The server with its log. */
    private final class Running implements TcpServerListener, ServerLog, Closeable {
        private final BoatServer boat;
        private final CommandLogFile log;
        private final TcpBoatServer tcp;
        private volatile BoatMode mode;
        private volatile Optional<String> commandedBy = Optional.empty();

        Running(Pose pose) throws IOException {
            LocalFrame home = BoatHome.of(files, pose.latDeg(), pose.lonDeg());
            double errorM = Math.max(LEAST_ERROR_M, pose.positionErrorM());
            ServerConfig config = ServerConfig.of(settings.name(), bootId)
                    .home(home.originLatDeg(), home.originLonDeg())
                    .fullThrustSpeedMps(
                            MotionDefaults.FULL_THRUST_SPEED_MPS * board.hull().safeMaximum())
                    .performance(board.hull().performance())
                    .trackingError(new TrackingError(errorM, USUAL_DRIFT_MPS))
                    .build();
            boat = new BoatServer(config, vehicle, this);
            mode = boat.mode();
            log = CommandLogFile.open(
                    new LogPlace(files.commandLog(), settings.logBytes()),
                    bootId,
                    LogEntries.restoring(boat),
                    health.logFaults());
            boat.restore(log.epoch());
            try {
                tcp = new TcpBoatServer(settings.name(), boat, links(), clock, this::beforeTick, this);
                tcp.start();
            } catch (IOException | RuntimeException e) {
                log.close();
                throw e;
            }
        }

        private TcpServerConfig links() {
            TcpServerConfig links = TcpServerConfig.on(new InetSocketAddress(address, settings.port()))
                    .withFiles(CommandLogFile.files(files.commandLog()).with(KeptFile.PICTURE, files.pictures()));
            return keys.areLinksOpen() ? links : links.withKeys(keys.ring(), keys.responder());
        }

        private void beforeTick(long nowMs) {
            mode = boat.mode();
            commandedBy = boat.commandedBy();
        }

        @Override
        public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
            log.answered(nowMs, clientId, command, answer);
        }

        @Override
        public void appointed(CommandEpoch epoch) {
            log.appointed(epoch);
        }

        @Override
        public void leftOut(long nowMs, long count) {
            log.leftOut(nowMs, count);
        }

        @Override
        public void failed(String what, Throwable cause) {
            listener.said(what + ": " + cause);
        }

        @Override
        public void recovered(String what) {
            listener.said(what);
        }

        @Override
        public void close() throws IOException {
            try {
                tcp.close();
            } finally {
                log.close();
            }
        }
    }

    /** Passes on what the board tells. */
    private final class Board implements BoardListener {
        @Override
        public void stateChanged(BoardState state, String why) {
            listener.said("board " + state + (why.isEmpty() ? "" : ": " + why));
        }

        @Override
        public void boardError(String error, String arguments) {
            listener.said("the board reports an error: " + error + " " + arguments);
        }

        @Override
        public void garbled(String line, long count) {
            listener.said("the board's lines are damaged (" + count + " so far): look at its cable");
        }
    }
}
