package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;

/** {@code crw find} and {@code crw boat --announce} on loopback, where others may announce boats as well. */
@Tag("long")
@Timeout(900)
class FindCommandTest {
    private static final String[] LOOPBACK = {"find", "--network", "127.0.0.1", "--within", "5"};

    @Test
    void announcedBoatIsListedUntilItEndsAndASilentOneIsNot() throws InterruptedException {
        String anna = "anna-" + UUID.randomUUID();
        String bert = "bert-" + UUID.randomUUID();
        Thread announced = boat(anna, "--announce");
        Thread silent = boat(bert);
        AtomicReference<String> found = new AtomicReference<>("");
        Await.until("the boat is found", () -> {
            found.set(find());
            return found.get().contains(anna);
        });
        assertThat(found.get()).doesNotContain(bert);
        assertThat(found.get().lines().filter(line -> line.startsWith(anna)))
                .singleElement()
                .asString()
                .matches(anna + "\\s+127\\.0\\.0\\.1:\\d+\\s+63 %  open to everybody, simulated");

        announced.interrupt();
        silent.interrupt();
        announced.join();
        silent.join();
        Await.until("it is gone", () -> !find().contains(anna));
    }

    @Test
    void networkThatIsNotOfThisMachineIsNamed() {
        CommandResult result = CommandResult.crw("find", "--network", "192.0.2.77", "--within", "2");

        assertThat(result.exitCode()).isEqualTo(4);
        assertThat(result.out()).contains("no boat announces itself");
        assertThat(result.err()).contains("no network of this machine has the address 192.0.2.77");
    }

    private static String find() {
        return CommandResult.crw(LOOPBACK).out();
    }

    private static Thread boat(String name, String... more) {
        String[] line = {"boat", "--port", "0", "--name", name, "--at", "45.4,10.9", "--battery", "63"};
        String[] all = Stream.of(line, more).flatMap(Arrays::stream).toArray(String[]::new);
        Thread thread = new Thread(() -> CommandResult.crw(all), name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }
}
