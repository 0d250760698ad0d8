package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.proxy.tcp.BaseProtection;

/**
 * {@code --near} of {@code crw run} and {@code crw session}, with boats that announce themselves on loopback by real multicast. Boats that others announce there
 * are left out, as this base has none of their keys.
 */
@Tag("long")
@Timeout(600)
@Isolated("what --keys says holds for the whole process")
class NearCommandTest {
    @TempDir
    private Path folder;

    private final String anna = "anna-" + UUID.randomUUID();
    private final String stranger = "stranger-" + UUID.randomUUID();
    private Thread paired;
    private Thread unpaired;

    @BeforeEach
    void announce() throws IOException {
        KeyRing base = new KeyStoreFolder(folder.resolve("base")).open();
        KeyRing boat = new KeyStoreFolder(folder.resolve(anna)).open();
        boat.add(new Peer(base.identity().fingerprint(), "base", Role.COMMANDER));
        base.add(new Peer(boat.identity().fingerprint(), anna, Role.COMMANDER));
        paired = boat(anna);
        unpaired = boat(stranger);
    }

    @AfterEach
    void end() throws InterruptedException {
        new BaseProtection(Optional.empty(), false).use();
        paired.interrupt();
        unpaired.interrupt();
        paired.join();
        unpaired.join();
    }

    @Test
    void missionRunsOnThePairedBoatThatIsNearAndTheOtherIsNamed() {
        CommandResult run = untilBothAreSeen("run", "clv", "--area", "60", "--locations", "2");

        assertThat(run.exitCode())
                .as(run.out() + run.err())
                .isIn(ExitCode.OK, ExitCode.PROBLEMS); // links of a busy machine are lost now and then
    }

    @Test
    void sessionConnectsToThePairedBoatThatIsNear() throws IOException {
        Path script = Files.writeString(folder.resolve("script"), "wait boats 1 within 120\nboats\n");

        CommandResult session = untilBothAreSeen("session", "clv", "--script", script.toString());

        assertThat(session.exitCode()).as(session.out() + session.err()).isZero();
        assertThat(session.out()).contains(anna);
    }

    @Test
    void simulatedBoatsBesideThoseNearNeedAPlace() {
        CommandResult run = CommandResult.crw("run", "clv", "--near", "--boats", "3");

        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err()).contains("--boats beside --near: say by --at where the area lies");
    }

    /** A busy machine may hear one of the two too late for one search. */
    private CommandResult untilBothAreSeen(String... command) {
        AtomicReference<CommandResult> last = new AtomicReference<>();
        Await.until("both are seen", 300, () -> {
            last.set(CommandResult.crw(with(command)));
            return !last.get().err().contains("finds no boat")
                    && last.get().err().contains(stranger);
        });
        assertThat(last.get().err())
                .containsPattern("--near leaves out " + stranger + " at 127.0.0.1:\\d+: not paired");
        return last.get();
    }

    private String[] with(String... command) {
        return Stream.concat(
                        Arrays.stream(command),
                        Stream.of(
                                "--near",
                                "--network",
                                "127.0.0.1",
                                "--keys",
                                folder.resolve("base").toString()))
                .toArray(String[]::new);
    }

    private Thread boat(String name) {
        String[] line = {
            "boat",
            "--port",
            "0",
            "--name",
            name,
            "--at",
            "45.4,10.9",
            "--announce",
            "--boat-keys",
            folder.resolve(name).toString()
        };
        Thread thread = new Thread(() -> CommandResult.crw(line), name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }
}
