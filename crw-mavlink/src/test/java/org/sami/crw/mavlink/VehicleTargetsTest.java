package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.SensorReport;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.value.GeoPoint;

/** What a vehicle's camera follows is a target with a number, as plans that watch for targets take it. */
@Timeout(300)
class VehicleTargetsTest {
    private static final double LAT = 45.7003;
    private static final double LON = 10.7203;
    private static final double FIVE_M = 0.000045; // of latitude

    @TempDir
    private Path folder;

    @Test
    void whatACameraFollowsIsReportedAsATarget() throws Exception {
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
                LinkClient client = new LinkClient(folder, boat.address() + "/5")) {
            boat.sends(SensorMessages.target(LAT, LON));
            Await.until("it is reported", () -> client.hasHeard(VehicleTargetsTest::isTarget));

            boat.sends(SensorMessages.target(LAT + 10 * FIVE_M, LON));
            Await.until(
                    "so is another",
                    () -> client.hasHeard(message -> isTarget(message)
                            && number(message) == SeenTargets.FIRST + 1
                            && Math.abs(((SensorReport) message).values().get(1) - LAT - 10 * FIVE_M) < 1e-7));

            assertThat(client.hasHeard(message -> isTarget(message)
                            && Math.abs(((SensorReport) message).latDeg() - 45.7) < 1e-6
                            && number(message) == SeenTargets.FIRST
                            && Math.abs(((SensorReport) message).values().get(2) - LON) < 1e-7))
                    .isTrue();
        }
    }

    private static boolean isTarget(LinkMessage message) {
        return message instanceof SensorReport report
                && report.sensor().equals("camera")
                && report.channel().equals("target")
                && report.values().size() == 3;
    }

    private static double number(LinkMessage message) {
        return ((SensorReport) message).values().get(0);
    }

    @Test
    void placesNearOneAnotherAreOneTargetWhoeverSeesThem() {
        SeenTargets seen = new SeenTargets();

        List<Integer> numbers = List.of(0, 1, 2, 8, 9, 1).stream()
                .map(steps ->
                        seen.number(GeoPoint.of(LAT + steps * FIVE_M, LON)).orElseThrow())
                .toList();

        assertThat(numbers).containsExactly(1001, 1001, 1001, 1002, 1002, 1001);
    }

    @Test
    void detectorThatSeesSomethingEverywhereEndsAtAThousand() {
        SeenTargets seen = new SeenTargets();
        for (int i = 0; i < 1_000; i++) {
            assertThat(seen.number(GeoPoint.of(i * 0.01, LON))).hasValue(SeenTargets.FIRST + i);
        }

        assertThat(seen.number(GeoPoint.of(20, LON))).isEmpty();
        assertThat(seen.number(GeoPoint.of(0, LON))).hasValue(SeenTargets.FIRST);
    }
}
