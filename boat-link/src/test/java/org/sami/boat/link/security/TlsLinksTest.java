package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Both sides of a protected link know the key of the other, over the newest version that both speak. */
@Timeout(900)
class TlsLinksTest {
    private static final String PASSWORD = "of a test";

    private final Identity boat = Identity.generate();
    private final Identity base = Identity.generate();

    /** The boat's and the base's end of one link. */
    private static List<SecureLink> link(TlsLinks ofBoat, TlsLinks ofBase) throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Socket client = new Socket(InetAddress.getLoopbackAddress(), server.getLocalPort());
            Socket accepted = server.accept();
            accepted.setSoTimeout(60_000);
            client.setSoTimeout(60_000);
            CompletableFuture<SecureLink> atBoat = CompletableFuture.supplyAsync(() -> {
                try {
                    return ofBoat.accept(accepted);
                } catch (IOException e) {
                    throw new IllegalStateException(e);
                }
            });
            SecureLink atBase = ofBase.connect(client);
            return Arrays.asList(atBoat.get(), atBase);
        }
    }

    @ParameterizedTest
    @CsvSource({"TLSv1.3 TLSv1.2, TLSv1.3", "TLSv1.2, TLSv1.2"})
    void bothSidesKnowTheKeyOfTheOther(String spokenByThePhone, String version) throws Exception {
        TlsLinks phone = new TlsLinks(boat, key -> true, Arrays.asList(spokenByThePhone.split(" ")));

        List<SecureLink> ends = link(phone, new TlsLinks(base, boat.fingerprint()::equals));

        assertThat(ends.get(0).peer()).contains(base.fingerprint());
        assertThat(ends.get(1).peer()).contains(boat.fingerprint());
        assertThat(TlsLinks.version(ends.get(1))).isEqualTo(version);
        ends.get(1).out().write(7);
        assertThat(ends.get(0).in().read()).isEqualTo(7);
    }

    @Test
    void boatThatHasNoNewVersionAtAllIsRefused() {
        assertThatThrownBy(() -> link(
                        new TlsLinks(boat, key -> true, List.of("TLSv1.1")),
                        new TlsLinks(base, boat.fingerprint()::equals)))
                .isInstanceOfAny(LinkRefusedException.class, ExecutionException.class);
    }

    @Test
    void boatWithAnotherKeyThanThePinnedOneIsRefusedByItsKey() {
        Identity other = Identity.generate();

        assertThatThrownBy(() -> link(new TlsLinks(other, key -> true), new TlsLinks(base, boat.fingerprint()::equals)))
                .hasMessageContaining("its key " + other.fingerprint().shortText() + " is not paired with this base");
    }

    /** A phone whose clock stands in 1970 makes a certificate of that time, as does a key store of its own. Only its key is looked at. */
    @ParameterizedTest
    @CsvSource({"-20y, long ago", "+20y, not yet"})
    void certificateThatIsOutOfDateIsAsGoodAsItsKey(String from, String what, @TempDir Path folder) throws Exception {
        Identity outOfDate = identityOf(folder, from);
        assertThatThrownBy(() -> outOfDate.certificate().checkValidity())
                .as(what)
                .isInstanceOf(CertificateException.class);

        List<SecureLink> ofBoat =
                link(new TlsLinks(outOfDate, key -> true), new TlsLinks(base, outOfDate.fingerprint()::equals));
        List<SecureLink> ofBase =
                link(new TlsLinks(boat, key -> true), new TlsLinks(outOfDate, boat.fingerprint()::equals));

        assertThat(ofBoat.get(1).peer()).contains(outOfDate.fingerprint());
        assertThat(ofBase.get(0).peer()).contains(outOfDate.fingerprint());
    }

    /** A key with a certificate that is valid for one day, some years from now; made by the JDK's own tool. */
    private static Identity identityOf(Path folder, String from) throws Exception {
        Path store = folder.resolve("keys.p12");
        String tool = Path.of(System.getProperty("java.home"), "bin", "keytool").toString();
        List<String> command = new ArrayList<>(List.of(tool, "-genkeypair", "-alias", "key", "-keyalg", "EC"));
        command.addAll(List.of("-groupname", "secp256r1", "-dname", "CN=any", "-startdate", from, "-validity", "1"));
        command.addAll(List.of("-storetype", "PKCS12", "-storepass", PASSWORD, "-keystore", store.toString()));
        Process made = new ProcessBuilder(command).inheritIO().start();
        assertThat(made.waitFor()).isZero();
        KeyStore keys = KeyStore.getInstance(store.toFile(), PASSWORD.toCharArray());
        PrivateKey key = (PrivateKey) keys.getKey("key", PASSWORD.toCharArray());
        return new Identity(key, (X509Certificate) keys.getCertificate("key"));
    }
}
