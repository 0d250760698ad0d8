package org.sami.crw.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.standby.WarmStandby;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.StoredJournal;
import org.sami.work.postgres.testing.TestDatabase;

/** Standbys of a session in PostgreSQL that read it while they wait; the session is that of a real run. */
@Timeout(300)
class WarmTakeOverTest {
    private static final JournalOptions OPTIONS = JournalOptions.DEFAULT.withSnapshotEvery(20);

    @TempDir
    static Path folder;

    private static final List<JournalEntry> ENTRIES = new ArrayList<>();
    private static JournalHeader header;

    private final PostgresAddress database = TestDatabase.address();
    private final JournalAddress address = JournalAddress.parse(database.text());
    private final ExecutorService threads = Executors.newCachedThreadPool();

    /** Another base that waits. */
    private final class Standby {
        final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
        final Future<SessionJournal> taken;

        Standby() {
            taken = threads.submit(() -> {
                try (WarmStandby warm = new WarmStandby(address, lines::add, System::nanoTime, () -> {})) {
                    return SessionJournal.takeOver(address, lines::add, warm::finish);
                }
            });
        }

        /** The next line that begins so; others are passed over. */
        String await(String words) throws InterruptedException {
            for (String line = next(); ; line = next()) {
                if (line.startsWith(words)) {
                    return line;
                }
            }
        }

        private String next() throws InterruptedException {
            String line = lines.poll(120, TimeUnit.SECONDS);
            assertThat(line).as("a line of the standby").isNotNull();
            return line;
        }
    }

    @BeforeAll
    static void run() throws IOException {
        Path file = folder.resolve("run.journal");
        CommandResult ran = CommandResult.crw(
                "run",
                "communications-monitoring",
                "--boats",
                "3",
                "--for",
                "120",
                "--speed",
                "max",
                "--quiet",
                "--journal",
                file.toString());
        assertThat(ran.err()).as(ran.out()).doesNotContain("crw:");
        try (JournalReader reader = JournalReader.open(file)) {
            ENTRIES.addAll(reader.entries());
            Map<String, String> settings = new HashMap<>(reader.header().settings());
            settings.put("kind", "session");
            header = JournalHeader.of(reader.header().project(), reader.header().vocabulary(), settings);
        }
        assertThat(ENTRIES).hasSizeGreaterThan(100);
    }

    @AfterEach
    void end() {
        threads.shutdownNow();
    }

    private Engine engine() throws IOException {
        return JournalPlans.engine(address, header);
    }

    /** The state after so many entries, by stepping through all of them. */
    private byte[] stateAfter(int count) throws IOException {
        Engine engine = engine();
        EngineState state = engine.newState();
        ENTRIES.subList(0, count).forEach(entry -> engine.step(state, entry.atMillis(), entry.input()));
        return StateCodec.encode(state);
    }

    /** Writes on to an entry, in batches, with a snapshot where one is due. */
    private void write(StoredJournal journal, int to, Random random) throws IOException {
        Engine engine = engine();
        int from = (int) journal.lastIndex();
        EngineState state = StateCodec.decode(stateAfter(from), engine);
        while (from < to) {
            int next = Math.min(to, from + 1 + random.nextInt(9));
            List<JournalEntry> batch = ENTRIES.subList(from, next);
            journal.append(batch, Durability.PROCESS);
            batch.forEach(entry -> engine.step(state, entry.atMillis(), entry.input()));
            journal.offerSnapshot(() -> StateCodec.encode(state));
            from = next;
        }
    }

    @Test
    void afterRandomCutsTheNextStandbyHasTheStateOfAColdResumeAndTheOthersFollowIt() throws Exception {
        Random random = new Random(11);
        Standby waiting = new Standby();
        waiting.await("nobody has begun");
        StoredJournal holder = address.create(header, OPTIONS);
        int written = 0;
        for (int cut = 0; cut < 6; cut++) {
            Standby other = new Standby();
            written = Math.min(ENTRIES.size(), written + 1 + random.nextInt(ENTRIES.size() / 4));
            write(holder, written, random);
            if (cut % 2 == 0) { // else it may take over before it has read anything
                other.await("warm: applied up to entry");
            }
            holder.close();

            SessionJournal taken = firstOf(waiting, other);
            Standby rest = taken == doneOrNull(waiting) ? other : waiting;
            assertThat(taken.resumedFrom()).hasValue(written);
            assertThat(taken.damage()).isEmpty();
            assertThat(StateCodec.encode(taken.restore(engine()))).isEqualTo(stateAfter(written));
            try (JournalReader cold = address.read()) {
                assertThat(StateCodec.encode(cold.stateAt(written, engine()))).isEqualTo(stateAfter(written));
            }
            holder = taken.stored().orElseThrow();
            waiting = rest;
        }
        holder.close();
        waiting.taken.get().close();
    }

    private static SessionJournal firstOf(Standby one, Standby other) throws Exception {
        BlockingQueue<Standby> done = new LinkedBlockingQueue<>();
        for (Standby each : List.of(one, other)) {
            Thread awaiting = new Thread(() -> {
                try {
                    each.taken.get();
                    done.add(each);
                } catch (Exception ended) {
                    // the test has ended
                }
            });
            awaiting.setDaemon(true);
            awaiting.start();
        }
        Standby first = done.poll(120, TimeUnit.SECONDS);
        assertThat(first).isNotNull();
        return first.taken.get();
    }

