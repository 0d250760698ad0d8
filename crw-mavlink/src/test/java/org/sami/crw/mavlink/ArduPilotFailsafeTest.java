package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The failsafes of the real firmware of boats, as a base reports them. */
@Tag("long")
@Timeout(900)
class ArduPilotFailsafeTest {
    private static final int NUMBER = 102;
    private static final int SPEED = 5;
    private static final VehicleId ID = new VehicleId(NUMBER + 1, 1);
    private static final String BOAT = "mav" + ID;

    @TempDir
    private Path work;

    @Test
    void lowBatteryIsItsOwnFailsafeAndACriticalBattery() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boat =
                        ArduPilotBoats.with("BATT_LOW_VOLT 11.5\nBATT_FS_LOW_ACT 1\n", NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"));
                MavlinkBase other = new MavlinkBase(
                        List.of(AddressText.parse("mavlink:tcp:127.0.0.1:" + ArduPilotBoats.secondPort(NUMBER))),
                        ProcessClock::ms)) {
            world.connect(ArduPilotBoats.address(NUMBER) + "/" + ID);
            world.untilReady(BOAT);
            GeoPoint here =
                    world.ask(BOAT, proxy -> proxy.status().pose().orElseThrow().position());
            world.tell(
                    BOAT,
                    proxy -> proxy.commands()
                            .submit(FollowPath.of(
                                    "far",
                                    1,
                                    1,
                                    List.of(GeoPoint.of(here.latDeg() + 0.01, here.lonDeg())),
                                    Priority.MEDIUM)));
            world.until("it is under way", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.PATH)));
            Await.until(
                    "the other station hears it", () -> !other.vehicles().join().isEmpty());

            other.setParameter(ID, "SIM_BATT_VOLTAGE", 11).join();

            world.until("it acts by itself", BOAT, proxy -> !proxy.isCommanding());
            assertThat(world.alarms)
                    .anySatisfy(text -> assertThat(text)
                            .startsWith(BOAT + " is taken by its own failsafe \"Battery 1 is low 1")
                            .contains("(RTL)"));
            world.until("its battery is critical", BOAT, ArduPilotFailsafeTest::isCritical);
        }
    }

    private static boolean isCritical(BoatProxy proxy) {
        return proxy.status()
                .battery()
                .filter(now -> now.level() == BatteryLevel.CRITICAL)
                .isPresent();
    }
}
