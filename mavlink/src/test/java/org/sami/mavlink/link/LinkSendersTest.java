package org.sami.mavlink.link;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.common.RadioStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import org.junit.jupiter.api.Test;

class LinkSendersTest {
    private static final int RADIO = 51;
    private static final byte[] SECRET = new byte[32];

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final MavlinkConnection codec = MavlinkConnection.create(InputStream.nullInputStream(), bytes);

    private static Object heartbeat() {
        return Heartbeat.builder().mavlinkVersion(3).build();
    }

    private static Object radioStatus() {
        return RadioStatus.builder().rssi(180).build();
    }

    /** Those who sent what was written, each message once. */
    private LinkSenders senders(int messages) throws IOException {
        MessageReader reader = new MessageReader(new ByteArrayInputStream(bytes.toByteArray()), kind -> true);
        LinkSenders senders = new LinkSenders();
        for (int i = 0; i < messages; i++) {
            senders.came(reader.next());
        }
        return senders;
    }

    @Test
    void vehicleOfTheFirstVersionIsNamedThoughItsRadioSpeaksTheSecond() throws Exception {
        codec.send1(5, 1, heartbeat());
        codec.send2(RADIO, 68, radioStatus());

        LinkSenders senders = senders(2);

        assertThat(senders.fault())
                .hasValueSatisfying(words -> assertThat(words).startsWith("it speaks MAVLink 1 only"));
        assertThat(senders.faults(false)).isEqualTo(Map.of(5, SenderFault.FIRST_VERSION_ONLY));
    }

    @Test
    void oneVehicleOfTheFirstVersionLeavesTheOthersOfItsLink() throws Exception {
        codec.send1(5, 1, heartbeat());
        codec.send2(6, 1, heartbeat());

        LinkSenders senders = senders(2);

        assertThat(senders.fault()).isEmpty();
        assertThat(senders.faults(false)).isEqualTo(Map.of(5, SenderFault.FIRST_VERSION_ONLY));
    }

    @Test
    void radioAloneIsSaidToBeOne() throws Exception {
        for (int i = 0; i < 3; i++) {
            codec.send1(RADIO, 68, radioStatus());
        }

        assertThat(senders(3).fault())
                .hasValueSatisfying(words -> assertThat(words).startsWith("only a radio is heard"));
        assertThat(senders(3).faults(false)).isEmpty();
    }

    @Test
    void radioIsNotSaidToBeAloneWhereMessagesWereRefused() throws Exception {
        for (int i = 0; i < 3; i++) {
            codec.send1(RADIO, 68, radioStatus());
        }
        LinkSenders senders = senders(3);

        senders.refused();

        assertThat(senders.fault()).isEmpty();
    }

    @Test
    void vehicleThatSignsNoLongerIsNotNamed() throws Exception {
        codec.send2(5, 1, heartbeat(), 0, 7, SECRET);
        codec.send2(5, 1, heartbeat());

        assertThat(senders(2).faults(false)).isEmpty();
    }

    @Test
    void signaturesThatNobodyComparesAreNamed() throws Exception {
        codec.send2(5, 1, heartbeat(), 0, 7, SECRET);

        assertThat(senders(1).faults(false)).isEqualTo(Map.of(5, SenderFault.KEY_IS_MISSING));
        assertThat(senders(1).faults(true)).isEmpty();
    }
}
