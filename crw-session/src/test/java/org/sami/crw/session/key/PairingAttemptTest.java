package org.sami.crw.session.key;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.PairingSecret;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BoatPairing;
import org.sami.crw.session.key.PairingAttempt.State;

/** A pairing that does not come about: why is said in one sentence, and it can be cancelled while it waits. */
@Timeout(900)
class PairingAttemptTest {
    @TempDir
    private Path folder;

    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final LinkedBlockingQueue<State> states = new LinkedBlockingQueue<>();
    private PairingAttempt attempt;

    @AfterEach
    void close() {
        front.shutdownNow();
    }

    private void begin(int port, Path keys) throws Exception {
        BoatPairing.Request request = new BoatPairing.Request(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                PairingSecret.random(),
                Optional.empty(),
                Role.COMMANDER,
                "test");
        front.submit(() -> attempt =
                        PairingAttempt.begin(request, new BaseKeys(keys), front, () -> states.add(attempt.state())))
                .get();
    }

    private String failure() throws Exception {
        State state = states.poll(100, TimeUnit.SECONDS);
        assertThat(state).isEqualTo(State.FAILED);
        return front.submit(attempt::words).get();
    }

    @Test
    void pairingThatWaitsForASilentPeerIsCancelled() throws Exception {
        try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            begin(silent.getLocalPort(), folder);
            silent.accept(); // the boat is being asked

            front.submit(attempt::cancel).get();

            assertThat(failure()).isEqualTo("Not paired: cancelled");
            assertThat(new BaseKeys(folder).list().boats()).isEmpty();
        }
    }

    @Test
    void addressWithoutABoatIsNamed() throws Exception {
        int port;
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = taken.getLocalPort();
        }
        begin(port, folder);

        assertThat(failure()).startsWith("Not paired: no boat answers at ").contains(":" + port);
    }

    @Test
    void peerThatIsNoBoatWithKeysIsNamed() throws Exception {
        try (ServerSocket plain = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            begin(plain.getLocalPort(), folder);
            try (Socket accepted = plain.accept()) {
                accepted.getOutputStream()
                        .write("HTTP/1.1 400 Bad Request\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            }

            assertThat(failure()).startsWith("Not paired: no protected link: ");
        }
    }

    @Test
    void keysThatAreAFileAreNamed() throws Exception {
        Path file = Files.writeString(folder.resolve("keys"), "");
        begin(1, file);

        assertThat(failure()).contains("the keys of this base: ").contains("is a file");
    }
}
