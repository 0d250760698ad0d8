package org.sami.crw.cli.board;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.boat.hull.settings.HullFile;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.link.SteadyClock;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options of {@code crw boat} for a real boat: its control board and its GPS. */
public final class HullOptions {
    private static final int BOARD_BAUD = 115_200;
    private static final int GPS_BAUD = 9600;
    private static final double MOST_DECLINATION_DEG = 180;

    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--board",
            paramLabel = "PORT|HOST:PORT",
            description = "A real boat: the port of its control board, serial (/dev/ttyACM0, COM3; @BAUD behind it, "
                    + BOARD_BAUD + " if not given) or TCP. Needs --gps, and no --at.")
    private @Nullable String board;

    @Option(
            names = "--gps",
            paramLabel = "PORT|HOST:PORT|gpsd[:HOST:PORT]",
            description = "Its GPS receiver: NMEA 0183 on a serial port (@BAUD, " + GPS_BAUD
                    + " if not given) or TCP, or a gpsd. Its HDT, HDG or HDM sentences are the compass; without any,"
                    + " the heading is the course over ground.")
    private @Nullable String gps;

    @Option(
            names = "--hull",
            paramLabel = "FILE",
            description =
                    "The settings of the hull: kind, safe maximum, trim, reversed motors, battery (docs/board.md). "
                            + "Without it: two motors, 70 %% of full thrust.")
    private @Nullable Path hull;

    @Option(
            names = "--declination",
            paramLabel = "DEG",
            description = "Magnetic declination for a compass that shows magnetic north, in degrees to the east; "
                    + "otherwise what the receiver says.")
    private @Nullable Double declinationDeg;

    @Option(
            names = "--check-motors",
            description =
                    "Go through the guided check of the motors instead of serving: it drives each one, asks what was "
                            + "seen, and writes reversal, most thrust and trim to the file of --hull. Needs no --gps.")
    private boolean checkMotors;

    /** Whether the motors are to be checked instead of serving. */
    public boolean checksMotors() {
        return checkMotors;
    }

    /**
     * Goes through the guided check of the motors.
     *
     * @param in what the person types
     * @return whether it came to its end
     * @throws IOException that says why the board cannot be had, or the settings not be read or written
     */
    public boolean checkMotors(String name, BufferedReader in, PrintWriter out) throws IOException {
        Path file = Optional.ofNullable(hull)
                .orElseThrow(() -> unfit("--check-motors needs --hull FILE, into which it writes what was found"));
        HullSettings before = Files.exists(file)
                ? HullFile.read(file)
                : HullSettings.of(HullKind.DIFFERENTIAL).build();
        return new MotorCheckRun(name, in, out).run(board(), before, file, SteadyClock.ofThisMachine());
    }

    /** Whether a real boat is meant. */
    public boolean isReal() {
        return board != null;
    }

    /** Refuses what only a real boat has where none is meant. */
    public void refuseWithoutBoard() {
        if (gps != null || hull != null || declinationDeg != null || checkMotors) {
            throw unfit("--gps, --hull, --declination and --check-motors are for a real boat: give its --board too");
        }
    }

    DevicePort board() {
        return port("--board", board, text -> DevicePort.board(text, BOARD_BAUD));
    }

    DevicePort gps() {
        return port("--gps", gps, text -> DevicePort.gps(text, GPS_BAUD));
    }

    private DevicePort port(String option, @Nullable String text, Function<String, DevicePort> reader) {
        if (text == null) {
            throw unfit("a real boat needs its GPS: give --gps, a port, HOST:PORT or gpsd");
        }
        try {
            return reader.apply(text);
        } catch (IllegalArgumentException e) {
            throw unfit(option + ": " + e.getMessage());
        }
    }

    HullSettings hull() throws IOException {
        return hull == null ? HullSettings.of(HullKind.DIFFERENTIAL).build() : HullFile.read(hull);
    }

    double declinationRad() {
        if (declinationDeg == null) {
            return Double.NaN;
        }
        if (!(Math.abs(declinationDeg) <= MOST_DECLINATION_DEG)) {
            throw unfit("--declination: " + declinationDeg + " is not in -180 to 180");
        }
        return Math.toRadians(declinationDeg);
    }

    private ParameterException unfit(String text) {
        return new ParameterException(spec.commandLine(), text);
    }
}
