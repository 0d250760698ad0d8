package org.sami.mavlink.link;

import java.io.IOException;
import org.sami.mavlink.address.MavlinkAddress;

/** Opens links by their addresses. */
final class LinkOpener {
    private LinkOpener() {}

    /**
     * Opens a link; may take seconds.
     *
     * @throws IOException if it cannot be opened; the message says why, in words for people
     */
    static LinkStreams open(MavlinkAddress address) throws IOException {
        if (address instanceof MavlinkAddress.Tcp tcp) {
            return TcpStreams.connect(tcp.host(), tcp.port());
        } else if (address instanceof MavlinkAddress.UdpListen udp) {
            return UdpStreams.listen(udp.port());
        } else if (address instanceof MavlinkAddress.UdpSend udp) {
            return UdpStreams.to(udp.host(), udp.port());
        } else if (address instanceof MavlinkAddress.Serial serial) {
            return SerialStreams.open(serial.device(), serial.baud());
        }
        throw new IllegalArgumentException(address.toString());
    }
}
