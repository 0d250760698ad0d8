package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Clock;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.protocol.Input;

/** Two bases with real databases, of which one replicates the other. Needs an installed PostgreSQL; says so in a line where there is none. */
@Tag("long")
@Timeout(180)
class PairTest {
    @TempDir
    Path root;

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor();

    @AfterEach
    void end() {
        thread.shutdownNow();
    }

    @Test
    void aSessionIsProtectedOnceTheSecondBaseFollowsAndGoesOnThereWithAllEntriesWhenTheFirstIsLost() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            BasePair first = BasePair.open(bases.first);
            BasePair second = BasePair.open(bases.second);
            assertThat(first.checkedPart("sami")).isEqualTo(BasePair.Part.DATABASE);
            assertThat(second.checkedPart("sami")).isEqualTo(BasePair.Part.REPLICA);
            StandbyMonitor monitor = first.monitor("sami", Clock.systemUTC(), this::add);
            awaitLine("copied");
            StoredJournal journal = create(first);
            BlockingQueue<String> said = new LinkedBlockingQueue<>();
            Future<StoredJournal> waiting = thread.submit(() -> takeOver(second, said));
            assertThat(said.take()).startsWith("the session is held by");
            assertThat(said.take()).endsWith("this base goes on with it by itself");
            journal.append(List.of(entry(1), entry(2)), Durability.POWER);

            PairDatabase.of(bases.first).stop(); // power loss of base and database
            monitor.close();

            try (StoredJournal gone = waiting.get()) {
                assertThat(gone.lastIndex()).isEqualTo(2);
                gone.append(List.of(entry(3)), Durability.POWER);
            }
            assertThat(second.checkedPart("sami")).isEqualTo(BasePair.Part.DATABASE);
            assertThatThrownBy(() -> journal.append(List.of(entry(3)), Durability.POWER))
                    .isInstanceOf(IOException.class);

            PairDatabase.of(bases.first).start();
            assertThatThrownBy(() -> first.checkedPart("sami"))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining(bases.secondAddress + " took the session over")
                    .hasMessageContaining("crw pair rejoin");
            Path kept = PairSetup.copyAgain(bases.first, "replaced");
            assertThat(kept).isDirectory();
            assertThat(first.checkedPart("sami")).isEqualTo(BasePair.Part.REPLICA);
            try (StandbyMonitor ofSecond = second.monitor("sami", Clock.systemUTC(), this::add)) {
                awaitLine("copied: " + bases.firstAddress);
            }
        }
    }

    private void add(Protection protection, LocalTime since) {
        lines.add(protection.text());
    }

    private void awaitLine(String beginning) throws InterruptedException {
        String line = lines.take();
        while (!line.startsWith(beginning)) {
            line = lines.take();
        }
    }

    private static StoredJournal create(BasePair pair) throws IOException {
        return JournalAddress.parse(pair.journal("sami").text())
                .create(JournalHeader.of("plans", Map.of(), Map.of("kind", "session")), JournalOptions.DEFAULT);
    }

    private static StoredJournal takeOver(BasePair pair, BlockingQueue<String> said) throws IOException {
        return JournalAddress.parse(pair.journal("sami").text())
                .takeOver(JournalOptions.DEFAULT, said::add, Optional::empty);
    }

    private static JournalEntry entry(long index) {
        return new JournalEntry(index, index * 1000, new Input.ProxyJoined("boat" + index));
    }

    @Test
    void filesOfAPairAreForTheirOwnerAlone() throws Exception {
        try (TwoBases bases = new TwoBases(root)) {
            bases.make(WhenCut.TAKE_OVER);
            for (Path file : new Path[] {
                bases.invitation(), bases.first.passwords(), bases.first.key(), bases.first.certificate()
            }) {
                assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                        .isEqualTo("rw-------");
            }
        }
    }

    /** Their certificates stand in no file of PostgreSQL's. */
    @Test
    void aPairOfAnEarlierBuildStartsAlsoInAFolderWithABlankAndAQuoteInItsName() throws Exception {
        Path odd = Files.createDirectories(root.resolve("Anna's two boats"));
        try (TwoBases bases = new TwoBases(odd)) {
            bases.make(WhenCut.TAKE_OVER);
            PairDatabase database = PairDatabase.of(bases.first);
            database.stop();
            Path file = bases.first.data().resolve("postgresql.conf");
            Files.write(
                    file,
                    Files.readAllLines(file).stream()
                            .filter(line -> !line.startsWith("ssl_cert_file") && !line.startsWith("ssl_key_file"))
                            .toList());

            database.start();

            assertThat(BasePair.open(bases.first).checkedPart("sami")).isEqualTo(BasePair.Part.DATABASE);
        }
    }

    @Test
    void aFolderThatHoldsSomethingElseIsLeftAsItIs() throws Exception {
        try (TwoBases bases = new TwoBases(root)) {
            Path other = Files.writeString(
                    Files.createDirectories(bases.first.path()).resolve("letter"), "dear");

            assertThatThrownBy(() -> bases.make(WhenCut.TAKE_OVER))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("is not empty");
            assertThat(other).hasContent("dear");
        }
    }

    @Test
    void aNameThatEndsInADigitIsNoAddress() {
        assertThat(AccessList.machine("laptop-2")).isEqualTo("laptop-2");
        assertThat(AccessList.machine("10.0.0.6")).isEqualTo("10.0.0.6/32");
    }

    @Test
    void aBaseThatCannotReachTheOtherJoinsNothingAndLeavesNothing() throws Exception {
        try (TwoBases bases = new TwoBases(root)) {
            bases.make(WhenCut.TAKE_OVER);
            PairDatabase.of(bases.first).stop();

            assertThatThrownBy(bases::join)
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("the database of " + bases.firstAddress + " cannot be copied");
            assertThat(bases.second.path()).doesNotExist();
        }
    }
}
