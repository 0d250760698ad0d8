package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;

/** A long path for a vehicle that has room for all of it: over a network it is sent whole, where a radio is behind that only a part of it. */
@Timeout(900)
class SlowLinkTest {
    private static final List<Waypoint> PATH = IntStream.range(0, 1_000)
            .mapToObj(i -> new Waypoint(45.7 + i * 2e-5, 10.72, 1))
            .toList();

    @TempDir
    private Path folder;

    private SmallBoat boat;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 150);
        boat.mission().room(2 * PATH.size());
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    private int itemsAfterUpload(LinkClient client) {
        assertThat(client.ask(new UploadWaypoints("upload", "long", PATH))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(PATH));
        return boat.mission().size();
    }

    @Test
    void networkBringsAllOfIt() throws Exception {
        try (LinkClient client = new LinkClient(folder, boat.address() + "/5")) {
            assertThat(itemsAfterUpload(client)).isGreaterThan(PATH.size());
        }
    }

    @Test
    void networkWhoseAddressNamesARadioBehindItBringsAPart() throws Exception {
        try (LinkClient client = new LinkClient(folder, boat.address() + "?baud=57600/5")) {
            assertThat(itemsAfterUpload(client)).isLessThanOrEqualTo(MissionWindow.MOST_WHOLE);
        }
    }

    @Test
    void networkOnWhichARadioReportsItselfBringsAPart() throws Exception {
        try (LinkClient client = new LinkClient(folder, boat.address() + "/5")) {
            boat.sends(SensorMessages.radio(180));
            Await.until(
                    "the radio is known",
                    () -> client.linkStatuses().stream()
                            .anyMatch(link -> link.filledPart().isPresent()));

            assertThat(itemsAfterUpload(client)).isLessThanOrEqualTo(MissionWindow.MOST_WHOLE);
        }
    }
}
