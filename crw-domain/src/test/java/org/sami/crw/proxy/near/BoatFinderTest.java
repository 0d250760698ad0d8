package org.sami.crw.proxy.near;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import javax.jmdns.JmDNS;
import javax.jmdns.ServiceInfo;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.tcp.BoatAddress;

/** Boats that announce themselves on this machine's loopback network, by real multicast: other tests may announce boats of their own there. */
@Tag("long")
class BoatFinderTest {
    private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

    private final String anna = "anna-" + UUID.randomUUID();
    private final BoatFinder finder = BoatFinder.on(List.of(LOOPBACK));

    @AfterEach
    void close() {
        finder.close();
    }

    @Test
    void boatAppearsChangesAndGoes() throws Exception {
        BoatAnnouncement first = BoatAnnouncement.of(anna, "9f86d081884c7d65", Access.PAIRING, "rudder");
        AtomicReference<BoatAnnouncement> now = new AtomicReference<>(first);
        try (BoatAnnouncer announcer = BoatAnnouncer.open(now::get, new InetSocketAddress(LOOPBACK, 4711))) {
            Await.until("the boat is found", () -> found().isPresent());
            assertThat(found()).contains(new FoundBoat(first, new BoatAddress("127.0.0.1", 4711)));

            BoatAnnouncement later = first.with(Access.PAIRED).withBattery(55);
            now.set(later);
            Await.until(
                    "its change is seen",
                    () -> found().map(FoundBoat::announcement).equals(Optional.of(later)));
            assertThat(later.batteryPercent()).isEqualTo(OptionalInt.of(55));
        }
        Await.until("it is gone", () -> found().isEmpty());
    }

    @Test
    void whatCannotBeReadIsNamedAndOthersAreFound() throws Exception {
        BoatAnnouncement bert = BoatAnnouncement.of("bert-" + anna, "", Access.OPEN, "");
        Map<String, String> entries = Map.of("id", anna, "access", "all", "link", "2");
        try (JmDNS other = LocalNetworks.open(LOOPBACK);
                BoatAnnouncer announcer = BoatAnnouncer.open(() -> bert, new InetSocketAddress(LOOPBACK, 4713))) {
            other.registerService(ServiceInfo.create(LocalNetworks.TYPE, anna, 4712, 0, 0, entries));

            Await.until(
                    "what is unreadable is named",
                    () -> finder.snapshot().unreadable().stream().anyMatch(text -> text.contains("127.0.0.1:4712")));
            Await.until(
                    "the other is found",
                    () -> finder.snapshot().boats().stream()
                            .anyMatch(boat -> boat.announcement().equals(bert)));
            assertThat(found()).isEmpty();
        }
    }

    @Test
    void addressThatIsNotOfThisMachineIsASentenceForPeople() throws Exception {
        InetAddress elsewhere = InetAddress.getByName("192.0.2.77");
        assertThatThrownBy(() -> BoatAnnouncer.open(
                        () -> BoatAnnouncement.of(anna, "", Access.OPEN, ""), new InetSocketAddress(elsewhere, 4714)))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(anna + " is not announced on the network")
                .hasMessageContaining("bases reach it by its address");
        try (BoatFinder lost = BoatFinder.on(List.of(elsewhere))) {
            Await.until("the problem is told", () -> !lost.snapshot().problems().isEmpty());
            assertThat(lost.snapshot().problems().get(0))
                    .startsWith("boats are not looked for at 192.0.2.77: ")
                    .endsWith("connect them by their addresses");
        }
    }

    private Optional<FoundBoat> found() {
        return finder.snapshot().boats().stream()
                .filter(boat -> boat.announcement().boatId().equals(anna))
                .findFirst();
    }
}
