package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ReaderClock;
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
        try (TcpTestFleet fleet = new TcpTestFleet(logs, links())) {
            BoatOnTcp boat = fleet.boat("anna", new ReaderClock());
            Base base = fleet.base("base");
            base.connect(boat.address(), "anna");
            Await.until(
                    "it has said its errors",
                    () -> base.ask("anna", BoatProxy::error).equals(Optional.of(CrossTrackError.CALM)));
            Await.until(
                    "it has said where it is", () -> base.status("anna").pose().isPresent());
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

            List<GeoPoint> planned = new ArrayList<>(List.of(TcpTestFleet.PIER));
            planned.addAll(points(first(fleet, UploadWaypoints.class).waypoints()));
            assertThat(water.clearanceM(planned)).isGreaterThan(0.6);
            // Not the lines between them: a base that hears nothing for some seconds does not see a boat turn.
            assertThat(driven)
                    .isNotEmpty()
                    .allSatisfy(place -> assertThat(water.clearanceM(place)).isPositive());
            SetWaysHome sent = first(fleet, SetWaysHome.class);
            List<List<Waypoint>> fromTheEnd = sent.ways().get(sent.ways().size() - 1);
            assertThat(fromTheEnd).isNotEmpty().allSatisfy(way -> {
                List<GeoPoint> home = new ArrayList<>(List.of(at(0, 10)));
                home.addAll(points(way));
                home.add(TcpTestFleet.PIER);
                assertThat(water.clearanceM(home)).isGreaterThan(0.6);
            });
        }
    }

    private static List<GeoPoint> points(List<Waypoint> waypoints) {
        return waypoints.stream()
                .map(waypoint -> GeoPoint.of(waypoint.latDeg(), waypoint.lonDeg()))
                .toList();
    }

    /** The first command of its kind that the boat has executed; after a link that was lost there may be more. */
    private static <C extends CommandMessage> C first(TcpTestFleet fleet, Class<C> kind) throws IOException {
        return fleet.log("anna").stream()
                .map(entry -> entry.command())
                .filter(kind::isInstance)
                .map(kind::cast)
                .findFirst()
                .orElseThrow();
    }
}
