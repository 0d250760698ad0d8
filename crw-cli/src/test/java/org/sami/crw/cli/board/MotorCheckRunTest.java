package org.sami.crw.cli.board;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.hull.settings.HullFile;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.sim.board.BoardFaults;
import org.sami.crw.sim.board.BoardOnTcp;
import org.sami.crw.sim.board.BoardSettings;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoPoint;

/** The check of the motors in a terminal, on a simulated board: what a person types becomes the hull's file. */
@Timeout(900)
class MotorCheckRunTest {
    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();

    private static BoardOnTcp board(HullKind kind) throws IOException {
        BoardSettings settings = new BoardSettings(
                GeoPoint.of(45.4, 10.9), 1, kind, HullConfig.DEFAULT, Conditions.CALM, 1, true, BoardFaults.NONE);
        InetSocketAddress free = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        return new BoardOnTcp(settings, free, free, SteadyClock.ofThisMachine(), text -> {});
    }

    private boolean check(InetSocketAddress board, HullKind kind, String typed) throws IOException {
        DevicePort port = DevicePort.board("127.0.0.1:" + board.getPort(), 115_200);
        HullSettings hull = HullSettings.of(kind).build();
        return new MotorCheckRun("anna", new BufferedReader(new StringReader(typed)), new PrintWriter(out))
                .run(port, hull, file(), SteadyClock.ofThisMachine());
    }

    private Path file() {
        return folder.resolve("anna.json");
    }

    @Test
    void answersBecomeTheFileOfTheHull() throws Exception {
        try (BoardOnTcp board = board(HullKind.DIFFERENTIAL)) {
            boolean done = check(board.boardAddress(), HullKind.DIFFERENTIAL, "\n2\n\n1\n\n1\n\n2\n\n3\n\n1\n");

            assertThat(done).isTrue();
        }
        HullSettings found = HullFile.read(file());
        assertThat(found.leftReversed()).isTrue();
        assertThat(found.rightReversed()).isFalse();
        assertThat(found.safeMaximum()).isEqualTo(0.4);
        assertThat(found.trim()).isEqualTo(-0.03);
        assertThat(found.motorsChecked()).isTrue();
        assertThat(out.toString())
                .contains("thrust at 30 % of full", "Most thrust 40 %, trim -3 %, left motor reversed. Written to");
    }

    @Test
    void rudderHullIsAskedOfItsRudderAndNoOtherSide() throws Exception {
        try (BoardOnTcp board = board(HullKind.RUDDER)) {
            assertThat(check(board.boardAddress(), HullKind.RUDDER, "\n1\n\n2\n4\n4\n"))
                    .isTrue();
        }
        assertThat(HullFile.read(file()).rudderReversed()).isFalse();
        assertThat(HullFile.read(file()).safeMaximum()).as("left for later").isEqualTo(0.7);
        assertThat(out.toString()).doesNotContain("other side");
    }

    @Test
    void checkThatIsLeftOrWhoseInputEndsWritesNothing() throws Exception {
        try (BoardOnTcp board = board(HullKind.DIFFERENTIAL)) {
            assertThat(check(board.boardAddress(), HullKind.DIFFERENTIAL, "\n2\n\n1\nq\n"))
                    .isFalse();
            assertThat(check(board.boardAddress(), HullKind.DIFFERENTIAL, "\n2\n"))
                    .isFalse();
        }
        assertThat(Files.exists(file())).isFalse();
        assertThat(out.toString()).contains("The check is left");
    }

    @Test
    void nothingIsAnsweredThatWasNotDriven() throws Exception {
        try (BoardOnTcp board = board(HullKind.DIFFERENTIAL)) {
            check(board.boardAddress(), HullKind.DIFFERENTIAL, "1\n9\nx\nq\n");
        }
        assertThat(out.toString()).contains("Drive it first: Enter.", "'9' is none of these.", "'x' is none of these.");
    }

    @Test
    void boardThatSaysNothingIsSaid() throws Exception {
        try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            assertThatThrownBy(
                            () -> check((InetSocketAddress) silent.getLocalSocketAddress(), HullKind.DIFFERENTIAL, ""))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("it says nothing that can be read");
        }
    }
}
