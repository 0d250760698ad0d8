package org.sami.mavlink.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Whom a UDP port answers that listens. */
@Timeout(60)
class UdpStreamsTest {
    private static final int MORE_THAN_KEPT = 65;

    private static void say(DatagramSocket from, UdpStreams to, int port) throws IOException {
        from.send(new DatagramPacket(new byte[] {1}, 1, InetAddress.getLoopbackAddress(), port));
        assertThat(to.in().read()).isEqualTo(1);
    }

    private static int heard(DatagramSocket socket) throws IOException {
        DatagramPacket packet = new DatagramPacket(new byte[1], 1);
        socket.receive(packet);
        return packet.getData()[0];
    }

    @Test
    void answersTheNewestStationHoweverManyCameBefore() throws IOException {
        int port;
        try (DatagramSocket free = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        List<DatagramSocket> stations = new ArrayList<>();
        try {
            UdpStreams boat = UdpStreams.listen(port);
            for (int i = 0; i < MORE_THAN_KEPT; i++) {
                stations.add(new DatagramSocket(0, InetAddress.getLoopbackAddress()));
                say(stations.get(i), boat, port);
            }
            boat.out().write(new byte[] {2}, 0, 1);
            assertThat(heard(stations.get(MORE_THAN_KEPT - 1))).isEqualTo(2);

            say(stations.get(0), boat, port); // it was the longest silent one, and forgotten
            boat.out().write(new byte[] {3}, 0, 1);
            assertThat(heard(stations.get(0))).isEqualTo(3);
            boat.close();
        } finally {
            stations.forEach(DatagramSocket::close);
        }
    }
}
