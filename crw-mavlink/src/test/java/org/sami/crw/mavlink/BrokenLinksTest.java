package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.MavlinkLinkState;
import org.sami.mavlink.testing.SmallBoat;

@Timeout(900)
class BrokenLinksTest {
    private final BrokenLinks broken = new BrokenLinks();

    private static MavlinkLinkReport link(String address, MavlinkLinkState state) {
        return new MavlinkLinkReport(
                AddressText.parse(address),
                state,
                Optional.empty(),
                Map.of(),
                0,
                0,
                0,
                Map.of(),
                false,
                Optional.empty(),
                Optional.empty());
    }

    private List<String> look(MavlinkLinkState first, MavlinkLinkState second) {
        return broken.found(List.of(link("mavlink:udp:1", first), link("mavlink:udp:2", second))).stream()
                .map(each -> each.address().toString())
                .toList();
    }

    @Test
    void eachIsFoundOnceUntilItIsOpenAgain() {
        assertThat(look(MavlinkLinkState.BROKEN, MavlinkLinkState.OPEN)).isEmpty();
        assertThat(look(MavlinkLinkState.BROKEN, MavlinkLinkState.BROKEN)).containsExactly("mavlink:udp:1");
        assertThat(look(MavlinkLinkState.BROKEN, MavlinkLinkState.OPEN)).isEmpty();
        assertThat(look(MavlinkLinkState.OPEN, MavlinkLinkState.BROKEN)).isEmpty();
        assertThat(look(MavlinkLinkState.BROKEN, MavlinkLinkState.BROKEN)).containsExactly("mavlink:udp:2");
        assertThat(look(MavlinkLinkState.BROKEN, MavlinkLinkState.BROKEN)).containsExactly("mavlink:udp:1");
    }

    @Test
    void linkThatIsGoneUnderAConnectedVehicleIsSaidWithItsReason(@TempDir Path folder) throws Exception {
        SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/5")) {
            boat.close();

            client.untilAlarm(boat.address() + " does not work: ");
        }
    }
}
