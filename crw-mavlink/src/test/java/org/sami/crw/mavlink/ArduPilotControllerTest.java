package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.OtherStation;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Who takes or starts a boat of the real firmware is named: the pilot by radio control, or the other ground station. */
@Tag("long")
@Timeout(600)
class ArduPilotControllerTest {
    private static final int NUMBER = 70;
    private static final int SPEED = 5;
    private static final double BOOT_S = 300;
    private static final double WAIT_S = 60;
    private static final VehicleId ID = new VehicleId(NUMBER + 1, 1);
    private static final String SECOND = "mavlink:tcp:127.0.0.1:" + ArduPilotBoats.secondPort(NUMBER);
    private static final String BOAT = "mav" + (NUMBER + 1);
    private static final int FIRST_RADIO_PORT = 5501;
    private static final int STEERING = 1;
    private static final int THROTTLE = 3;
    private static final int SWITCH = 8;
    private static final int STATION = 252;
    private static final int MANUAL = 0;
    private static final int BEATS = 10;
    private static final int HOLD = 4;
    private static final int GUIDED = 15;
    private static final int LOW_US = 1_000;
    private static final int MIDDLE_US = 1_500;
    private static final int HIGH_US = 2_000;

    @TempDir
    private Path work;

    /** The pilot's radio control, as the simulator receives it. */
    private static final class Radio {
        private final int[] pulsesUs = new int[16];

        Radio() {
            Arrays.fill(pulsesUs, LOW_US);
            Arrays.fill(pulsesUs, 0, 4, MIDDLE_US);
            pulsesUs[SWITCH - 1] = HIGH_US;
        }

        void move(int channel, int pulseUs) throws IOException {
            pulsesUs[channel - 1] = pulseUs;
            ByteBuffer packet = ByteBuffer.allocate(2 * pulsesUs.length).order(ByteOrder.LITTLE_ENDIAN);
            Arrays.stream(pulsesUs).forEach(pulse -> packet.putShort((short) pulse));
            try (DatagramSocket socket = new DatagramSocket()) {
                socket.send(new DatagramPacket(
                        packet.array(),
                        packet.capacity(),
                        InetAddress.getLoopbackAddress(),
                        FIRST_RADIO_PORT + 10 * NUMBER));
            }
        }
    }

    @Test
    void whoTakesItAndWhoStartsItAfterAStopIsNamed() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Radio radio = new Radio();
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            prepare();
            radio.move(SWITCH, HIGH_US);
            world.connect(ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
            Await.until(
                    "it is located",
                    BOOT_S,
                    () -> world.is(BOAT, boat -> boat.status().pose().isPresent()));
            sail(world);
            try (OtherStation other = new OtherStation(STATION, ArduPilotBoats.secondPort(NUMBER) + 1)) {
                untilUnderWay(other);
                other.setMode(NUMBER + 1, MANUAL);
                untilSaid(world, "by ground station 252 (MANUAL)");

                world.until("it is somebody else's", BOAT, boat -> !boat.isCommanding());
                world.tell(BOAT, boat -> boat.handOver().takeCommand());
                untilUnderWay(other);
                radio.move(SWITCH, LOW_US);
                untilSaid(world, "by a pilot's radio control (MANUAL)");

                world.tell(BOAT, BoatProxy::fleetStop);
                world.until(
                        "it is stopped", BOAT, boat -> boat.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
                radio.move(THROTTLE, MIDDLE_US);
                radio.move(STEERING, HIGH_US);
                untilSaid(world, "armed by a pilot's radio control (HOLD) though it was stopped");
                radio.move(STEERING, MIDDLE_US);
                assertThat(world.faults).isEmpty();
            }
        }
    }

    @Test
    void pilotWhoArmsItBeforeAnythingIsOrderedHasItUntilItIsTakenBack() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Radio radio = new Radio();
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            prepare();
            radio.move(SWITCH, LOW_US);
            world.connect(ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
            Await.until(
                    "it is located",
                    BOOT_S,
                    () -> world.is(BOAT, boat -> boat.status().pose().isPresent()));

            radio.move(STEERING, HIGH_US); // the stick that arms
            world.until("it is the pilot's", BOAT, boat -> !boat.isCommanding());
            radio.move(STEERING, MIDDLE_US);

            untilSaid(world, " (MANUAL): its missions wait until you take it back");
            sail(world);
            world.tell(BOAT, boat -> boat.handOver().takeCommand());
            try (OtherStation watch = new OtherStation(STATION, ArduPilotBoats.secondPort(NUMBER) + 1)) {
                untilUnderWay(watch);
            }
            assertThat(world.faults).isEmpty();
        }
    }

    /** Its mode switch stands for HOLD at its upper end from now on, and for MANUAL at its lower one. */
    private static void prepare() {
        try (MavlinkBase base = new MavlinkBase(List.of(AddressText.parse(SECOND)), ProcessClock::ms)) {
            Await.until("it is heard", WAIT_S, () -> !base.vehicles().join().isEmpty());
            base.setParameter(ID, "MODE6", HOLD).join();
        }
    }

    private static void sail(GatewayWorld world) {
        GeoPoint start =
                world.ask(BOAT, boat -> boat.status().pose().orElseThrow().position());
        GeoPoint far = GeoPoint.of(start.latDeg() + 0.01, start.lonDeg());
        world.tell(BOAT, boat -> boat.commands().submit(FollowPath.of("path", 1, 1, List.of(far), Priority.MEDIUM)));
    }

    /** Until it has been on its way to the place for a while, so that the base has seen it: what others change before that is no news but a refusal. */
    private static void untilUnderWay(OtherStation watch) {
        Await.until("it is under way", BOOT_S, () -> watch.mode() == GUIDED && watch.beatsInMode() > BEATS);
    }

    private static void untilSaid(GatewayWorld world, String words) {
        Await.until(words, WAIT_S, () -> world.alarms.stream().anyMatch(text -> text.contains(words)));
    }
}
