package org.sami.pair.postgres;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.security.cert.CertificateEncodingException;
import java.util.Base64;
import java.util.concurrent.atomic.AtomicInteger;
import org.sami.boat.link.security.Identity;

/** Two bases on this machine, at two addresses of its loopback, that are a pair. Their databases are stopped at the end. */
final class TwoBases implements AutoCloseable {
    private static final int PORT = 5440;
    private static final AtomicInteger MADE = new AtomicInteger();

    /** Addresses that no other test has. */
    final String firstAddress;

    final String secondAddress;

    /** One that no base has yet. */
    final String newAddress;

    private final Path root;
    final PairFolder first;
    final PairFolder second;
    private final Programs programs;
    private final PairSecrets secrets = secrets();

    TwoBases(Path root) throws IOException {
        programs = Programs.installed().orElse(null);
        assumeTrue(programs != null, Programs.HOW_TO_GET);
        this.root = root;
        first = new PairFolder(root.resolve("first"));
        second = new PairFolder(root.resolve("second"));
        long process = ProcessHandle.current().pid();
        String network = "127." + (100 + process % 100) + "." + process / 100 % 250 + ".";
        int number = 3 * MADE.incrementAndGet();
        firstAddress = network + number;
        secondAddress = network + (number + 1);
        newAddress = network + (number + 2);
    }

    /** Both, the second a replica. */
    static TwoBases paired(Path root, WhenCut whenCut) throws IOException {
        TwoBases bases = new TwoBases(root);
        try {
            bases.make(whenCut);
            bases.join();
            return bases;
        } catch (IOException | RuntimeException fault) {
            bases.close();
            throw fault;
        }
    }

    void make(WhenCut whenCut) throws IOException {
        PairSettings settings = new PairSettings(firstAddress, secondAddress, PORT, whenCut);
        PairSetup.make(first, programs, settings, secrets);
        new Invitation(settings.seenByOther(), secrets).write(invitation());
    }

    void join() throws IOException {
        PairSetup.join(second, programs, Invitation.read(invitation()));
    }

    Path invitation() {
        return root.resolve("invitation");
    }

    private static PairSecrets secrets() {
        Identity identity = Identity.generate();
        try {
            return PairSecrets.of(
                    pem("PRIVATE KEY", identity.key().getEncoded()),
                    pem("CERTIFICATE", identity.certificate().getEncoded()));
        } catch (CertificateEncodingException impossible) {
            throw new AssertionError(impossible);
        }
    }

    private static String pem(String what, byte[] bytes) {
        return "-----BEGIN " + what + "-----\n"
                + Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes) + "\n-----END " + what + "-----\n";
    }

    @Override
    public void close() throws IOException {
        stop(first);
        stop(second);
    }

    private static void stop(PairFolder folder) throws IOException {
        if (folder.isThere() && PairDatabase.of(folder).isRunning()) {
            PairDatabase.of(folder).stop();
        }
    }
}
