package org.sami.crw.cli.board;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.option.ConditionsOptions;
import org.sami.crw.cli.option.PositionConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.sim.board.BoardFaults;
import org.sami.crw.sim.board.BoardOnTcp;
import org.sami.crw.sim.board.BoardSettings;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code crw board}: a simulated control board with a hull and a GPS receiver, until it is stopped. */
@Command(
        name = "board",
        mixinStandardHelpOptions = true,
        description =
                "Runs a simulated control board on TCP, with a simulated hull behind it and the hull's GPS receiver on "
                        + "another port: 'crw boat --board' drives it. Runs until Ctrl-C or a signal ends it.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"2:wrong usage", "4:a port is not available", "130:stopped by Ctrl-C", "143:stopped by a signal"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw board --port 5101 --gps-port 5102 --at 45.4,10.9",
            "  crw board --port 5101 --gps-port 5102 --at 45.4,10.9 --gps-noise 1 --pull-every 60 --pull-for 5",
            "  crw boat --port 5001 --name anna --board 127.0.0.1:5101 --gps 127.0.0.1:5102   drives it"
        })
public final class BoardCommand implements Callable<Integer> {
    private static final int MAX_PORT = 65_535;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--port",
            required = true,
            paramLabel = "P",
            description = "The board's port; 0 takes a free one, which is printed.")
    private int port;

    @Option(
            names = "--gps-port",
            paramLabel = "P",
            defaultValue = "0",
            description = "The port of its GPS receiver, NMEA 0183; 0, as by default, takes a free one.")
    private int gpsPort;

    @Option(
            names = "--at",
            required = true,
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description = "Where the hull lies at the start, in degrees (WGS 84).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private GeoPoint at;

    @Option(
            names = "--kind",
            paramLabel = "KIND",
            defaultValue = "differential",
            description = "The hull: differential (a motor on each side) or rudder (default ${DEFAULT-VALUE}).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private HullKind kind;

    @Option(names = "--no-compass", description = "Its receiver sends no headings.")
    private boolean noCompass;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Where chance comes from (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--field-seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "What there is to be measured (default ${DEFAULT-VALUE}).")
    private long fieldSeed;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ConditionsOptions conditions;

    @Option(
            names = "--lose",
            paramLabel = "PART",
            defaultValue = "0",
            description = "Part of the lines, either way, that is lost, 0 to 1 (default ${DEFAULT-VALUE}).")
    private double lose;

    @Option(
            names = "--garble",
            paramLabel = "PART",
            defaultValue = "0",
            description = "Part of its lines of which a piece is missing, 0 to 1 (default ${DEFAULT-VALUE}).")
    private double garble;

    @Option(
            names = "--pull-every",
            paramLabel = "S",
            defaultValue = "0",
            description = "Pull its cable so often, in seconds; 0: never (default ${DEFAULT-VALUE}).")
    private double pullEveryS;

    @Option(
            names = "--pull-for",
            paramLabel = "S",
            defaultValue = "0",
            description = "Put it back after so many seconds (default ${DEFAULT-VALUE}).")
    private double pullForS;

    @Override
    public Integer call() throws IOException {
        BoardSettings settings = settings();
        PrintWriter out = spec.commandLine().getOut();
        InetAddress here = InetAddress.getLoopbackAddress();
        try (StopOnInterrupt stop = new StopOnInterrupt();
                BoardOnTcp board = new BoardOnTcp(
                        settings,
                        new InetSocketAddress(here, port),
                        new InetSocketAddress(here, gpsPort),
                        SteadyClock.ofThisMachine(),
                        this::say)) {
            out.printf(
                    "board on 127.0.0.1:%d, GPS on 127.0.0.1:%d%n",
                    board.boardAddress().getPort(), board.gpsAddress().getPort());
            out.flush();
            new CountDownLatch(1).await(); // until somebody stops the process
        } catch (InterruptedException e) {
            out.println("the board stops");
            out.flush();
        }
        return ExitCode.OK;
    }

    private void say(String text) {
        PrintWriter err = spec.commandLine().getErr();
        synchronized (err) {
            err.println("board: " + text);
            err.flush();
        }
    }

    private BoardSettings settings() {
        for (int each : new int[] {port, gpsPort}) {
            if (each < 0 || each > MAX_PORT) {
                throw new ParameterException(spec.commandLine(), "a port is 0 to " + MAX_PORT + ", not " + each);
            }
        }
        try {
            BoardFaults faults = new BoardFaults(lose, garble, pullEveryS, pullForS);
            return new BoardSettings(
                    at, seed, kind, HullConfig.DEFAULT, conditions.conditions(), fieldSeed, !noCompass, faults);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }
}
