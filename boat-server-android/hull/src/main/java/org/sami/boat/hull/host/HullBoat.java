package org.sami.boat.hull.host;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.UnaryOperator;
import org.sami.boat.hull.board.BoardListener;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.board.BoardVehicle;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionDoubt;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.file.BoatFiles;
import org.sami.boat.server.log.CommandLogFile;
import org.sami.boat.server.log.LogEntries;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.boat.server.tcp.LogFaultReports;
import org.sami.boat.server.tcp.TcpBoatServer;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;

/**
 * A real boat on a laptop or a small computer: board and GPS on ports, the boat server on a TCP port, and its log. Its server begins once it knows where it
 * is, as that is its home. Safe for use by several threads.
 */
public final class HullBoat implements Closeable {
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    private static final long COMPASS_WAIT_MS = 3000;
    private static final long BATTERY_WAIT_MS = 3000;
    private static final double LEAST_ERROR_M = 1;
    private static final double USUAL_DRIFT_MPS = 0.2;

    private final String name;
    private final HullNews news;
    private final SteadyClock clock;
    private final PositionFilter filter = new PositionFilter();
    private final BoardVehicle vehicle;
    private final GpsSource gps;
    private final String boardName;
    private final String bootId = UUID.randomUUID().toString();
    private Set<PositionDoubt> doubts = EnumSet.noneOf(PositionDoubt.class); // for the server's thread
    private Optional<CommandLogFile> log = Optional.empty();
    private Optional<TcpBoatServer> server = Optional.empty();

    /**
     * A boat whose ports are not open yet.
     *
     * @param gpsd whether the GPS port leads to a gpsd, instead of to NMEA sentences
     */
    public HullBoat(
            String name,
            HullSettings hull,
            StreamPort board,
            StreamPort gpsPort,
            boolean gpsd,
            SteadyClock clock,
            HullNews news) {
        this.name = name;
        this.news = news;
        this.clock = clock;
        boardName = board.name();
        vehicle = new BoardVehicle(hull, filter, board, clock, new Board());
        gps = gpsd ? GpsSource.gpsd(gpsPort, filter, clock, news) : GpsSource.nmea(gpsPort, filter, clock, news);
    }

    /** The receiver, to set what it cannot know. */
    public GpsSource gps() {
        return gps;
    }

    /** The hull. */
    public BoardVehicle vehicle() {
        return vehicle;
    }

    /**
     * Opens the board's port and begins to command it.
     *
     * @throws IOException that says why it cannot be had
     */
    public void openBoard() throws IOException {
        vehicle.openFirst();
        vehicle.start();
    }

    /**
     * Opens the receiver's port and begins to read it.
     *
     * @throws IOException that says why it cannot be had
     */
    public void openGps() throws IOException {
        gps.openFirst();
        gps.start();
    }

    /** Waits until the boat knows where it is, and its charge where the board tells it. Without a compass it assumes that it points north. */
    public void awaitPosition() throws InterruptedException {
        long locatedMs = Long.MIN_VALUE;
        boolean ready = false;
        while (!ready) {
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
            LockSupport.parkNanos(LOOK_NANOS);
            long nowMs = clock.getAsLong();
            Pose pose = filter.pose(nowMs);
            if (!pose.isLocated()) {
                locatedMs = Long.MIN_VALUE;
                continue;
            }
            locatedMs = locatedMs == Long.MIN_VALUE ? nowMs : locatedMs;
            if (!pose.isComplete() && nowMs - locatedMs >= COMPASS_WAIT_MS) {
                filter.assumeHeading();
            }
            boolean charged = !Double.isNaN(vehicle.batteryVolts()) || nowMs - locatedMs >= BATTERY_WAIT_MS;
            ready = pose.isComplete() && charged;
        }
        if (Double.isNaN(vehicle.batteryVolts())) {
            news.say("the board tells no battery voltage: the charge counts as 0 %");
        }
    }

    /**
     * Begins to serve; after {@link #awaitPosition}.
     *
     * @param logPlace continued where it is there: the boat knows what it has executed, and does not move before a new command
     * @throws IOException if the port or the log cannot be had
     */
    public void serve(
            InetSocketAddress address, LostLinkAction lostLink, Optional<LogPlace> logPlace, TcpServerListener listener)
            throws IOException {
        serve(address, lostLink, logPlace, listener, UnaryOperator.identity());
    }

