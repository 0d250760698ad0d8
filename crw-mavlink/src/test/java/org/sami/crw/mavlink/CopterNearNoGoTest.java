package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.water.Water;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** A copter that has a home, and flies along a path from which the straight way home leads through a no-go area: it takes no ways home. */
@Timeout(300)
class CopterNearNoGoTest {
    private static final GeoPoint HOME = GeoPoint.of(45.7, 10.72);
    private static final GeoArea ROCK = SquareArea.of(45.7009, 10.7199, 0.0002);
    private static final List<GeoPoint> BEHIND_IT = List.of(
            new GeoPoint(45.701, 10.722, 20), new GeoPoint(45.702, 10.72, 20), new GeoPoint(45.7021, 10.72, 20));

    @TempDir
    private Path folder;

    @Test
    void fliesThere() throws Exception {
        try (SmallCopter copter = new SmallCopter(6, HOME.latDeg(), HOME.lonDeg(), 10);
                GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(copter.address() + "/6");
            world.untilReady("mav6");
            Await.until(
                    "its home is known",
                    () -> world.ask("mav6", BoatProxy::home).isPresent());

            Water water = Water.of(HOME, List.of(ROCK), Optional.empty());
            world.tell(
                    "mav6",
                    proxy -> proxy.commands()
                            .submit(new FollowPath(
                                    "path",
                                    1,
                                    1,
                                    BEHIND_IT,
                                    OptionalDouble.empty(),
                                    0,
                                    Priority.MEDIUM,
                                    false,
                                    Optional.of(water))));

            Await.until(
                    "its path has ended",
                    () -> world.has(FleetEvent.CommandCompleted.class, done -> true)
                            || world.has(FleetEvent.CommandFailed.class, failed -> true));
            assertThat(world.events.stream().filter(FleetEvent.CommandFailed.class::isInstance))
                    .isEmpty();
            assertThat(copter.nearestM(45.702, 10.72)).isLessThan(2);
        }
    }
}
