package org.sami.mavlink.address;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MavlinkAddressTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "mavlink:tcp:127.0.0.1:5760",
                "mavlink:udp:14550",
                "mavlink:udpout:192.168.4.1:14550",
                "mavlink:serial:/dev/ttyUSB0:57600",
                "mavlink:serial:COM3:115200",
                "mavlink:tcp:::1:5760",
                "mavlink:tcp:127.0.0.1:5760?baud=57600",
                "mavlink:udp:14550?baud=57600",
                "mavlink:udpout:192.168.4.1:14550?baud=115200"
            })
    void addressIsWrittenAsItIsRead(String text) {
        assertThat(AddressText.parse(text)).hasToString(text);
    }

    @Test
    void partsAreThoseOfItsForm() {
        assertThat(AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600"))
                .isEqualTo(new MavlinkAddress.Serial("/dev/ttyUSB0", 57_600));
        assertThat(AddressText.parse("mavlink:tcp:boat.local:5760"))
                .isEqualTo(new MavlinkAddress.Tcp("boat.local", 5_760));
        assertThat(AddressText.parse("mavlink:udp:14550?baud=57600").speedBaud())
                .hasValue(57_600);
        assertThat(AddressText.parse("mavlink:udp:14550").speedBaud()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "mavlink:tpc:localhost:5760 | no kind of link \"tpc\"",
                "mavlink:tcp:localhost | the port is missing",
                "mavlink:tcp::5760 | the host is missing",
                "mavlink:udp:70000 | a port is 1 to 65535, not 70000",
                "mavlink:udp:127.0.0.1:14550 | udp listens on a port of this machine and takes no host",
                "mavlink:udp:x | no whole number: x",
                "mavlink:serial:/dev/ttyUSB0 | the baud rate is missing",
                "mavlink:serial:/dev/ttyUSB0:9 | a baud rate is 1200 to 4000000, not 9",
                "mavlink:serial:/dev/ttyUSB0:57600?baud=57600 | a serial port has its baud rate",
                "mavlink:udp:14550?baud=9 | a baud rate is 1200 to 4000000, not 9",
                "mavlink:udp:14550?baud= | the baud rate is missing",
                "mavlink:udp:14550?speed=9600 | after the port stands ?baud=N or nothing, not ?speed=9600",
                "127.0.0.1:5760 | it does not begin with mavlink:"
            })
    void whatIsWrongIsNamedWithTheFormsThereAre(String text, String why) {
        assertThatThrownBy(() -> AddressText.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("\"" + text + "\"")
                .hasMessageContaining(why)
                .hasMessageContaining(MavlinkAddress.FORMS);
    }
}
