package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.HostStatus.Kind;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.host.ManualClock;
import org.sami.spn.host.ManualExecutor;
import org.sami.spn.protocol.Input;

/** A journal whose file may not grow, as SQLite itself says it of a full disk, and then may again. */
@Timeout(900)
class FullDiskTest {
    private static final long PLENTY = 100_000;

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void chooseFile() {
        file = folder.resolve("session.journal");
    }

    private static List<JournalEntry> numbers(long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(i -> new JournalEntry(i, 10 * i, number(i)))
                .toList();
    }

    private static TelemetryRow row(long atMillis) {
        return new TelemetryRow(atMillis, "anna", "pose", "{\"at\": " + atMillis + "}");
    }

    @Test
    void aFileThatAnotherProgramKeepsLockedIsSaidToBeSo() throws Exception {
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT);
                Connection other = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = other.createStatement()) {
            journal.append(numbers(1, 3), Durability.POWER);
            statement.execute("BEGIN IMMEDIATE");

            assertThatThrownBy(() -> journal.append(numbers(4, 5), Durability.PROCESS))
                    .hasMessage(file + ", entry 4: cannot be written: another program locks it")
                    .isInstanceOfSatisfying(JournalException.class, fault -> {
                        assertThat(fault.reason()).isEqualTo("the journal cannot be written: another program locks it");
                        assertThat(fault.details())
                                .startsWith(file + ", entry 4: ")
                                .contains("SQLITE_BUSY");
                    });
        }
    }

    @Test
    void aDiskThatFailsIsSaidSoInPlainWords() {
        int ioErrorAtWriting = 778;
        SQLException fault = new SQLException(
                "[SQLITE_IOERR_WRITE] I/O error in the VFS layer (disk I/O error)", "", ioErrorAtWriting);

        JournalException told = new JournalException(file, 91, "cannot be written: " + Database.words(fault), fault);

        assertThat(told.reason()).isEqualTo("the journal cannot be written: its disk does not take it");
        assertThat(told.details()).isEqualTo(file + ", entry 91: " + fault.getMessage());
    }

    @Test
    void whatAFullDiskRefusedIsWrittenOnceThereIsRoomWithTheTelemetryThatWaited() throws Exception {
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT)) {
            journal.append(numbers(1, 3), Durability.POWER);
            journal.leaveRoomFor(0);
            journal.addTelemetry(List.of(row(40)));
            assertThatThrownBy(() -> journal.append(numbers(4, 900), Durability.PROCESS))
                    .hasMessage(file + ", entry 4: cannot be written: the disk is full");
            assertThatThrownBy(journal::check).hasMessageContaining("the disk is full");
            assertThat(journal.lastIndex()).isEqualTo(3);
            journal.addTelemetry(List.of(row(50)));

            journal.leaveRoomFor(PLENTY);
            journal.recover();
            journal.check();
            journal.append(numbers(4, 900), Durability.POWER);
            assertThat(journal.telemetryLost()).isZero();
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries()).isEqualTo(numbers(1, 900));
            assertThat(reader.telemetry().rows()).containsExactly(row(40), row(50));
        }
    }

    @Test
    void telemetryThatMeetsAFullDiskIsNoticedAndKept() throws Exception {
        List<TelemetryRow> rows =
                LongStream.range(0, 2000).mapToObj(FullDiskTest::row).toList();
        JournalOptions never = JournalOptions.DEFAULT.withoutSync();
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, never)) {
            journal.leaveRoomFor(0);
            journal.addTelemetry(rows);
            assertThatThrownBy(() -> journal.mark("a world")).hasMessageContaining("full");
            assertThatThrownBy(journal::recover).hasMessageContaining("full");
            journal.leaveRoomFor(PLENTY);
            journal.recover();
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.telemetry().rows()).isEqualTo(rows);
        }
    }

    @Test
    void aHostWhoseDiskFillsInTheMiddleOfALargeBatchLetsNothingOfItOutAndThenAllOfIt() throws Exception {
        Engine engine = HostPlans.engine();
        EngineState state = engine.newState();
        ManualClock clock = new ManualClock();
        ManualExecutor executor = new ManualExecutor();
        List<Long> heard = new ArrayList<>();
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT);
                EngineHost host = EngineHostBuilder.of(engine, state)
                        .journal(journal)
                        .clock(clock)
                        .executor(executor)
                        .build()) {
            host.addListener((index, at, input, effects, view) -> heard.add(index));
            journal.leaveRoomFor(4);
            host.post(numbers(1, 2000).stream().map(JournalEntry::input).toList());
            executor.runAll();
            host.post(number(2001));
            executor.runAll();

            assertThat(host.status().kind()).isEqualTo(Kind.WAITING);
            assertThat(host.status().reason()).isEqualTo("the journal cannot be written: the disk is full");
            assertThat(host.status().details()).startsWith(file + ", entry 1: ");
            assertThat(heard).isEmpty();

            journal.leaveRoomFor(PLENTY);
            clock.moveTo(1000);
            executor.runAll();
            assertThat(heard).isEqualTo(LongStream.rangeClosed(1, 2001).boxed().toList());
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(2001);
            assertThat(StateCodec.encode(reader.stateAt(2001, engine))).isEqualTo(StateCodec.encode(state));
        }
    }

    @Test
    void aHostGoesOnWhereItWaitedAndItsJournalReplaysToTheSameState() throws Exception {
        Engine engine = HostPlans.engine();
        EngineState state = engine.newState();
        ManualClock clock = new ManualClock();
        ManualExecutor executor = new ManualExecutor();
        List<Long> heard = new ArrayList<>();
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT);
                EngineHost host = EngineHostBuilder.of(engine, state)
                        .journal(journal)
                        .clock(clock)
                        .executor(executor)
                        .build()) {
            host.addListener((index, at, input, effects, view) -> heard.add(index));
            journal.leaveRoomFor(0);
            for (long n = 1; host.status().kind() == Kind.RUNNING; n++) {
                host.post(number(n));
                executor.runAll();
            }
            int before = heard.size();
            host.post(HostPlans.start("Approve"));
            executor.runAll();
            clock.moveTo(1000);
            executor.runAll();
            assertThat(host.status().kind()).isEqualTo(Kind.WAITING);
            assertThat(heard).hasSize(before);

            journal.leaveRoomFor(PLENTY);
            clock.moveTo(2000);
            executor.runAll();
            assertThat(host.status().kind()).isEqualTo(Kind.RUNNING);
            assertThat(heard).hasSize(before + 2);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            List<JournalEntry> entries = reader.entries();
            assertThat(entries).hasSize(heard.size());
            assertThat(entries.get(entries.size() - 1).input()).isInstanceOf(Input.StartMission.class);
            assertThat(StateCodec.encode(reader.stateAt(reader.lastIndex(), engine)))
                    .isEqualTo(StateCodec.encode(state));
        }
    }
}
