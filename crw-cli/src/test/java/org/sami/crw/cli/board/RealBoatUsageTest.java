package org.sami.crw.cli.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.sim.board.BoardOnTcp;
import org.sami.crw.sim.board.BoardSettings;
import org.sami.spn.value.GeoPoint;

/** What {@code crw boat --board} and {@code crw board} say of ports that are not there, and of wrong usage. */
@Timeout(900)
class RealBoatUsageTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    @TempDir
    private Path folder;

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    private static CommandResult boat(String options) {
        return CommandResult.crw(("boat --port 0 --name anna " + options).split(" "));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--board 127.0.0.1:5101 | a real boat needs its GPS: give --gps",
                "--gps gpsd --at 45.4,10.9 | --gps, --hull, --declination and --check-motors are for a real boat: give its --board too",
                "'' | a simulated boat needs --at, a real one --board and --gps",
                "--board 127.0.0.1:5101 --gps gpsd --at 45.4,10.9 | --at is for a simulated boat, not for one with --board",
                "--board 127.0.0.1:5101 --gps gpsd --seed 2 | --seed is for a simulated boat, not for one with --board",
                "--board 127.0.0.1:x --gps gpsd | --board: expected is HOST:PORT, or a serial port",
                "--board 127.0.0.1:70000 --gps gpsd | --board: expected is HOST:PORT",
                "--board /dev/ttyACM0@fast --gps gpsd | --board: expected is HOST:PORT",
                "--board 127.0.0.1:5101 --gps gpsd:here | --gps: expected is HOST:PORT",
                "--board 127.0.0.1:5101 --gps gpsd --declination 200 | --declination: 200.0 is not in -180 to 180"
            })
    void wrongUsageIsNamed(String options, String said) {
        CommandResult ran = boat(options);

        assertThat(ran.err()).contains(said);
        assertThat(ran.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void refusedBoardIsOneLineThatSaysWhatToDo() throws IOException {
        int port = freePort();

        CommandResult ran = boat("--board 127.0.0.1:" + port + " --gps gpsd");

        assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
        assertThat(ran.err().strip())
                .endsWith("127.0.0.1:" + port
                        + " (--board): connection refused; start what listens there, or name another port")
                .doesNotContain("\n");
    }

    @Test
    void missingSerialPortIsOneLineThatSaysWhatToDo() {
        CommandResult ran = boat("--board /dev/nosuchport --gps gpsd");

        assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
        assertThat(ran.err().strip())
                .contains("/dev/nosuchport (--board): there is no such port; plug it in and name its port (")
                .doesNotContain("\n");
    }

    @Test
    void refusedGpsIsNamedAfterTheBoardWasFound() throws IOException {
        BoardSettings settings = BoardSettings.at(GeoPoint.of(45.4, 10.9), 1);
        try (BoardOnTcp board = new BoardOnTcp(settings, ANY_PORT, ANY_PORT, SteadyClock.ofThisMachine(), news -> {})) {
            int port = freePort();

            CommandResult ran =
                    boat("--board 127.0.0.1:" + board.boardAddress().getPort() + " --gps gpsd:127.0.0.1:" + port);

            assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
            assertThat(ran.err())
                    .contains("127.0.0.1:" + port + " (--gps): connection refused; start gpsd, or name where it runs");
        }
    }

    @Test
    void hullFileWithAFaultIsNamed() throws IOException {
        Path hull = folder.resolve("hull.json");
        Files.writeString(hull, "{\"format\":\"sami-hull-1\",\"kind\":\"differential\",\"safeMaximum\":2}");

        CommandResult ran = boat("--board 127.0.0.1:1 --gps gpsd --hull " + hull);

        assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
        assertThat(ran.err()).contains(hull + ": /safeMaximum: the safe maximum is 0.1 to 1.0, not 2.0");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--port 0 | Missing required option: '--at=LAT,LON'",
                "--port 70000 --at 45.4,10.9 | a port is 0 to 65535, not 70000",
                "--port 0 --at 45.4,10.9 --lose 2 | the part of lost lines is 0 to 1, not 2.0",
                "--port 0 --at 45.4,10.9 --pull-every 5 --pull-for 9 | a cable is pulled every"
            })
    void wrongUsageOfTheBoardIsNamed(String options, String said) {
        CommandResult ran = CommandResult.crw(("board " + options).split(" "));

        assertThat(ran.err()).contains(said);
        assertThat(ran.exitCode()).isEqualTo(ExitCode.USAGE);
    }
}
