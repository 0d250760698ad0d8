package org.sami.crw.proxy.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BoatAddressTest {

    @ParameterizedTest
    @CsvSource({
        "127.0.0.1:5001, 127.0.0.1, 5001, 127.0.0.1:5001",
        "Boat-7.local:65535, boat-7.local, 65535, boat-7.local:65535",
        "[::1]:1, ::1, 1, [::1]:1",
        "[FE80::1%eth0]:5001, fe80::1%eth0, 5001, [fe80::1%eth0]:5001"
    })
    void readsWhatItWrites(String text, String host, int port, String written) {
        BoatAddress address = BoatAddress.parse(text);

        assertThat(address).isEqualTo(new BoatAddress(host, port)).hasToString(written);
        assertThat(BoatAddress.parse(written)).isEqualTo(address);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "localhost",
                "localhost:",
                ":5001",
                "localhost:0",
                "localhost:65536",
                "localhost:99999999",
                "::1:5001",
                "[localhost]:5001",
                "local host:5001",
                "http://localhost:5001",
                "localhost:-1"
            })
    void refusesWhatIsNoAddressAndSaysWhatOneIs(String text) {
        assertThatThrownBy(() -> BoatAddress.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'" + text + "' is no HOST:PORT");
    }

    @Test
    void readsSeveralInTheirOrder() {
        assertThat(BoatAddress.parseAll("a:2,b:1, [::1]:3"))
                .containsExactly(new BoatAddress("a", 2), new BoatAddress("b", 1), new BoatAddress("::1", 3));
    }

    @Test
    void refusesOneThatStandsThereTwice() {
        assertThatThrownBy(() -> BoatAddress.parseAll("a:1,b:1,A:1")).hasMessage("a:1 stands there twice");
        assertThatThrownBy(() -> BoatAddress.parseAll("a:1,")).hasMessageContaining("'' is no HOST:PORT");
    }
}
