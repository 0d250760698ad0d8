package org.sami.crw.cli.board;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.UnaryOperator;
import org.sami.boat.hull.host.HullBoat;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;

/**
 * Runs a real boat until it is stopped.
 *
 * @param name the boat's name
 * @param address where its server listens
 * @param lostLink what it does when the link is lost
 * @param logFolder where its log is
 * @param logBytes most bytes of its log
 */
public record RealBoatRun(
        String name, InetSocketAddress address, LostLinkAction lostLink, Optional<Path> logFolder, long logBytes) {

    /** Waits until the run is to end. */
    public interface Waiter {
        /** Waits. */
        void await() throws InterruptedException;
    }

    /** What the server of the boat tells, and what else happens to it. */
    public interface Console extends TcpServerListener {
        /** Says something about the boat. */
        void say(String text);

        /** Warns of what a new server stands for. */
        void listening(InetSocketAddress address, int restored, int unreadLogLines);

        /** Opens what tells others of the boat while it serves; closed when it ends. */
        Closeable announce(InetSocketAddress address, String hull, DoubleSupplier batteryPercent);

        /** Opens what shows the boat to ground stations while it serves; closed when it ends. */
        Closeable show(HullBoat boat, SteadyClock clock);
    }

    /**
     * Opens board and GPS, waits for a position, and serves.
     *
     * @param links makes the boat's links
     * @throws IOException that says what cannot be had, and what to do
     */
    public void run(HullOptions options, PrintWriter out, Console console, LinkMaker links, Waiter waiter)
            throws IOException, InterruptedException {
        DevicePort board = options.board();
        DevicePort gps = options.gps();
        HullSettings hull = options.hull();
        double declinationRad = options.declinationRad();
        SteadyClock clock = SteadyClock.ofThisMachine();
        try (HullBoat boat = new HullBoat(name, hull, board.port(), gps.port(), gps.gpsd(), clock, console::say)) {
            DeviceOpening.open("--board", board, boat::openBoard);
            DeviceOpening.open("--gps", gps, boat::openGps);
            if (!Double.isNaN(declinationRad)) {
                boat.gps().setDeclination(declinationRad);
            }
            if (!hull.motorsChecked()) {
                console.say("its motors are not marked as checked in --hull: look that they push the right way");
            }
            out.printf("%s waits for a position%n", name);
            out.flush();
            boat.awaitPosition();
            Optional<LogPlace> log = logFolder.map(folder -> new LogPlace(folder.resolve(name + ".log"), logBytes));
            boat.serve(address, lostLink, log, console, links.make());
            console.listening(boat.address(), boat.restored(), boat.unreadLogLines());
            try (Closeable announcer = console.announce(
                            boat.address(), hull.kind().name().toLowerCase(Locale.ROOT), () -> charge(boat));
                    Closeable shown = console.show(boat, clock)) {
                waiter.await();
            }
        }
    }

    /** Percent; NaN where the board tells no voltage. */
    private static double charge(HullBoat boat) {
        return Double.isNaN(boat.vehicle().batteryVolts())
                ? Double.NaN
                : boat.vehicle().batteryPercent();
    }

    /** Makes the boat's links when it begins to serve: words to pair with are shown for a time. */
    public interface LinkMaker {
        /**
         * What makes the boat's links of plain ones.
         *
         * @throws IOException if keys cannot be read or written
         */
        UnaryOperator<TcpServerConfig> make() throws IOException;
    }
}
