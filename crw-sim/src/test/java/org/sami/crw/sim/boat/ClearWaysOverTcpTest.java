package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** A boat behind TCP, in still water with exact instruments, so that what it tells of itself is the truth. */
class ClearWaysOverTcpTest {
    private static final GeoArea ROCK = new GeoArea(List.of(at(-2, 4), at(2, 4), at(2, 7), at(-2, 7)), List.of());

    /** The boat lives so many times slower than the process runs, whose threads a busy machine holds up. */
    private static final int SLOWER = 3;

    @TempDir
    Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TcpTestFleet.PIER, eastM, northM);
    }

    @Test
    void boatSaysHowFarItMayBeBesideItsWayDrivesAroundTheRockAndKnowsItsWaysHome() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs, () -> ProcessClock.ms() / SLOWER, links())) {
            BoatOnTcp boat = fleet.boat("anna");
            Base base = fleet.base("base");
            base.connect(boat.address(), "anna");
            Await.until(
                    "it has said its errors",
                    () -> base.ask("anna", BoatProxy::error).equals(Optional.of(CrossTrackError.CALM)));
            Water water = Water.of(TcpTestFleet.PIER, List.of(ROCK), Optional.empty());
            List<GeoPoint> driven = new ArrayList<>();

            base.submit(
                    "anna",
                    FollowPath.of("m1", 1, 1, List.of(at(0, 10)), Priority.MEDIUM)
                            .atSpeed(3)
                            .in(water.drivenWith(CrossTrackError.CALM)));
            Await.until("it has arrived", 300, () -> {
                base.status("anna").pose().map(BoatPose::position).ifPresent(driven::add);
                return base.count("anna completed m1") == 1;
            });

            assertThat(water.clearanceM(driven)).isPositive();
            List<SetWaysHome> sent = fleet.log("anna").stream()
                    .map(entry -> entry.command())
                    .filter(SetWaysHome.class::isInstance)
                    .map(SetWaysHome.class::cast)
                    .toList();
            assertThat(sent).hasSize(1);
            List<List<Waypoint>> fromTheEnd =
                    sent.get(0).ways().get(sent.get(0).ways().size() - 1);
            assertThat(fromTheEnd).isNotEmpty().allSatisfy(way -> {
                List<GeoPoint> home = new ArrayList<>(List.of(at(0, 10)));
                way.forEach(turn -> home.add(GeoPoint.of(turn.latDeg(), turn.lonDeg())));
                home.add(TcpTestFleet.PIER);
                assertThat(water.clearanceM(home)).isGreaterThan(0.6);
            });
        }
    }
}
