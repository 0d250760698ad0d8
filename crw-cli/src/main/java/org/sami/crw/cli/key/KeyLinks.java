package org.sami.crw.cli.key;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import org.sami.crw.cli.output.UsageFault;
import org.sami.mavlink.address.MavlinkAddress;

/** Over which links the key of a fleet may be given to vehicles: it is sent in the open. */
final class KeyLinks {
    private static final String CABLE =
            ". Connect the vehicle by its cable, and give its port, such as mavlink:serial:/dev/ttyACM0:115200";

    private KeyLinks() {}

    /**
     * Looks whether the key may be given there: over serial ports, and over TCP within this machine.
     *
     * @param overNetwork whether networks are allowed, too; ports that answer whoever sends to them are not
     * @throws UsageFault if not; its message says why and what to do
     */
    static void check(List<MavlinkAddress> addresses, boolean overNetwork) {
        for (MavlinkAddress address : addresses) {
            if (address instanceof MavlinkAddress.UdpListen) {
                throw new UsageFault(
                        "the key is not given over " + address + ": whoever sends to that port would get it" + CABLE
                                + "; or address one machine, mavlink:udpout:HOST:PORT, with --over-network");
            } else if (!overNetwork && !isCable(address)) {
                throw new UsageFault("the key is not given over " + address + ": it is sent in the open, and who reads"
                        + " along commands the fleet" + CABLE
                        + "; or say --over-network where nobody else is on that network");
            }
        }
    }

    private static boolean isCable(MavlinkAddress address) {
        return address instanceof MavlinkAddress.Serial
                || (address instanceof MavlinkAddress.Tcp tcp
                        && tcp.speedBaud().isEmpty() // else a radio is behind it
                        && isThisMachine(tcp.host()));
    }

    private static boolean isThisMachine(String host) {
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (UnknownHostException e) {
            return false;
        }
    }
}
