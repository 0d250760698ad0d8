package org.sami.crw.sim.board;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.sim.hull.SimulatedHull;

/**
 * A simulated board on one TCP port, and the receiver of its hull on another. The board has one cable: a new connection takes the place of the old one. All of
 * it moves on one thread, in the time of this machine. Safe for use by several threads.
 */
public final class BoardOnTcp implements Closeable {
    private static final long STEP_MS = 50;
    private static final int RECEIVER_CLIENTS = 8;
    private static final String END = "\r\n";

    private final SimulatedBoard board;
    private final SimulatedReceiver receiver;
    private final BoardFaults faults;
    private final SplittableRandom random;
    private final SteadyClock clock;
    private final Consumer<String> news;
    private final LineServer cable;
    private final LineServer gps;
    private final ScheduledExecutorService thread;
    private final Future<?> steps;
    private final long startMs;
    private boolean pulled; // these for the board's thread
    private boolean pulledByHand;

    /**
     * Begins to listen and to move.
     *
     * @param news receives what happens to the cable, in words
     * @throws IOException if a port cannot be had
     */
    public BoardOnTcp(
            BoardSettings settings,
            InetSocketAddress boardAddress,
            InetSocketAddress gpsAddress,
            SteadyClock clock,
            Consumer<String> news)
            throws IOException {
        board = new SimulatedBoard(settings);
        receiver = new SimulatedReceiver(board.instruments(), settings.hasCompass());
        faults = settings.faults();
        random = new SplittableRandom(settings.seed() ^ 0x6361626cL);
        this.clock = clock;
        this.news = news;
        startMs = clock.getAsLong();
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "board");
            made.setDaemon(true);
            return made;
        });
        cable = new LineServer("board-cable", boardAddress, 1, SimulatedBoard.MAX_LINE_BYTES, this::received);
        try {
            gps = new LineServer("board-gps", gpsAddress, RECEIVER_CLIENTS, SimulatedBoard.MAX_LINE_BYTES, line -> {});
        } catch (IOException e) {
            cable.close();
            throw e;
        }
        steps = thread.scheduleAtFixedRate(this::step, 0, STEP_MS, TimeUnit.MILLISECONDS);
    }

    /** Where the board listens. */
    public InetSocketAddress boardAddress() {
        return cable.address();
    }

    /** Where the receiver listens. */
    public InetSocketAddress gpsAddress() {
        return gps.address();
    }

    private void received(String line) {
        if (!thread.isShutdown()) {
            thread.execute(() -> {
                if (!isLost()) {
                    board.take(line, clock.getAsLong());
                }
            });
        }
    }

    private boolean isLost() {
        return faults.lossPart() > 0 && random.nextDouble() < faults.lossPart();
    }

    private void step() {
        long nowMs = clock.getAsLong();
        pull(nowMs);
        if (cable.hasClients()) {
            board.powered(nowMs);
        }
        board.pass(nowMs);
        for (String line : board.lines(nowMs)) {
            if (!isLost()) {
                cable.send((damaged(line) + END).getBytes(StandardCharsets.US_ASCII));
            }
        }
        List<String> sentences = receiver.sentences(nowMs);
        gps.send(String.join("", sentences).getBytes(StandardCharsets.US_ASCII));
    }

    private String damaged(String line) {
        if (faults.garblePart() == 0 || random.nextDouble() >= faults.garblePart()) {
            return line;
        }
        int from = random.nextInt(line.length());
        int to = from + 1 + random.nextInt(line.length() - from);
        return line.substring(0, from) + line.substring(to);
    }

    private void pull(long nowMs) {
        double atS = (nowMs - startMs) / 1000.0;
        boolean byPlan =
                faults.pullEveryS() > 0 && atS >= faults.pullEveryS() && atS % faults.pullEveryS() < faults.pullForS();
        setPulled(byPlan || pulledByHand);
    }

    private void setPulled(boolean now) {
        if (now != pulled) {
            pulled = now;
            cable.setRefusing(now);
            news.accept(now ? "the cable is pulled" : "the cable is put back");
        }
    }

    /** Pulls the board's cable. */
    public void pullCable() {
        thread.execute(() -> pulledByHand = true);
    }

    /** Puts the board's cable back. */
    public void putBackCable() {
        thread.execute(() -> pulledByHand = false);
    }

    /** Where the hull truly is and what its motors do, as one line. */
    public String truth() throws InterruptedException {
        return ask(() -> {
            SimulatedHull hull = board.hull();
            return String.format(
                    Locale.ROOT,
                    "%.6f,%.6f  %.0f°  %.2f m/s  %.0f %%  %s",
                    hull.latDeg(),
                    hull.lonDeg(),
                    Math.toDegrees(hull.headingRad()),
                    hull.speedMps(),
                    hull.batteryPercent(),
                    board.isArmed(clock.getAsLong()) ? "armed" : "not armed");
        });
    }

    /** True speed of the hull along its heading in m/s. */
    public double speedMps() throws InterruptedException {
        return ask(() -> board.hull().speedMps());
    }

    private <T> T ask(Callable<T> question) throws InterruptedException {
        try {
            return thread.submit(question).get();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        }
    }

    @Override
    public void close() throws IOException {
        steps.cancel(true);
        thread.shutdownNow();
        cable.close();
        gps.close();
    }
}
