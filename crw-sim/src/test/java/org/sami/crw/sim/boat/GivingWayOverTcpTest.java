package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.BoatPose;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Boats behind TCP, in still water with exact instruments: what one knows of the other comes from the base alone. */
class GivingWayOverTcpTest {
    /** 3 m, less what boats go between two looks of the base on a busy machine; without being told of each other they meet. */
    private static final double APART_M = 2;

    @TempDir
    Path logs;

    private static GeoPoint north(double metres) {
        return Geodesy.offset(TcpTestFleet.PIER, 0, metres);
    }

    @Test
    void boatsThatMeetHeadOnPassEachOtherByWhatTheirBaseRelays() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs)) {
            BoatOnTcp anna = fleet.boat("anna", north(0));
            BoatOnTcp bert = fleet.boat("bert", north(16));
            Base base = fleet.base("base");
            base.connect(anna.address(), "anna");
            base.connect(bert.address(), "bert");
            double[] leastM = {Double.MAX_VALUE};

            base.submit("anna", way("m1", 16));
            base.submit("bert", way("m2", 0));
            Await.until("both have passed", 90, () -> {
                leastM[0] = Math.min(leastM[0], distanceM(base));
                return base.count("anna completed m1") == 1 && base.count("bert completed m2") == 1;
            });

            assertThat(leastM[0]).isBetween(APART_M, 15.0);
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
