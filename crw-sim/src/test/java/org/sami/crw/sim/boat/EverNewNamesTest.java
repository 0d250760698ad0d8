package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.link.LinkAlarm;

/** What answers under another name at each connection. */
@Timeout(900)
class EverNewNamesTest {
    private static final int MOST = 8;

    @TempDir
    private Path folder;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @Test
    void oneAddressBringsSoManyNewBoatsAndTheRestIsCountedAndAlarmed() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(folder, links());
                MalformedPeer peer = new MalformedPeer(
                        fleet.kindOfLinks().ofPeer("name"),
                        (connection, to) -> to.write(LinkCodec.STANDARD.encode(
                                0, new Welcome("name" + connection, "boot", Role.OBSERVER, ""))))) {
            TcpTestFleet.Base base = fleet.base("base");
            base.tcp.connect(peer.address());

            Await.until(
                    "two were refused",
                    () -> base.alarms.stream().anyMatch(alarm -> alarm.text().contains("2 were not taken")));

            assertThat(base.alarms)
                    .filteredOn(alarm -> alarm.kind() == LinkAlarm.Kind.EVER_NEW_BOATS)
                    .extracting(LinkAlarm::text)
                    .allMatch(text -> text.contains(":" + peer.address().getPort() + " under ever new names; "));
            List<String> boats = base.tcp
                    .query(known -> known.all().stream()
                            .map(boat -> boat.boatId())
                            .filter(name -> name.startsWith("name"))
                            .toList())
                    .get(60, TimeUnit.SECONDS);
            assertThat(boats).hasSize(MOST);
            // Between two refusals the link connects once more, and says that.
            Await.until(
                    "the link says why", () -> base.links().get(0).lastEvent().contains("ever new names"));
        }
    }
}
