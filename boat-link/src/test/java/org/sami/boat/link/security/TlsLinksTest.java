package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Both sides of a protected link know the key of the other, over the newest version that both speak. */
@Timeout(300)
class TlsLinksTest {
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
}
