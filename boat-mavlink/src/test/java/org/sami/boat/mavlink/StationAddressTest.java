package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StationAddressTest {
    @ParameterizedTest
    @CsvSource({
        "udp:10.0.0.2:14550, mavlink:udpout:10.0.0.2:14550",
        "mavlink:udp:10.0.0.2:14550, mavlink:udpout:10.0.0.2:14550",
        "udpout:10.0.0.2:14550, mavlink:udpout:10.0.0.2:14550",
        "udp:14550, mavlink:udp:14550",
        "tcp:localhost:5760, mavlink:tcp:localhost:5760",
        "serial:/dev/ttyUSB0:57600, mavlink:serial:/dev/ttyUSB0:57600"
    })
    void readsWhatPeopleWrite(String text, String address) {
        assertThat(StationAddress.parse(text)).hasToString(address);
    }

    @ParameterizedTest
    @CsvSource({
        "'', there is no kind of link",
        "udp:host:0, a port is 1 to 65535",
        "udp:host:x, the port is no whole number: x",
        "http://host, there is no kind of link \"http\""
    })
    void saysWhatIsWrong(String text, String why) {
        assertThatThrownBy(() -> StationAddress.parse(text))
                .hasMessageStartingWith("\"" + text + "\" is no address of a ground station: " + why)
                .hasMessageContaining("udp:HOST:PORT");
    }
}
