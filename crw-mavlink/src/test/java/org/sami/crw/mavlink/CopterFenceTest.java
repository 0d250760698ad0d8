package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.spn.value.GeoArea;

/** The area of a session of copters as the fence of each. */
@Timeout(900)
class CopterFenceTest {
    private static final GeoArea FIELD = SquareArea.of(45.69, 10.71, 0.02);
    private static final GeoArea TOWER = SquareArea.of(45.701, 10.721, 0.001);
    private static final List<MissionItem> FENCE = FenceItems.of(Optional.of(FIELD), List.of(TOWER));

    @TempDir
    private Path folder;

    private SmallCopter copter;
    private LinkClient client;

    @BeforeEach
    void place() throws Exception {
        copter = new SmallCopter(6, 45.7, 10.72, 10);
        client = new LinkClient(folder, copter.address() + "/6");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        copter.close();
    }

    private void isInForce() {
        Await.until("its fence is in force", () -> copter.parameter("FENCE_ENABLE") == 1);
    }

    @Test
    void areasOfASessionOfCoptersAreItsFenceWithItsOwnAltitudes() {
        client.keepTo(Optional.of(FIELD), List.of(TOWER), RobotKind.COPTER);

        isInForce();
        assertThat(FenceItems.isHeld(FENCE, copter.fence().items())).isTrue();
        assertThat(copter.parameter("FENCE_TYPE")).as("altitude and polygons").isEqualTo(5);
        assertThat(copter.parameter("FENCE_ACTION")).as("brake or land").isEqualTo(4);

        client.keepTo(Optional.empty(), List.of(), RobotKind.COPTER);
        Await.until(
                "it is taken away",
                () -> copter.parameter("FENCE_ENABLE") == 0
                        && copter.fence().items().isEmpty());
    }

    @Test
    void areasWhereBoatsAreBoundTheWaterAndNoCopter() {
        client.keepTo(Optional.of(FIELD), List.of(TOWER), RobotKind.COPTER);
        isInForce();

        client.keepTo(Optional.of(FIELD), List.of(TOWER), RobotKind.ROBOT);

        Await.until(
                "it is taken away",
                () -> copter.parameter("FENCE_ENABLE") == 0
                        && copter.fence().items().isEmpty());
    }
}
