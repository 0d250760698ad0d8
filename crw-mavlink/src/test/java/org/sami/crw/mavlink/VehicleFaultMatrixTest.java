package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.value.GeoPoint;

/**
 * Each fault of a vehicle, its link or its base in each phase of a path: nothing is done twice, nothing moves unasked, and the operator hears of it. The same with
 * the real firmware is {@link ArduPilotFaultMatrixTest}.
 */
@Tag("long")
@Timeout(900)
class VehicleFaultMatrixTest {
    private static final double TIMES = 8;
    private static final double NEAR_M = 3;
    private static final int NUMBER = 7;
    private static final int START_BEATS = 4; // after a start, before it says where it is
    private static final GeoPoint START = GeoPoint.of(45.7, 10.72);
    private static final List<GeoPoint> PATH =
            List.of(GeoPoint.of(45.7003, 10.72), GeoPoint.of(45.7003, 10.7204), GeoPoint.of(45.7, 10.7204));
    private static final int ANSWERS_UNTIL_BEGUN = 2; // how many items it has, and the first item that it wants
    private static final int ANSWERS_UNTIL_HALF = 5;
    private static final int ANSWERS_UNTIL_UPLOADED =
            8; // home, speed, three waypoints, the item that keeps the place; not read back

    @TempDir
    private Path folder;

    private static Stream<FaultCase> cases() {
        return FaultCase.all();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void nothingIsDoneTwiceOrUnaskedAndItIsTold(FaultCase what) throws Exception {
        try (StandIn boat = new StandIn();
                FaultCourse course = new FaultCourse(what, boat, folder)) {
            course.run();
        }
    }

    /** The small boat of the tests. */
    private static final class StandIn implements FaultyVehicle, AutoCloseable {
        private final SmallBoat boat = new SmallBoat(NUMBER, START.latDeg(), START.lonDeg(), TIMES);
        private double markM;
        private boolean isOrderHeld;
        private boolean isUploadHeld;

        StandIn() throws IOException {
            boat.reports().startsInSteps(START_BEATS);
        }

        @Override
        public String name() {
            return "mav" + NUMBER;
        }

        @Override
        public String address() {
            return boat.address() + "/" + NUMBER;
        }

        @Override
        public List<GeoPoint> path() {
            return PATH;
        }

        @Override
        public void holdAt(FaultCase.Phase phase) {
            isOrderHeld = phase == FaultCase.Phase.STARTING;
            boat.faults().ignoresOrders(isOrderHeld);
            switch (phase) {
                case UPLOAD_BEGUN -> holdAfter(ANSWERS_UNTIL_BEGUN);
                case UPLOAD_HALF -> holdAfter(ANSWERS_UNTIL_HALF);
                case UPLOADED -> holdAfter(ANSWERS_UNTIL_UPLOADED);
                default -> {
                    // it is reached without that
                }
            }
        }

        private void holdAfter(int answers) {
            isUploadHeld = true;
            boat.faults().answersAboutMissions(answers);
        }

        @Override
        public boolean isHeld() {
            return (!isUploadHeld || boat.faults().answersLeft() == 0)
                    && (!isOrderHeld || boat.faults().ignoredOrders() > 0);
        }

        @Override
        public void letOn() {
            boat.faults().answersAboutMissions(Integer.MAX_VALUE);
            boat.faults().ignoresOrders(false);
        }

        @Override
        public void begin(FaultCase.Fault fault) throws IOException {
            switch (fault) {
                case LINK_CUT -> boat.cut(true);
                case VEHICLE_STANDS_STILL -> boat.faults().frozen(true);
                case REBOOT -> boat.restart();
                case BASE_KILLED -> throw new IllegalArgumentException("that is no fault of the vehicle");
            }
        }

        @Override
        public void end(FaultCase.Fault fault) throws IOException {
            boat.cut(false);
            boat.faults().frozen(false);
        }

        @Override
        public void deaf(boolean now) {
            boat.faults().deaf(now);
        }

        @Override
        public boolean isArmed() {
            return boat.isArmed();
        }

        /** It has no checks. */
        @Override
        public boolean isReady() {
            return true;
        }

        @Override
        public int armings() {
            return boat.armings();
        }

        @Override
        public int uploads() {
            return boat.mission().uploads();
        }

        @Override
        public void markPlace() {
            markM = boat.movedM();
        }

        @Override
        public double movedM() {
            return boat.movedM() - markM;
        }

        @Override
        public void assertLiesStill() {
            assertThat(movedM()).isZero();
        }

        @Override
        public int visits() {
            return boat.mission().visited().size();
        }

        /** One that is sent on while it is on its way to the last place goes there in GUIDED, without its mission. */
        @Override
        public void assertVisitedOnceInOrder() {
            assertThat(boat.mission().visited()).doesNotHaveDuplicates().hasSizeBetween(PATH.size() - 1, PATH.size());
            PATH.forEach(point ->
                    assertThat(boat.nearestM(point.latDeg(), point.lonDeg())).isLessThan(NEAR_M));
        }

        @Override
        public void close() throws IOException {
            boat.faults().frozen(false);
            boat.close();
        }
    }
}
