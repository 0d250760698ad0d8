package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.boat.RoughNetwork.Way;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/**
 * Links over a bad network, in the form in which TCP lets it through: delays, standstill and resets at any byte. A network that leaves out single frames, or
 * cuts at one kind of message ({@link CutLinkTest}), has to see frames: that can only be tested on plain links.
 */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
@Timeout(600)
class RoughNetworkTest {
    /** Within the header of a record or frame, within its body, behind several. */
    private static final int[] RESETS_AFTER_BYTES = {1, 4, 7, 40, 150, 600, 2500};

    @TempDir
    private Path logs;

    private TcpTestFleet fleet;
    private BoatOnTcp boat;
    private RoughNetwork network;
    private Base base;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @BeforeEach
    void sendABoatOnItsWay() throws Exception {
        fleet = new TcpTestFleet(logs, links());
        boat = fleet.boat("anna");
        network = fleet.roughNetwork(boat);
        base = fleet.base("base");
        base.connect(network.address(), "anna");
        base.submit("anna", TcpTestFleet.path("first", 1));
        base.awaitMode("anna", BoatMode.PATH);
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    private boolean drives(String path) {
        Optional<Upload> upload = base.upload("anna");
        return upload.isPresent()
                && upload.get().listId().startsWith(path + "#")
                && upload.get().state() == Upload.State.READ_BACK_EQUAL
                && base.heldListId("anna").equals(upload.map(Upload::listId))
                && base.mode("anna").equals(Optional.of(BoatMode.PATH));
    }

    private void assertNothingIsDoneTwice() throws Exception {
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
        assertThat(base.failures).isEmpty();
        assertThat(boat.refusedConnections()).isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.3})
    void listsAreReadBackEqualAndDrivenWherePacketsAreLostAndComeLater(double lost) throws Exception {
        network.lose(lost, 100);
        long before = network.late();
        double[] northM = new double[200];
        for (int i = 0; i < northM.length; i++) {
            northM[i] = 100 + 10 * i;
        }

        for (int i = 0; i < 5; i++) {
            String path = "m" + i;
            base.submit("anna", TcpTestFleet.path(path, 1, northM));
            Await.until(path + " is driven", () -> drives(path));
        }

        assertThat(network.late()).as("packets that came late").isGreaterThan(before);
        assertNothingIsDoneTwice();
    }

    @ParameterizedTest
    @EnumSource(Way.class)
    void linkThatIsResetAtAnyByteComesBackAndTheNewestListIsDriven(Way way) throws Exception {
        for (int bytes : RESETS_AFTER_BYTES) {
            long before = network.resets();
            network.resetAfter(way, bytes);
            String path = "after" + bytes;
            base.submit("anna", TcpTestFleet.path(path, 1, 1000 + bytes));

            Await.until("it is reset after " + bytes, () -> network.resets() > before);
            Await.until(path + " is driven", () -> drives(path));
        }
        assertNothingIsDoneTwice();
    }

    @Test
    void boatThatHearsNothingHoldsAlthoughItsOwnReportsArriveAndGoesOnAfterwards() throws Exception {
        network.setStill(Way.TO_BOAT, true);

        Await.until("the boat has lost its commander", () -> base.mode("anna").equals(Optional.of(BoatMode.HOLD)));
        assertThat(base.status("anna").link()).isEqualTo(LinkState.LINKED);
        base.submit("anna", TcpTestFleet.path("second", 1, 1000));
        network.setStill(Way.TO_BOAT, false);

        Await.until("the newest is driven", () -> drives("second"));
        assertNothingIsDoneTwice();
    }

    @Test
    void boatThatIsNotHeardIsShownLostAndGoesOnAfterwards() throws Exception {
        network.setStill(Way.TO_BASE, true);

        Await.until("lost", () -> base.status("anna").link() == LinkState.LOST);
        base.submit("anna", TcpTestFleet.path("second", 1, 1000));
        network.setStill(Way.TO_BASE, false);

        base.linked("anna");
        Await.until("the newest is driven", () -> drives("second"));
        assertNothingIsDoneTwice();
    }
}
