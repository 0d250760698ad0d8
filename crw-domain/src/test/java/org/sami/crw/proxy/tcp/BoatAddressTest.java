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

    @Test
    void readsVehiclesOfALinkByTheirNumbers() {
        assertThat(BoatAddress.parseAll("mavlink:udp:14550/21-23, mavlink:serial:/dev/ttyUSB0:57600/7,"
                        + "mavlink:udp:14551?baud=57600/8,a:1"))
                .extracting(BoatAddress::toString)
                .containsExactly(
                        "mavlink:udp:14550/21",
                        "mavlink:udp:14550/22",
                        "mavlink:udp:14550/23",
                        "mavlink:serial:/dev/ttyUSB0:57600/7",
                        "mavlink:udp:14551?baud=57600/8",
                        "a:1");
        assertThat(BoatAddress.parseAll("mavlink:udpout:boat.local:14550"))
                .singleElement()
                .matches(BoatAddress::isOfEveryVehicle);
    }

    @ParameterizedTest
    @CsvSource({
        "mavlink:udp:14550/0, 'a system id is 1 to 255, not 0; '",
        "mavlink:udp:14550/20-256, 'a system id is 1 to 255, not 256; '",
        "mavlink:udp:14550/25-21, 'the first system id, 25, is above the last, 21; '",
        "mavlink:tcp:127.0.0.1:99999/1, 'a port is 1 to 65535, not 99999; '",
        "mavlink:udp:14550?baud=9/1, 'a baud rate is 1200 to 4000000, not 9; '",
        "mavlink:serial:/dev/ttyUSB0:9/1, 'a baud rate is 1200 to 4000000, not 9; '",
        "mavlink:udp:14550?speed=9600, ''",
        "mavlink:udp:127.0.0.1:14550, 'udp listens on a port of this machine and takes no host; to a host it is udpout; '",
        "mavlink:udp, 'the port is missing; '",
        "mavlink:tcp:5760, 'the host or the port is missing; '",
        "mavlink:serial:/dev/ttyUSB0, 'the device or the baud rate is missing; '",
        "mavlink:foo, 'there is no kind of link ''foo''; '",
        "mavlink:udp:14550/a, ''"
    })
    void saysWhatIsWrongWithTheAddressOfAVehicle(String text, String why) {
        assertThatThrownBy(() -> BoatAddress.parseAll("a:1," + text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("'" + text + "' is no MAVLink address: " + why + "it is mavlink:tcp:HOST:PORT");
    }
}
