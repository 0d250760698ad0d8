package org.sami.crw.mavlink;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.mavlink.FaultCase.Fault;
import org.sami.crw.mavlink.FaultCase.Phase;
import org.sami.mavlink.testing.ArduPilotBoats;

/**
 * As {@link VehicleFaultMatrixTest}, with the real firmware for boats: a few cases where it is installed, and all with {@code -PvehicleMissions}, as they take
 * minutes. One boat goes from case to case.
 */
@Tag("long")
@Timeout(1800)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ArduPilotFaultMatrixTest {
    private static final int NUMBER = 74; // far from where somebody tries one by hand
    private static final int SPEED = 10;

    private static final List<FaultCase> FEW = List.of(
            new FaultCase(Fault.LINK_CUT, Phase.UPLOAD_HALF),
            new FaultCase(Fault.VEHICLE_STANDS_STILL, Phase.UNDER_WAY),
            new FaultCase(Fault.BASE_KILLED, Phase.HALF_WAY));

    @TempDir
    private static Path work;

    private Optional<RealFaultyBoat> boat = Optional.empty();

    private static Stream<FaultCase> cases() {
        return FaultCase.all().filter(each -> Boolean.getBoolean("crw.vehicleMissions") || FEW.contains(each));
    }

    @BeforeEach
    void launch() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        if (boat.isEmpty()) {
            boat = Optional.of(new RealFaultyBoat(NUMBER, SPEED, work));
        }
        boat.get().reset();
    }

    @AfterAll
    void end() throws Exception {
        if (boat.isPresent()) {
            boat.get().close();
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void nothingIsDoneTwiceOrUnaskedAndItIsTold(FaultCase what, @TempDir Path folder) throws Exception {
        try (FaultCourse course = new FaultCourse(what, boat.orElseThrow(), folder)) {
            course.run();
        }
    }
}
