package org.sami.boat.server.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.BoatServerDefaults;

class CommandLogFileTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.12345678901234, 10, 1.5));

    @TempDir
    private Path folder;

    private Path file() {
        return folder.resolve("boat1.log");
    }

    private LogPlace place() {
        return new LogPlace(file(), BoatServerDefaults.LOG_BYTES);
    }

    private CommandLogFile open(String bootId, List<LoggedCommand> earlier) throws IOException {
        return CommandLogFile.open(place(), bootId, earlier::add, new NoFaults());
    }

    private List<LoggedCommand> read() throws IOException {
        List<LoggedCommand> entries = new ArrayList<>();
        LogLines.read(file(), entries::add);
        return entries;
    }

    @Test
    void givesBackWhoCommandedLast() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            assertThat(log.epoch().number()).isZero();
            log.appointed(new CommandEpoch(6, "a.0", "a"));
        }
        try (CommandLogFile log = open("b2", new ArrayList<>())) {
            assertThat(log.epoch().number()).isEqualTo(6);
            assertThat(log.epoch().session()).isEqualTo("a.0");
            log.appointed(new CommandEpoch(8, "b.0", "Base von Jürgen"));
        }
        try (CommandLogFile log = open("b3", new ArrayList<>())) {
            assertThat(log.epoch().number()).isEqualTo(8);
            assertThat(log.epoch().clientId()).isEqualTo("Base von Jürgen");
        }
    }

    @Test
    void damagedNumberOfTheLastTakeOverIsNotForgottenInSilence() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.appointed(new CommandEpoch(6, "a.0", "a"));
        }
        Path kept = folder.resolve("boat1.log.epoch");
        Files.writeString(kept, Files.readString(kept).replace("6", "7"));

        assertThatThrownBy(() -> open("b2", new ArrayList<>()))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("boat1.log.epoch is damaged");
    }

    @Test
    void givesBackWhatEarlierStartsHaveExecuted() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.answered(12, "base", new UploadWaypoints("u\t1\n", "l", PATH), new Ack("u\t1\n"));
            log.answered(13, "base", new StopMotors("s"), new Nack("s", NackReason.STALE, "zu spät"));
        }
        List<LoggedCommand> earlier = new ArrayList<>();
        open("b2", earlier).close();

        assertThat(earlier).hasSize(2);
        assertThat(earlier.get(0).bootId()).isEqualTo("b1");
        assertThat(earlier.get(0).timeMs()).isEqualTo(12);
        assertThat(earlier.get(0).command().commandId()).isEqualTo("u\t1\n");
        assertThat(((UploadWaypoints) earlier.get(0).command()).waypoints()).isEqualTo(PATH);
        assertThat(((Nack) earlier.get(1).answer()).detail()).isEqualTo("zu spät");
        assertThat(Files.readAllLines(file())).hasSize(4);
    }

    @Test
    void everyCutOffLastLineIsTakenAwayAndWritingGoesOn() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.answered(1, "base", new StopMotors("s1"), new Ack("s1"));
            log.answered(2, "base", new StopMotors("s2"), new Ack("s2"));
        }
        byte[] whole = Files.readAllBytes(file());
        int cuts = 0;
        for (int length = whole.length - 1; length > 0; length--) {
            Files.write(file(), Arrays.copyOf(whole, length));
            List<LoggedCommand> earlier = new ArrayList<>();
            try (CommandLogFile log = open("b2", earlier)) {
                log.answered(3, "base", new StopMotors("s3"), new Ack("s3"));
            }
            List<LoggedCommand> now = read();
            assertThat(now).hasSize(earlier.size() + 1);
            assertThat(now.get(now.size() - 1).command().commandId()).isEqualTo("s3");
            cuts++;
        }
        assertThat(cuts).isGreaterThan(100);
    }

    @Test
    void damagedLineSaysNothingAndTheOthersStay() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.answered(1, "base", new StopMotors("first"), new Ack("first"));
            log.answered(2, "base", new StopMotors("second"), new Ack("second"));
        }
        String text = Files.readString(file());
        Files.writeString(file(), text.replace("\"first\"", "\"fisrt\""));

        assertThat(read()).extracting(entry -> entry.command().commandId()).containsExactly("second");
        try (CommandLogFile log = open("b2", new ArrayList<>())) {
            assertThat(log.unreadLines()).isEqualTo(1);
        }
    }

    @Test
    void clientOfEachCommandIsGivenBackWhateverItsNameIs() throws IOException {
        String odd = "base\t2 \n+%é\u4e2d";
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.answered(1, odd, new StopMotors("s"), new Ack("s"));
        }

        assertThat(read()).extracting(LoggedCommand::clientId).containsExactly(odd);
    }

    @Test
    void linesOfEarlierVersionsWhichNameNoClientAreRead() throws IOException {
        String earlier =
                "c6777dea\t12\tb1\t{\"type\":\"stop\",\"seq\":0,\"command\":\"s\"}\t{\"type\":\"ack\",\"seq\":0,\"command\":\"s\"}\n";
        Files.writeString(file(), earlier);

        assertThat(read()).singleElement().satisfies(entry -> {
            assertThat(entry.clientId()).isEmpty();
            assertThat(entry.command()).isInstanceOf(StopMotors.class);
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"a letter to somebody", "two\nlines\n", "12345678 no tab\n", "\u0000\u0001\u0002"})
    void fileThatIsNoLogIsRefusedAndStaysAsItIs(String text) throws IOException {
        Files.writeString(file(), text);

        assertThatThrownBy(() -> open("b1", new ArrayList<>()))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("boat1.log is no log of a boat");
        assertThat(file()).hasContent(text);
        Files.delete(file());
        open("b1", new ArrayList<>()).close();
    }

    @Test
    void logIsReadByItsUserOnlyAlsoOneThatWasNot() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        open("b1", new ArrayList<>()).close();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file())))
                .isEqualTo("rw-------");

        Files.setPosixFilePermissions(file(), PosixFilePermissions.fromString("rw-r--r--"));
        open("b2", new ArrayList<>()).close();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file())))
                .isEqualTo("rw-------");
    }

    @Test
    void refusesALogThatIsBeingWritten() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            assertThatThrownBy(() -> open("b2", new ArrayList<>()))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("another boat server");
            log.answered(1, "base", new StopMotors("s"), new Ack("s"));
        }
        assertThat(read()).hasSize(1);
    }

    @Test
    void entryIsInTheFileBeforeTheAnswerLeaves() throws IOException {
        try (CommandLogFile log = open("b1", new ArrayList<>())) {
            log.answered(1, "base", new StopMotors("s"), new Ack("s"));

            assertThat(read()).hasSize(1);
        }
    }

    @Test
    void faultIsToldOnceAndTheBoatGoesOn() throws IOException {
        List<IOException> faults = new ArrayList<>();
        LogFaults listed = new NoFaults() {
            @Override
            public void unwritable(IOException cause) {
                faults.add(cause);
            }
        };
        // No new file is begun: another thread would write it after the folder of the test is gone.
        CommandLogFile log = CommandLogFile.open(new LogDisk(), begun -> {}, place(), "b1", entry -> {}, listed);
        log.close();
        log.answered(1, "base", new StopMotors("s1"), new Ack("s1"));
        log.answered(2, "base", new StopMotors("s2"), new Ack("s2"));

        assertThat(faults).hasSize(1);
    }
}
