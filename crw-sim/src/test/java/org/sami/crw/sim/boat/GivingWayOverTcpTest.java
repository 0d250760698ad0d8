package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Boats behind TCP, in still water with exact instruments: what one knows of the other comes from the base alone. */
@Tag("long")
class GivingWayOverTcpTest {
    /** 3 m, less what boats go between two looks of the base on a busy machine; without being told of each other they meet. */
    private static final double APART_M = 2;

    /** Boats live so many times slower than the process runs, whose threads a busy machine holds up. */
    private static final int SLOWER = 2;

    @TempDir
    Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    private static GeoPoint north(double metres) {
        return at(0, metres);
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TcpTestFleet.PIER, eastM, northM);
    }

    @Test
    void boatsThatMeetHeadOnPassEachOtherByWhatTheirBaseRelays() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs, () -> ProcessClock.ms() / SLOWER, links())) {
            BoatOnTcp anna = fleet.boat("anna", north(0));
            BoatOnTcp bert = fleet.boat("bert", north(16));
            Base base = fleet.base("base");
            base.connect(anna.address(), "anna");
            base.connect(bert.address(), "bert");
            double[] leastM = {Double.MAX_VALUE};

            base.submit("anna", way("m1", 16));
            base.submit("bert", way("m2", 0));
            Await.until("both have passed", 300, () -> {
                leastM[0] = Math.min(leastM[0], distanceM(base));
                return base.count("anna completed m1") == 1 && base.count("bert completed m2") == 1;
            });

            assertThat(leastM[0]).isBetween(APART_M, 15.0);
        }
    }

    /** The second boat has to give way, and would do so to starboard, where the rock lies. */
    @Test
    void boatThatGivesWayBesideARockStaysOutOfItByWhatItsBaseTells() throws Exception {
        List<GeoPoint> rock = List.of(at(-6, -10), at(-0.9, -10), at(-0.9, 30), at(-6, 30)); // west of both ways
        Water water = Water.of(TcpTestFleet.PIER, List.of(new GeoArea(rock, List.of())), Optional.empty())
                .drivenWith(CrossTrackError.CALM);
        try (TcpTestFleet fleet = new TcpTestFleet(logs, () -> ProcessClock.ms() / SLOWER, links())) {
            BoatOnTcp anna = fleet.boat("anna", north(0));
            BoatOnTcp bert = fleet.boat("bert", north(16));
            Base base = fleet.base("base");
            base.connect(anna.address(), "anna");
            base.connect(bert.address(), "bert");
            List<GeoPoint> driven = new ArrayList<>();

            base.submit("anna", way("m1", 16).in(water));
            base.submit("bert", way("m2", 0).in(water));
            Await.until("they have passed each other", 300, () -> {
                Optional<GeoPoint> first = base.status("anna").pose().map(BoatPose::position);
                Optional<GeoPoint> second = base.status("bert").pose().map(BoatPose::position);
                second.ifPresent(driven::add);
                return first.isPresent()
                        && second.isPresent()
                        && first.get().latDeg() > second.get().latDeg();
            });

            assertThat(water.clearanceM(driven)).isPositive();
        }
    }

    private static FollowPath way(String id, double northM) {
        return FollowPath.of(id, 1, 1, List.of(north(northM)), Priority.MEDIUM).atSpeed(3);
    }

    private static double distanceM(Base base) {
        Optional<GeoPoint> anna = base.status("anna").pose().map(BoatPose::position);
        Optional<GeoPoint> bert = base.status("bert").pose().map(BoatPose::position);
        return anna.isEmpty() || bert.isEmpty() ? Double.MAX_VALUE : Geodesy.distanceM(anna.get(), bert.get());
    }
}
