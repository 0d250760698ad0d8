package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** How the bases of a session are named, and what a standby says to a front. */
class SessionBasesTest {
    private static final String PRINT = "AB:".repeat(31) + "AB";

    @Test
    void basesAreNamedWithTheCertificateThatFrontsAreToTrust() {
        SessionBases bases = SessionBases.parse(
                List.of("wss://10.0.0.5:8443=" + PRINT.toLowerCase(Locale.ROOT), "ws://127.0.0.1:8080/"));

        assertThat(bases.list().toString())
                .isEqualTo("[{\"id\":\"wss://10.0.0.5:8443\",\"certificate\":\"" + PRINT
                        + "\"},{\"id\":\"ws://127.0.0.1:8080\"}]");
        assertThat(bases.sources())
                .isEqualTo(" wss://10.0.0.5:8443 ws://127.0.0.1:8080 https://10.0.0.5:8443 http://127.0.0.1:8080");
        assertThat(bases.haveOrigin("https://10.0.0.5:8443")).isTrue();
        assertThat(bases.haveOrigin("http://10.0.0.5:8443")).isFalse();
    }

    @Test
    void addressWithoutCertificateOrInPlainTextToElsewhereOrWithAKeyIsRefused() {
        for (String wrong : List.of(
                "wss://10.0.0.5:8443",
                "wss://10.0.0.5:8443=AB:CD",
                "ws://10.0.0.5:8080",
                "wss://anna:key@10.0.0.5:8443=" + PRINT,
                "wss://10.0.0.5:8443/x=" + PRINT,
                "wss://10.0.0.5:8443; script-src *=" + PRINT,
                "10.0.0.5:8443")) {
            assertThatThrownBy(() -> SessionBases.parse(List.of(wrong)))
                    .as(wrong)
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }
}
