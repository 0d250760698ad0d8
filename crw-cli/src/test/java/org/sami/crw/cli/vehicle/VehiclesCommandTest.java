package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallVehicle;

/** {@code crw vehicles} against a small vehicle on loopback. */
@Timeout(900)
class VehiclesCommandTest {
    private static final String NOBODY = "mavlink:tcp:127.0.0.1:1";

    @Test
    void vehicleIsListedWithItsLinkItsWordsAndWhatItHolds() throws Exception {
        try (SmallVehicle vehicle = new SmallVehicle(7, 2, false)) {
            CommandResult ran = CommandResult.crw("vehicles", "--for", "10", "--held", vehicle.address());

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out().lines())
                    .anyMatch(
                            line -> line.matches(
                                    "7 +boat +ArduPilot +HOLD +no +45.700000, 10.720000 +0.5 m/s +87 %, 12.6 V +3D, 9 sat +.* s ago"))
                    .anyMatch(
                            line -> line.startsWith(vehicle.address() + ": ") && line.endsWith(" messages, 0.0 % lost"))
                    .contains("7 says (warning): PreArm: safety switch")
                    .contains("7 holds this mission:")
                    .anyMatch(line -> line.matches(" +1 +nav waypoint +45.700100, 10.720000 +0.0 m"))
                    .contains("7 holds no fence")
                    .noneMatch(line -> line.contains("are commanded"));
        }
    }

    @Test
    void vehicleThatIsNotCommandedFromHereIsListedAndSaidNotToBe() throws Exception {
        try (SmallBoat vehicle = new SmallBoat(5, 45.7, 10.72, 1)) {
            vehicle.reports().isPlane();
            CommandResult ran = CommandResult.crw("vehicles", "--for", "10", vehicle.address());

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out().lines())
                    .anyMatch(line -> line.startsWith("5 ") && line.contains("plane"))
                    .contains("vehicle 5 is a plane, and here only surface boats and copters are commanded: give the"
                            + " address or number of one of these");
        }
    }

    @Test
    void parametersThatHaveChangedSinceTheyWereKeptLastAreListed(@TempDir Path folder) throws Exception {
        try (SmallBoat vehicle = new SmallBoat(5, 45.7, 10.72, 1)) {
            vehicle.parameter("FENCE_ENABLE", 1);
            String[] read = {"vehicles", "--for", "3", "--parameters", folder.toString(), vehicle.address()};
            assertThat(CommandResult.crw(read).out())
                    .contains("5 has ")
                    .contains(" parameters, kept in " + folder)
                    .doesNotContain("changed");
            assertThat(CommandResult.crw(read).out()).contains("5: none has changed since 20");

            vehicle.parameter("FENCE_ENABLE", 0);
            CommandResult ran = CommandResult.crw(read);

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out().lines())
                    .anyMatch(line -> line.matches("5: changed since 20[0-9-]+ [0-9]{2}:[0-9]{2}:"))
                    .contains("  FENCE_ENABLE 1 → 0");
            assertThat(CommandResult.crw(read).out()).contains("5: none has changed since 20");
        }
    }

    @Test
    void linkWithoutAVehicleIsNamedAndFails() {
        CommandResult ran = CommandResult.crw("vehicles", "--for", "1", NOBODY);

        assertThat(ran.exitCode()).isEqualTo(4);
        assertThat(ran.out()).contains("no vehicle was heard").contains(NOBODY + ": nobody listens there");
    }

    @Test
    void wrongAddressIsNamedWithTheFormsThereAre() {
        CommandResult ran = CommandResult.crw("vehicles", "mavlink:tcp:boat");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("the port is missing").contains("mavlink:udp:PORT");
    }
}
