package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.Statement;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.TripProject;

/** A journal is followed while it is written, and its state is that of whoever reads it afterwards. */
class JournalFollowerTest {
    @TempDir
    Path folder;

    private final Engine engine = new Engine(TripProject.VOCABULARY, TripProject.startingIn("going"));
    private final EngineState state = engine.newState();
    private JournalAddress address;
    private SqliteJournal journal;

    @BeforeEach
    void begin() throws IOException {
        Path file = folder.resolve("session.journal");
        address = JournalAddress.of(file);
        journal = SqliteJournal.create(file, TripProject.header(Map.of()), JournalOptions.DEFAULT.withSnapshotEvery(7));
    }

    @AfterEach
    void end() throws IOException {
        journal.close();
    }

    /** What the session does next: missions begin, end and are aborted, boats join, projects are loaded. */
    private void write(int count, Random random) throws IOException {
        List<JournalEntry> batch = new ArrayList<>();
        for (int i = 1; i <= count; i++) {
            long index = journal.lastIndex() + i;
            Input input = switch (random.nextInt(8)) {
                case 0 -> new Input.ProxyJoined("b" + index);
                case 1 -> new Input.LoadProject(TripProject.text("place-" + random.nextInt(3)));
                case 2, 3, 4 -> new Input.StartMission("trip", "trip " + index, Map.of());
                case 5 -> new Input.AbortMission(1 + random.nextInt(9));
                default -> {
                    long activation = 1L + random.nextInt(9);
                    yield new Input.Received(
                            new Occurrence("Went", activation, activation, List.of(), List.of(), Map.of()));
                }
            };
            batch.add(new JournalEntry(index, index * 100, input));
        }
        journal.addTelemetry(List.of(new TelemetryRow(batch.get(0).atMillis(), "b1", "pose", "{}")));
        journal.append(batch, Durability.PROCESS);
        batch.forEach(entry -> engine.step(state, entry.atMillis(), entry.input()));
        journal.offerSnapshot(() -> StateCodec.encode(state));
        journal.sync();
    }

    private void assertStateAfterAll(JournalPart ahead) throws JournalException {
        try (JournalReader warm = address.read(Optional.of(ahead));
                JournalReader cold = address.read()) {
            assertThat(warm.goesOn()).isTrue();
            assertThat(warm.lastIndex()).isEqualTo(journal.lastIndex());
            assertThat(warm.checksum()).isEqualTo(cold.checksum());
            byte[] after = StateCodec.encode(warm.stateAt(warm.lastIndex(), engine));
            assertThat(after).isEqualTo(StateCodec.encode(state));
            assertThat(after).isEqualTo(StateCodec.encode(cold.stateAt(cold.lastIndex(), engine)));
            assertThat(warm.telemetry()).isEqualTo(cold.telemetry());
        }
    }

    @Test
    void afterAnyCutTheStateIsThatOfAReaderOfTheWholeJournal() throws Exception {
        Random random = new Random(7);
        try (JournalFollower follower = new JournalFollower(address)) {
            for (int round = 0; round < 40; round++) {
                write(1 + random.nextInt(9), random);
                if (random.nextInt(3) > 0) {
                    follower.follow();
                    assertThat(follower.applied()).isEqualTo(journal.lastIndex());
                }
                if (random.nextInt(5) == 0) {
                    follower.close(); // its connection was cut; the next look opens another
                }
                if (follower.part().isPresent()) {
                    assertStateAfterAll(follower.part().get());
                }
            }
            assertThat(follower.damage()).isEmpty();
            assertThat(follower.part().orElseThrow().stateAt()).hasValue(follower.applied());
        }
        assertThat(engine.view(state).missions()).isNotEmpty();
    }

    @Test
    void aDamageEndsWhatIsAppliedUntilItIsMended() throws Exception {
        Random random = new Random(3);
        try (JournalFollower follower = new JournalFollower(address)) {
            write(5, random);
            follower.follow();
            write(5, random);
            write(5, random);
            byte[] sum = alter("UPDATE entries SET checksum = x'00' WHERE idx = 8", 8);

            follower.follow();
            assertThat(follower.applied()).isEqualTo(7);
            assertThat(follower.damage())
                    .hasValueSatisfying(words -> assertThat(words).contains("entry 8 is damaged"));

            alter("UPDATE entries SET checksum = x'" + HexFormat.of().formatHex(sum) + "' WHERE idx = 8", 8);
            follower.follow();
            assertThat(follower.damage()).isEmpty();
            assertThat(follower.applied()).isEqualTo(15);
            assertStateAfterAll(follower.part().orElseThrow());
        }
    }

