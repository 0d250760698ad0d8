package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** One vehicle on two links of a session, and two vehicles of one id. */
@Timeout(900)
class TwoLinksTest {
    private static final int AUTO = 10;
    private static final double TIMES = 8;
    private static final List<GeoPoint> PATH = List.of(
            GeoPoint.of(45.7003, 10.72),
            GeoPoint.of(45.7003, 10.7204),
            GeoPoint.of(45.7, 10.7204),
            GeoPoint.of(45.6997, 10.72));

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private GatewayWorld world;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(7, 45.7, 10.72, TIMES);
        world = new GatewayWorld(folder);
    }

    @AfterEach
    void end() throws Exception {
        world.close();
        boat.close();
        assertThat(world.faults).isEmpty();
    }

    private void untilSaid(String words) {
        Await.until(words, GatewayWorld.WAIT_S, () -> world.alarms.stream().anyMatch(text -> text.contains(words)));
    }

    private void connectBoth(String number) {
        world.connect(boat.address() + number);
        world.untilReady("mav7");
        world.connect(boat.secondAddress() + number);
        untilSaid("mav7 is heard on " + boat.secondAddress() + " too");
    }

    @ParameterizedTest
    @ValueSource(strings = {"/7", ""})
    void vehicleThatLosesOneLinkOnItsPathDrivesOnAndNothingIsDoneTwice(String number) throws Exception {
        connectBoth(number);
        Await.until(
                "the second address leads to it",
                () -> world.links().size() == 2
                        && world.links().stream()
                                .allMatch(link -> link.boatId().equals(java.util.Optional.of("mav7"))));
        world.tell("mav7", proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, PATH, Priority.MEDIUM)));
        Await.until(
                "a point is visited",
                GatewayWorld.WAIT_S,
                () -> boat.mission().visited().size() == 1);

        boat.cut(true);
        untilSaid("mav7 is commanded over " + boat.secondAddress() + " from now on: " + boat.address() + " has been");
        boat.cut(false);
        boat.cutSecond(true);
        Await.until(
                "it has driven its path",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.CommandCompleted.class, done -> true));

        assertThat(boat.armings()).isEqualTo(1);
        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(boat.mission().visited()).doesNotHaveDuplicates();
        assertThat(boat.orderedModes()).filteredOn(mode -> mode == AUTO).hasSize(1);
        assertThat(world.has(
                        FleetEvent.LinkChanged.class, change -> change.status().link() == LinkState.LOST))
                .isFalse();
    }

    @Test
    void orderOverTheRemainingLinkIsCarriedOut() throws Exception {
        connectBoth("/7");
        boat.cut(true);
        world.tell("mav7", proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, PATH, Priority.MEDIUM)));

        Await.until(
                "it has driven its path",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.CommandCompleted.class, done -> true));
        assertThat(boat.armings()).isEqualTo(1);
        assertThat(boat.mission().visited()).doesNotHaveDuplicates();
    }

    @Test
    void linksOfTheVehicleAreReportedWithLossAndWhatIsAsked() throws Exception {
        connectBoth("/7");
        Await.until(
                "both are reported", GatewayWorld.WAIT_S, () -> linkStatuses().size() == 2);
        assertThat(linkStatuses().get(0).words())
                .startsWith("in use, ")
                .contains("% lost")
                .endsWith(" bytes/s asked");
        assertThat(linkStatuses().get(1).words()).startsWith("ready, ").endsWith("% lost");

        boat.cut(true);
        Await.until(
                "the other one is used",
                GatewayWorld.WAIT_S,
                () -> linkStatuses().get(0).link().equals(boat.secondAddress()));
        Await.until(
                "the first one is not good",
                GatewayWorld.WAIT_S,
                () -> !linkStatuses().get(1).isGood());
    }

    private List<LinkStatus> linkStatuses() {
        return world.links().get(0).linkStatuses();
    }

    @Test
    void textOfTheVehicleIsToldOnce() {
        connectBoth("/7");
        boat.says(2, "Leak detected");
        boat.says(2, "the end");
        untilSaid("the end");

        assertThat(world.alarms)
                .filteredOn(text -> text.contains("Leak detected"))
                .hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/7", ""})
    void anotherVehicleOfTheSameIdIsRefusedAndBothLinksAreNamed(String number) throws Exception {
        try (SmallBoat twin = new SmallBoat(7, 45.71, 10.72, TIMES)) {
            world.connect(boat.address() + number);
            world.untilReady("mav7");
            world.connect(twin.address() + number);
            untilSaid("another vehicle has the id of mav7: one is heard on " + boat.address() + ", the other on "
                    + twin.address());
            Await.until(
                    "the second is refused",
                    GatewayWorld.WAIT_S,
                    () -> world.links().stream()
                            .anyMatch(link -> link.lastEvent()
                                    .contains("the vehicle there has the id 7, as another one on " + boat.address())));

            world.tell("mav7", proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, PATH, Priority.MEDIUM)));
            Await.until(
                    "the first drives",
                    GatewayWorld.WAIT_S,
                    () -> world.has(FleetEvent.CommandCompleted.class, done -> true));
            assertThat(twin.armings()).isZero();
            assertThat(twin.movedM()).isZero();
            assertThat(twin.orderedModes()).isEmpty();
        }
    }

    @Test
    void vehicleThatWasGivenUpIsReachedAgainByItsOtherAddress() throws Exception {
        connectBoth("/7");
        world.remove("mav7");
        boat.cut(true);

        world.connect(boat.secondAddress() + "/7");
        world.untilReady("mav7");
    }
}
