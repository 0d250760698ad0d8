package org.sami.crw.cli.key;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.testing.SmallBoat;

/** The secret of a fleet's key leaves this machine over cables only, unless its owner says that a network is theirs alone. */
@Timeout(300)
class FleetKeyGivingTest {
    @TempDir
    private Path folder;

    private CommandResult give(String address, String... more) {
        String[] all = new String[6 + more.length];
        System.arraycopy(
                new String[] {"keys", "fleet", "--keys", folder.resolve("keys").toString(), "--give", address},
                0,
                all,
                0,
                6);
        System.arraycopy(more, 0, all, 6, more.length);
        return CommandResult.crw(all);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "mavlink:udp:14999",
                "mavlink:udpout:127.0.0.1:14999",
                "mavlink:tcp:192.0.2.1:5760",
                "mavlink:tcp:127.0.0.1:5760?baud=57600"
            })
    void networkIsRefusedWithWhyAndWhatToDoAndNoKeyIsMade(String address) {
        CommandResult ran = give(address, "--new");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err())
                .contains("the key is not given over " + address)
                .contains("by its cable")
                .contains("--over-network");
        assertThat(folder.resolve("keys")).doesNotExist();
    }

    @Test
    void portThatAnswersWhoeverSendsToItIsRefusedEvenWhereTheNetworkIsTheOwnersAlone() {
        CommandResult ran = give("mavlink:udp:14999", "--over-network");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("whoever sends to that port would get it");
    }

    @Test
    void otherMachineIsSpokenToOnlyWhereTheNetworkIsTheOwnersAlone() throws Exception {
        try (DatagramSocket vehicle = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            vehicle.setSoTimeout(1);
            DatagramPacket packet = new DatagramPacket(new byte[300], 300);
            String address = "mavlink:udpout:127.0.0.1:" + vehicle.getLocalPort();

            assertThat(give(address).exitCode()).isEqualTo(2);
            assertThatThrownBy(() -> vehicle.receive(packet)).isInstanceOf(SocketTimeoutException.class);

            CommandResult allowed = give(address, "--over-network");
            assertThat(allowed.out()).contains("no vehicle was heard");
            vehicle.receive(packet);
        }
    }

    @Test
    void vehicleOnThisMachineIsSpokenTo() throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1)) {
            CommandResult ran = give(boat.address());

            assertThat(ran.out()).as(ran.err()).contains("vehicle 7");
        }
    }
}
