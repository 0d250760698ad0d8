package org.sami.crw.session.standby;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.testing.TripProject;

/** A standby takes the state that it applied only where nothing went wrong while it did. */
@Timeout(60)
class WarmStandbyTest {
    @TempDir
    Path folder;

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final CountDownLatch warm = new CountDownLatch(1);
    private JournalAddress address;
    private StoredJournal journal;

    @BeforeEach
    void begin() throws IOException {
        address = JournalAddress.of(folder.resolve("session.journal"));
        journal = address.create(TripProject.header(Map.of()), JournalOptions.DEFAULT);
    }

    @AfterEach
    void end() throws IOException {
        journal.close();
    }

    @Test
    void whatWasAppliedIsTaken() throws InterruptedException {
        try (WarmStandby standby = new WarmStandby(address, lines::add, System::nanoTime, warm::countDown)) {
            warm.await();

            assertThat(standby.finish()).isPresent();
        }
    }

    @Test
    void nothingIsTakenAfterAnErrorInAStep() throws InterruptedException {
        Runnable fails = () -> {
            warm.countDown();
            throw new OutOfMemoryError("no room in this step");
        };
        try (WarmStandby standby = new WarmStandby(address, lines::add, System::nanoTime, fails)) {
            warm.await();

            assertThat(standby.finish()).isEmpty();
            assertThat(lines).anySatisfy(line -> assertThat(line).endsWith("taken over: no room in this step"));
            assertThat(standby.progress()).isEqualTo("nothing applied yet");
        }
    }

    @Test
    void nothingIsTakenWhereAnErrorComesAsItIsTaken() throws InterruptedException {
        try (WarmStandby standby = new WarmStandby(address, this::refuse, System::nanoTime, warm::countDown)) {
            warm.await();

            assertThat(standby.finish()).isEmpty();
            assertThat(lines).anySatisfy(line -> assertThat(line).contains("the session is read again"));
        }
    }

    private void refuse(String line) {
        if (line.startsWith("applied up to")) {
            throw new AssertionError("once");
        }
        lines.add(line);
    }
}