    /** Changes the file as another program would; gives the checksum of an entry before. */
    private byte[] alter(String sql, long entry) throws Exception {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + address);
                Statement statement = connection.createStatement()) {
            byte[] before;
            try (ResultSet row = statement.executeQuery("SELECT checksum FROM entries WHERE idx = " + entry)) {
                row.next();
                before = row.getBytes(1);
            }
            statement.execute(sql);
            return before;
        }
    }

    @Test
    void whereAnotherJournalStandsItIsReadFromItsBeginning() throws Exception {
        try (JournalFollower follower = new JournalFollower(address)) {
            write(9, new Random(1));
            follower.follow();
            JournalPart before = follower.part().orElseThrow();
            alter("DELETE FROM entries WHERE idx > 4", 4);

            follower.follow();

            assertThat(follower.applied()).isEqualTo(4);
            try (JournalReader reader = address.read(Optional.of(before));
                    JournalReader cold = address.read()) {
                assertThat(reader.goesOn()).isFalse();
                assertThat(reader.lastIndex()).isEqualTo(4);
                assertThat(StateCodec.encode(reader.stateAt(4, engine)))
                        .isEqualTo(StateCodec.encode(cold.stateAt(4, engine)));
                assertThat(reader.telemetry()).isEqualTo(cold.telemetry());
            }
        }
    }

    /** As where a replica that had not got the newest entries becomes the database. */
    @Test
    void whatWasAppliedBeforeACutAndIsGoneAfterItIsNotGoneOnFrom() throws Exception {
        Queue<Connection> cut = new ArrayDeque<>();
        JournalFollower.Reading reading =
                known -> cut.isEmpty() ? address.read(known) : JournalReader.over("it", cut.remove(), known);
        try (JournalFollower follower = new JournalFollower(address, 100, reading)) {
            write(5, new Random(2));
            follower.follow();
            write(5, new Random(3));
            cut.add(CutWhileRead.after(2, address));
            assertThatThrownBy(follower::follow).hasMessageContaining("the connection was cut");
            assertThat(follower.applied()).isEqualTo(7);
            alter("DELETE FROM entries WHERE idx > 5", 5);

            follower.follow();

            assertThat(follower.applied()).isEqualTo(5);
            try (JournalReader cold = address.read();
                    JournalReader warm = address.read(follower.part())) {
                assertThat(StateCodec.encode(warm.stateAt(5, engine)))
                        .isEqualTo(StateCodec.encode(cold.stateAt(5, engine)));
            }
        }
    }

    @Test
    void moreTelemetryThanMayBeInMemoryIsLeftToWhoeverGoesOn() throws Exception {
        Random random = new Random(5);
        try (JournalFollower follower = new JournalFollower(address, 3, address::read)) {
            for (int row = 1; row <= 5; row++) {
                write(1, random);
                follower.follow();
                assertThat(follower.part().orElseThrow().telemetry().rows()).hasSize(row <= 3 ? row : 0);
            }
            assertStateAfterAll(follower.part().orElseThrow());
        }
    }

    @Test
    void aJournalThatThisProgramCannotGoOnWithIsRefusedForGood() throws Exception {
        Path file = folder.resolve("older.journal");
        SqliteJournal.create(file, TripProject.header(Map.of(RuleVersion.SETTING, "1")), JournalOptions.DEFAULT)
                .close();
        try (JournalFollower follower = new JournalFollower(JournalAddress.of(file))) {
            assertThatThrownBy(follower::follow)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("rules of firing");
        }
        try (JournalFollower follower = new JournalFollower(JournalAddress.of(folder.resolve("nothing")))) {
            assertThatThrownBy(follower::follow).isInstanceOf(JournalException.class);
            assertThat(follower.part()).isEmpty();
        }
    }
}