    private static SessionJournal doneOrNull(Standby one) throws Exception {
        return one.taken.isDone() ? one.taken.get() : null;
    }

    @Test
    void aDamageIsSaidAndTheTakeOverGoesOnBeforeItAsAColdResumeDoes() throws Exception {
        StoredJournal holder = address.create(header, OPTIONS);
        write(holder, 60, new Random(1));
        TestDatabase.run(database, "UPDATE entries SET input = '{}' WHERE idx = 51");
        Standby standby = new Standby();
        standby.await("warm: applied up to entry 50");
        assertThat(standby.await("the session's journal is damaged"))
                .contains("entry 51 is damaged")
                .endsWith("applied up to entry 50");
        Standby second = new Standby();
        second.await("the session's journal is damaged");

        holder.close();

        SessionJournal taken = firstOf(standby, second);
        Standby rest = taken == doneOrNull(standby) ? second : standby;
        assertThat(taken.resumedFrom()).hasValue(50);
        assertThat(taken.damage()).contains("10 entries are kept in the table set_aside");
        assertThat(StateCodec.encode(taken.restore(engine()))).isEqualTo(stateAfter(50));

        write(taken.stored().orElseThrow(), 80, new Random(2));
        rest.await("applied up to entry");
        taken.close();
        try (SessionJournal last = rest.taken.get()) {
            assertThat(last.resumedFrom()).hasValue(80);
            assertThat(last.damage()).isEmpty();
            assertThat(StateCodec.encode(last.restore(engine()))).isEqualTo(stateAfter(80));
        }
    }

    @Test
    void aStandbyWhoseReaderIsCutOffReadsOn() throws Exception {
        StoredJournal holder = address.create(header, OPTIONS);
        write(holder, 30, new Random(1));
        Standby standby = new Standby();
        standby.await("warm: applied up to entry 30");

        Await.until("the standby's reader", 120, () -> cutReaders() > 0);

        standby.await("cannot read the session");
        write(holder, 40, new Random(1));
        standby.await("applied up to entry ");
        holder.close();
        try (SessionJournal taken = standby.taken.get()) {
            assertThat(taken.resumedFrom()).hasValue(40);
            assertThat(StateCodec.encode(taken.restore(engine()))).isEqualTo(stateAfter(40));
        }
    }

    /** How many readers were cut off that had come to the end of a look. */
    private long cutReaders() {
        try {
            return TestDatabase.number(
                    database,
                    "SELECT count(pg_terminate_backend(pid)) FROM pg_stat_activity WHERE query LIKE '%FROM telemetry%'"
                            + " AND pid <> pg_backend_pid()");
        } catch (SQLException fault) {
            throw new IllegalStateException(fault);
        }
    }

    @Test
    void whatAResumeRefusesAStandbyRefusesBeforeItWaits() throws Exception {
        Map<String, String> settings = new HashMap<>(header.settings());
        settings.put(RuleVersion.SETTING, "1");
        JournalHeader older =
                new JournalHeader(JournalHeader.CURRENT_VERSION, header.project(), header.vocabulary(), settings);
        assertThatThrownBy(() -> address.create(older, OPTIONS)).hasMessageContaining("rules of firing");

        CommandResult resume = CommandResult.crw("serve", "--port", "0", "--journal", database.text());
        CommandResult standby = CommandResult.crw("serve", "--port", "0", "--journal", database.text(), "--standby");

        assertThat(resume.err()).contains("rules of firing");
        assertThat(standby.exitCode()).isEqualTo(resume.exitCode());
        assertThat(standby.err()).isEqualTo(resume.err());
    }

    @Test
    void aSessionThatCannotBeAppliedIsReadWhenItIsTakenOver() throws Exception {
        StoredJournal holder =
                address.create(JournalHeader.of("no project", header.vocabulary(), header.settings()), OPTIONS);
        holder.append(ENTRIES.subList(0, 30), Durability.PROCESS);
        Standby standby = new Standby();
        assertThat(standby.await("cannot apply the session after entry 0"))
                .contains("its project cannot be read")
                .contains("it is read when it is taken over");

        holder.close();

        standby.await("reads the session now");
        try (SessionJournal taken = standby.taken.get()) {
            assertThat(taken.resumedFrom()).hasValue(30);
        }
    }

    @Test
    void aRunIsNoSessionToWaitFor() throws Exception {
        Map<String, String> settings = new HashMap<>(header.settings());
        settings.put("kind", "run");
        try (StoredJournal holder =
                address.create(JournalHeader.of(header.project(), header.vocabulary(), settings), OPTIONS)) {
            CommandResult standby =
                    CommandResult.crw("serve", "--port", "0", "--journal", database.text(), "--standby");

            assertThat(standby.exitCode()).as(standby.err()).isEqualTo(2);
            assertThat(standby.err()).contains("is the journal of a run");
            assertThat(holder.lastIndex()).isZero();
        }
    }
}
