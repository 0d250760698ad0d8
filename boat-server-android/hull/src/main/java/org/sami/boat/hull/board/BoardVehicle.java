package org.sami.boat.hull.board;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.settings.MotorDrive;
import org.sami.boat.hull.stream.PortListener;
import org.sami.boat.hull.stream.ReconnectingPort;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * A hull with a control board, as the boat server's vehicle: motors, battery and sensors are the board's, the position is that of a {@link PositionFilter}.
 *
 * <p>The board is commanded ten times a second from a thread of its own, also with 0: a board that hears nothing disarms. While it is gone or silent, or the
 * boat server hangs, the motors are 0; when it is back, what the boat server commands then goes on. A board that is silent for {@link #REOPEN_MS}, or takes no
 * bytes for as long, has its port opened again. Safe for use by several threads.
 */
public final class BoardVehicle implements Vehicle, MotorDrive, Closeable {
    private static final long PERIOD_MS = 100;
    private static final long REOPEN_MS = 5000;
    private static final long GARBLED_SAID_MS = 10_000;
    private static final String BATTERY = "battery";

    private final MotorArbiter link;
    private final BoardSensors sensors = new BoardSensors();
    private final BatteryGauge battery = new BatteryGauge();
    private final PositionFilter position;
    private final SteadyClock clock;
    private final BoardListener listener;
    private final ReconnectingPort port;
    private final ScheduledExecutorService threads;
    private final String portName;
    private volatile String lostWhy = "not opened yet";
    private volatile long sendingSinceMs = Long.MAX_VALUE; // while bytes wait to be taken
    private volatile long openedMs;
    private volatile Future<?> sending = CompletableFuture.completedFuture(null);
    private volatile Future<?> watching = CompletableFuture.completedFuture(null);
    private long garbledSaidMs = Long.MIN_VALUE / 2; // these two for the port's thread
    private long garbled;
    private Pose pose = Pose.UNKNOWN; // these two for the server's thread
    private long poseMs = Long.MIN_VALUE;

    /** A vehicle whose board is not opened yet. */
    public BoardVehicle(
            HullSettings hull, PositionFilter position, StreamPort board, SteadyClock clock, BoardListener listener) {
        link = new MotorArbiter(hull);
        this.position = Objects.requireNonNull(position, "position");
        this.clock = Objects.requireNonNull(clock, "clock");
        this.listener = Objects.requireNonNull(listener, "listener");
        portName = board.name();
        port = new ReconnectingPort(board, BoardLines.MAX_BYTES, new Port());
        threads = Executors.newScheduledThreadPool(2, work -> {
            Thread thread = new Thread(work, portName + "-commands");
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Opens the board's port once, to see whether it is there; not needed before {@link #start}.
     *
     * @throws IOException that says why it is not
     */
    public void openFirst() throws IOException {
        port.openFirst();
    }

    /** Begins to command the board; once only. */
    public void start() {
        port.start();
        sending = threads.scheduleWithFixedDelay(this::sendMotors, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
        watching = threads.scheduleWithFixedDelay(this::watch, PERIOD_MS, PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    private void sendMotors() {
        try {
            long nowMs = clock.getAsLong();
            sendingSinceMs = nowMs;
            port.send(BoardCommands.motors(link.hull().kind(), link.motors(nowMs)));
        } catch (IOException | RuntimeException gone) {
            // the port's thread notices it, and says so; a library of ports may fail in its own way, and the next
            // command is due all the same
        } finally {
            sendingSinceMs = Long.MAX_VALUE;
        }
    }

    private void watch() {
        try {
            look(clock.getAsLong());
        } catch (RuntimeException e) {
            listener.boardError("the watch of the board failed", e.toString());
        }
    }

    private void look(long nowMs) {
        Optional<BoardState> change = link.change(nowMs);
        if (change.isPresent()) {
            listener.stateChanged(change.get(), why(change.get()));
        }
        if (nowMs - sendingSinceMs > REOPEN_MS) {
            port.reopen("it takes no commands");
        } else if (link.state() == BoardState.SILENT && Math.min(nowMs - openedMs, link.silentMs(nowMs)) > REOPEN_MS) {
            openedMs = nowMs;
            port.reopen("it was silent for " + REOPEN_MS / 1000 + " s");
        }
        double[] efforts = link.efforts(nowMs);
        double turn = (efforts[0] - efforts[1]) / 2 * link.hull().turnRateRadPerS();
        position.motors((efforts[0] + efforts[1]) / 2, turn, nowMs);
    }

    private String why(BoardState state) {
        switch (state) {
            case GONE:
                return lostWhy;
            case SILENT:
                return "it says nothing that can be read";
            default:
                return "";
        }
    }

    /** What the port tells. */
    private final class Port implements PortListener, BoardLines.Reader {
        private final BoardLines lines = new BoardLines(this);

        @Override
        public void opened() {
            openedMs = clock.getAsLong();
            link.opened(openedMs);
        }

        @Override
        public void line(String line) {
            if (lines.read(line)) {
                link.heard(clock.getAsLong());
            }
        }

        @Override
        public void lost(String why) {
            lostWhy = why;
            link.lost();
        }

        @Override
        public void motor(int number, double velocity) {
            // what the motors do is seen in how the hull moves
        }

        @Override
        public void sensor(String slot, String type, String data) {
            boolean read =
                    type.equals(BATTERY) ? battery.take(BoardSensors.word(data, 0)) : sensors.take(slot, type, data);
            if (!read) {
                garbled(slot + " " + type + ": " + data);
            }
        }

        @Override
        public void error(String error, String arguments) {
            listener.boardError(error, arguments);
        }

        @Override
        public void garbled(String line) {
            garbled++;
            long nowMs = clock.getAsLong();
            if (nowMs - garbledSaidMs >= GARBLED_SAID_MS) {
                garbledSaidMs = nowMs;
                listener.garbled(line, garbled);
            }
        }
    }

    /** How the link to the board is. */
    public BoardState boardState() {
        return link.state();
    }

    @Override
    public Optional<BoardCondition> board() {
        switch (link.state()) {
            case CONNECTED:
                return Optional.of(BoardCondition.WORKING);
            case SILENT:
                return Optional.of(BoardCondition.SILENT);
            default:
                return Optional.of(BoardCondition.GONE);
        }
    }

    /** Why the board is not there, in words for people; empty while it is. */
    public String boardTrouble() {
        return why(link.state());
    }

    /** The settings in force. */
    public HullSettings hull() {
        return link.hull();
    }

    /** Other settings from now on. */
    public void setHull(HullSettings hull) {
        link.setHull(Objects.requireNonNull(hull, "hull"));
    }

    /** Mean voltage of the battery; NaN as long as the board has not reported it. */
    public double batteryVolts() {
        return battery.volts();
    }

    /** Triggers the sampler on the board. */
    public void takeSample() throws IOException {
        port.send(BoardCommands.sample());
    }

    @Override
    public double latDeg() {
        return pose().latDeg();
    }

    @Override
    public double lonDeg() {
        return pose().lonDeg();
    }

    @Override
    public double headingRad() {
        return pose().headingRad();
    }

    @Override
    public double speedMps() {
        return pose().speedMps();
    }

    private synchronized Pose pose() {
        long nowMs = clock.getAsLong();
        if (nowMs != poseMs) {
            poseMs = nowMs;
            pose = position.pose(nowMs);
        }
        return pose;
    }

    @Override
    public double batteryPercent() {
        return battery.percent(link.hull().battery());
    }

    @Override
    public List<Sensor> sensors() {
        return sensors.all();
    }

    @Override
    public void setMotors(double portEffort, double starboardEffort) {
        link.command(portEffort, starboardEffort, clock.getAsLong());
    }

    @Override
    public boolean drive(double portEffort, double starboardEffort, long forMs) {
        long nowMs = clock.getAsLong();
        return link.state() == BoardState.CONNECTED && link.test(portEffort, starboardEffort, nowMs, nowMs + forMs);
    }

    /** Ends all threads, with a last command of 0 where the board takes it. */
    @Override
    public void close() {
        link.lost(); // nothing but 0 from now on
        link.change(clock.getAsLong());
        sending.cancel(false);
        watching.cancel(false);
        sendMotors();
        threads.shutdownNow();
        port.close();
    }
}