    /**
     * Begins to serve with links of the caller's choice, such as protected ones; after {@link #awaitPosition}.
     *
     * @throws IOException if the port or the log cannot be had
     */
    public void serve(
            InetSocketAddress address,
            LostLinkAction lostLink,
            Optional<LogPlace> logPlace,
            TcpServerListener listener,
            UnaryOperator<TcpServerConfig> links)
            throws IOException {
        double errorM = Math.max(LEAST_ERROR_M, filter.pose(clock.getAsLong()).positionErrorM());
        ServerConfig config = ServerConfig.of(name, bootId)
                .lostLinkAction(lostLink)
                .fullThrustSpeedMps(
                        MotionDefaults.FULL_THRUST_SPEED_MPS * vehicle.hull().safeMaximum())
                .performance(vehicle.hull().performance())
                .trackingError(new TrackingError(errorM, USUAL_DRIFT_MPS))
                .build();
        ServerLog toFile = new FileLog();
        BoatServer boat = new BoatServer(config, vehicle, toFile);
        if (logPlace.isPresent()) {
            log = Optional.of(openLog(logPlace.get(), boat, listener));
            boat.restore(log.get().epoch());
        }
        BoatFiles files =
                logPlace.map(place -> CommandLogFile.files(place.file())).orElseGet(BoatFiles::none);
        TcpServerConfig tcpConfig = links.apply(TcpServerConfig.on(address).withFiles(files));
        TcpBoatServer tcp = new TcpBoatServer(name, boat, tcpConfig, clock, this::tellDoubts, listener);
        server = Optional.of(tcp);
        tcp.start();
    }

    private CommandLogFile openLog(LogPlace place, BoatServer boat, TcpServerListener listener) throws IOException {
        place.makeFolder();
        return CommandLogFile.open(
                place, bootId, LogEntries.restoring(boat), new LogFaultReports(place.file(), listener));
    }

    /** Writes what was answered to the file, where there is one. */
    private final class FileLog implements ServerLog {
        @Override
        public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
            log.ifPresent(file -> file.answered(nowMs, clientId, command, answer));
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

    private void tellDoubts(long nowMs) {
        Set<PositionDoubt> now = filter.doubts(nowMs);
        if (!now.equals(doubts)) {
            for (PositionDoubt doubt : now) {
                if (!doubts.contains(doubt)) {
                    news.say(words(doubt));
                }
            }
            for (PositionDoubt doubt : doubts) {
                if (!now.contains(doubt)) {
                    news.say("over: " + doubt.words());
                }
            }
            doubts = now;
        }
    }

    private String words(PositionDoubt doubt) {
        return doubt == PositionDoubt.COMPASS_DISAGREES
                ? doubt.words() + " by " + Math.round(Math.toDegrees(Math.abs(filter.disagreementRad())))
                        + "°: keep iron and motors away from the compass, and look how it is mounted"
                : doubt.words();
    }

    /** Where it listens, with the port that it got. */
    public InetSocketAddress address() {
        return serving().address();
    }

    private TcpBoatServer serving() {
        return server.orElseThrow(() -> new IllegalStateException("it does not serve yet"));
    }

    /** Has something work with the boat's server from now on, until it is detached or the boat ends; after {@link #serve}. */
    public void attach(BoatCompanion companion) {
        serving().attach(companion);
    }

    /** Ends what {@link #attach} began. */
    public void detach(BoatCompanion companion) {
        serving().detach(companion);
    }

    /** How many commands of earlier starts the boat knows from its log. */
    public int restored() {
        return log.map(CommandLogFile::restored).orElse(0);
    }

    /** How many lines of the log are damaged; their content is lost. */
    public int unreadLogLines() {
        return log.map(CommandLogFile::unreadLines).orElse(0);
    }

    /** What the board tells, in words. */
    private final class Board implements BoardListener {
        private boolean wasThere;

        @Override
        public void stateChanged(BoardState state, String why) {
            switch (state) {
                case CONNECTED:
                    news.say("board " + boardName + (wasThere ? " is back" : " reports"));
                    wasThere = true;
                    break;
                case SILENT:
                    if (wasThere) {
                        news.say("board " + boardName + " is silent: motors 0; look at its power and its cable");
                    }
                    break;
                default:
                    news.say("board " + boardName + " is gone (" + why
                            + "): motors 0; plug it in again; it is tried every second");
                    break;
            }
        }

        @Override
        public void boardError(String error, String arguments) {
            news.say("the board reports an error: " + (error + " " + arguments).trim());
        }

        @Override
        public void garbled(String line, long count) {
            news.say("the board's lines are damaged (" + count + " so far): look at its cable");
        }
    }

    @Override
    public void close() throws IOException {
        try {
            if (server.isPresent()) {
                server.get().close();
            }
        } finally {
            vehicle.close();
            gps.close();
            if (log.isPresent()) {
                log.get().close();
            }
        }
    }
}
