package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.sql.Connection;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.pair.postgres.PairMove.Link;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.protocol.Input;

/** Bases of a pair that get other addresses. Real databases; says so in a line where no PostgreSQL is installed. */
@Tag("long")
@Timeout(180)
class PairMoveTest {
    @TempDir
    Path root;

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

    @Test
    void aSessionGoesOnWhileItsStandbyMovesAndIsProtectedAtTheNewAddress() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                StandbyMonitor monitor = BasePair.open(bases.first)
                        .monitor("sami", Clock.systemUTC(), (now, since) -> lines.add(now.text()));
                StoredJournal journal = create(bases)) {
            await("copied: " + bases.secondAddress);
            write(journal, 1);

            PairMove.Change second = PairMove.to(bases.second, bases.newAddress, bases.firstAddress);

            assertThat(second.hasRestarted()).isTrue();
            assertThat(second.link()).isEqualTo(Link.CONNECTED);
            PairMove.Change first = PairMove.to(bases.first, bases.firstAddress, bases.newAddress);
            assertThat(first.hasRestarted())
                    .as("the session's database is not stopped")
                    .isFalse();
            assertThat(first.link()).isEqualTo(Link.CONNECTED);
            PairDatabase.of(bases.second).stop();
            await("alone");
            PairDatabase.of(bases.second).start();
            await("copied: " + bases.newAddress);
            write(journal, 2);
            assertThat(entries(bases.second)).isEqualTo(2);
        }
    }

    @Test
    void aReplicaFollowsTheDatabaseOfASessionToItsNewAddressWithoutANewCopy() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            try (StoredJournal journal = create(bases)) {
                write(journal, 1);
            }

            PairSettings before = bases.first.settings();
            awaitConnected(bases.first, true);
            assertThatThrownBy(() -> PairMove.to(bases.first, bases.newAddress, bases.secondAddress))
                    .as("the replica looks for it at the old address")
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining(bases.secondAddress + " follows the database of this base at "
                            + bases.firstAddress + ", where it would be no longer; nothing was changed")
                    .hasMessageContaining("crw pair stop")
                    .hasMessageEndingWith("crw pair address " + bases.newAddress);
            assertThat(bases.first.settings()).isEqualTo(before);

            PairDatabase.of(bases.second).stop();
            awaitConnected(bases.first, false);
            PairMove.Change first = PairMove.to(bases.first, bases.newAddress, bases.secondAddress);

            assertThat(first.hasRestarted()).isTrue();
            assertThat(first.link()).isEqualTo(Link.SILENT);
            PairDatabase.of(bases.second).start();
            PairMove.Change second = PairMove.to(bases.second, bases.secondAddress, bases.newAddress);
            assertThat(second.hasRestarted()).isFalse();
            assertThat(second.link()).isEqualTo(Link.CONNECTED);
            try (StoredJournal journal = address(bases.first).open(JournalOptions.DEFAULT)) {
                write(journal, 2);
            }
            assertThat(BasePair.open(bases.first).standing()).contains("its standby follows");
            assertThat(BasePair.open(bases.second).standing())
                    .contains("the other, " + bases.newAddress + ": database of the session");
        }
    }

    @Test
    void aBaseThatWasReplacedIsToldToComeBackAsTheStandby() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            PairDatabase.of(bases.first).stop();
            BasePair.open(bases.second).takeOver("sami", /* lossConfirmed= */ true);
            PairDatabase.of(bases.first).start();

            assertThat(PairMove.to(bases.first, bases.newAddress, bases.secondAddress)
                            .link())
                    .isEqualTo(Link.REPLACED_HERE);
            assertThat(PairMove.to(bases.second, bases.secondAddress, bases.newAddress)
                            .link())
                    .isEqualTo(Link.REPLACED_THERE);

            PairSetup.copyAgain(bases.first, "replaced");
            assertThat(BasePair.open(bases.first).part()).isEqualTo(BasePair.Part.REPLICA);
        }
    }

    @Test
    void anAddressWhereNothingAnswersDoesNotCutBasesThatAreConnected() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                StandbyMonitor monitor = monitor(bases)) {
            PairSettings before = bases.second.settings();
            await("copied");

            assertThatThrownBy(() -> PairMove.to(bases.second, bases.secondAddress, bases.newAddress))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("the bases are connected by " + bases.firstAddress)
                    .hasMessageContaining("nothing was changed");
            assertThatThrownBy(() -> PairMove.to(bases.second, "192.0.2.1", bases.firstAddress))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("192.0.2.1 is no address of this machine");

            assertThat(bases.second.settings()).isEqualTo(before);
            PairDatabase.of(bases.first).stop();
            assertThat(PairMove.to(bases.second, bases.secondAddress, bases.newAddress)
                            .link())
                    .as("they are not connected any more")
                    .isEqualTo(Link.SILENT);
        }
    }

    @Test
    void aDatabaseThatDoesNotStartAtItsNewAddressGoesOnAtTheEarlierOne() throws Exception {
        try (TwoBases bases = new TwoBases(root);
                Socket inTheWay = new Socket()) {
            bases.make(WhenCut.ALONE);
            PairSettings before = bases.first.settings();
            inTheWay.bind(new InetSocketAddress(bases.newAddress, before.port())); // answers nobody

            assertThatThrownBy(() -> PairMove.to(bases.first, bases.newAddress, bases.secondAddress))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("the database of this base does not start")
                    .hasMessageEndingWith("; nothing was changed");

            assertThat(bases.first.settings()).isEqualTo(before);
            assertThat(bases.first.data().resolve("pg_hba.conf"))
                    .content()
                    .contains(bases.firstAddress + "/32")
                    .doesNotContain(bases.newAddress);
            assertThat(BasePair.open(bases.first).part()).isEqualTo(BasePair.Part.DATABASE);
        }
    }

    private static void awaitConnected(PairFolder folder, boolean connected) throws Exception {
        try (Connection own = new PairConnections(folder, folder.settings()).own()) {
            while (Replication.replica(own).isConnected() != connected) {
                Thread.onSpinWait();
            }
        }
    }

    @Test
    void anEarlierAddressIsLetInNoLongerAndAPersonsOwnLinesStay() throws Exception {
        try (TwoBases bases = new TwoBases(root)) {
            bases.make(WhenCut.ALONE);
            Path list = bases.first.data().resolve("pg_hba.conf");
            String own = "hostssl sami reader 10.9.8.7/32 scram-sha-256";
            Files.writeString(list, own + "\n", StandardOpenOption.APPEND);

            PairMove.to(bases.first, bases.firstAddress, bases.newAddress);

            assertThat(list).content().contains(own, bases.newAddress + "/32").doesNotContain(bases.secondAddress);
        }
    }

    private StandbyMonitor monitor(TwoBases bases) throws IOException {
        return BasePair.open(bases.first).monitor("sami", Clock.systemUTC(), (now, since) -> lines.add(now.text()));
    }

    private void await(String beginning) throws InterruptedException {
        String line = lines.take();
        while (!line.startsWith(beginning)) {
            line = lines.take();
        }
    }

    private static JournalAddress address(PairFolder folder) throws IOException {
        return JournalAddress.parse(BasePair.open(folder).journal("sami").text());
    }

    private static StoredJournal create(TwoBases bases) throws IOException {
        return address(bases.first)
                .create(JournalHeader.of("plans", Map.of(), Map.of("kind", "session")), JournalOptions.DEFAULT);
    }

    private static void write(StoredJournal journal, long index) throws IOException {
        journal.append(
                List.of(new JournalEntry(index, index * 1000, new Input.ProxyJoined("boat" + index))),
                Durability.POWER);
    }

    private static long entries(PairFolder folder) throws IOException {
        try (var reader = address(folder).read()) {
            return reader.lastIndex();
        }
    }
}
