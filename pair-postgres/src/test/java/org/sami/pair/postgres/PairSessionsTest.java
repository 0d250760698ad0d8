package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
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
import org.sami.pair.postgres.Protection.State;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;

/** Several sessions in one pair, and whether somebody waits to go on with one. Real databases; says so in a line where no PostgreSQL is installed. */
@Tag("long")
@Timeout(180)
class PairSessionsTest {
    @TempDir
    Path root;

    private final BlockingQueue<State> states = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> said = new LinkedBlockingQueue<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor();

    @AfterEach
    void end() {
        thread.shutdownNow();
    }

    @Test
    void aReplicaStaysOneWhileAnotherSessionOfThePairGoesOn() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            StoredJournal tuesday = create(bases, "tuesday");
            create(bases, "monday").close(); // given back

            Future<StoredJournal> waiting = thread.submit(
                    () -> address(bases.second, "monday").takeOver(JournalOptions.DEFAULT, said::add, Optional::empty));

            awaitWords("the session tuesday of this pair goes on at the other base");
            assertThat(BasePair.open(bases.second).part()).isEqualTo(BasePair.Part.REPLICA);
            tuesday.close();
            try (StoredJournal taken = waiting.get()) {
                assertThat(taken.lastIndex()).isZero();
            }
        }
    }

    @Test
    void aSessionIsProtectedOnlyWhileABaseWaitsToGoOnWithIt() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                StandbyMonitor monitor = BasePair.open(bases.first)
                        .monitor(Clock.systemUTC(), (now, since) -> states.add(now.state()))) {
            await(State.COPIED);
            try (StandbyPresence presence = BasePair.open(bases.second).standBy()) {
                await(State.PROTECTED);
            }
            await(State.COPIED); // it said no word of its end, as one that was killed
        }
    }

    private void await(State state) throws InterruptedException {
        State now = states.take();
        while (now != state) {
            now = states.take();
        }
    }

    private void awaitWords(String words) throws InterruptedException {
        String line = said.take();
        while (!line.contains(words)) {
            line = said.take();
        }
    }

    private static JournalAddress address(PairFolder folder, String name) throws IOException {
        return JournalAddress.parse(BasePair.open(folder).journal(name).text());
    }

    private static StoredJournal create(TwoBases bases, String name) throws IOException {
        return address(bases.first, name)
                .create(JournalHeader.of("plans", Map.of(), Map.of("kind", "session")), JournalOptions.DEFAULT);
    }
}
