package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.function.Consumer;

/** What a {@link SmallBoat} reports of itself and how often, and what a test makes it report. Safe for use by several threads. */
public final class SmallBoatReports {
    private static final int ALL_EVERY = 4; // steps
    private static final int POSITION_EVERY = 5; // steps, where it reports as seldom as a base asks for
    private static final int ALL_SELDOM_EVERY = 20;
    private static final int INITIALIZING = 16; // the number of that mode
    private static final int LOCATED = 16;

    private final Consumer<Object> send;
    private boolean silent;
    private boolean beating = true;
    private MavAutopilot autopilot = MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA;
    private MavType type = MavType.MAV_TYPE_SURFACE_BOAT;
    private boolean placed = true;
    private boolean seldom;
    private int filter = LOCATED;
    private double claimedMps; // reported in place of its speed
    private int charge = 87;
    private boolean batteryFails;
    private int startBeats;
    private int beatsLeft; // before it says where it is
    private long steps;

    SmallBoatReports(Consumer<Object> send) {
        this.send = send;
    }

    /**
     * What the boat is at a moment.
     *
     * @param mode its number
     * @param bootMs the time since the autopilot started, in ms
     */
    record State(
            boolean armed,
            int mode,
            boolean failsafe,
            SmallVehicleFence fence,
            SmallVehicleRadio radio,
            long bootMs,
            SmallBoatMotion motion,
            SmallBoatMission mission) {}

    /** It sends nothing at all from now on, no answers either; or sends again. */
    public synchronized void silent(boolean now) {
        silent = now;
    }

    synchronized boolean isSilent() {
        return silent;
    }

    /** It reports no more often than a base asks for, from now on: its position four times a second, all else once. */
    public synchronized void seldom() {
        seldom = true;
    }

    /** It is steered by PX4 from now on, as its heartbeats say. */
    public synchronized void steeredByPx4() {
        autopilot = MavAutopilot.MAV_AUTOPILOT_PX4;
    }

    /** It is a plane from now on, as its heartbeats say. */
    public synchronized void isPlane() {
        type = MavType.MAV_TYPE_FIXED_WING;
    }

    /** It sends no heartbeats from now on, or again. */
    public synchronized void beating(boolean now) {
        beating = now;
    }

    /** It does not report its position from now on, before it is asked to. */
    public synchronized void forgetPosition() {
        placed = false;
    }

    /**
     * From its next start on it says so many times how it is before it says where it is, as ArduPilot's boats do: it is starting, and the last time that it has
     * started.
     */
    public synchronized void startsInSteps(int beats) {
        startBeats = beats;
    }

    /** Its autopilot starts again. */
    synchronized void restarts() {
        beatsLeft = startBeats;
    }

    /** A base has asked for its position. */
    synchronized void askedForPosition() {
        placed = true;
    }

    /** Whether it reports its position. */
    public synchronized boolean hasPosition() {
        return placed && beatsLeft == 0;
    }

    /** Its filter has no position from now on. */
    public synchronized void loseEstimate() {
        filter = 0;
    }

    /** It reports this speed north, in m/s, from now on. */
    public synchronized void claimSpeed(double mps) {
        claimedMps = mps;
    }

    /** It reports this charge, in percent, from now on. */
    public synchronized void charge(int percent) {
        charge = percent;
    }

    /** Its battery is not healthy from now on, as after a battery failsafe; or is again. */
    synchronized void batteryFails(boolean now) {
        batteryFails = now;
    }

    /** One step of the simulation: sends what is due. */
    synchronized void step(State now) {
        long step = steps++;
        if (seldom && step % ALL_SELDOM_EVERY != 0) {
            if (hasPosition() && step % POSITION_EVERY == 0) {
                sendPosition(now);
            }
        } else if (step % (seldom ? ALL_SELDOM_EVERY : ALL_EVERY) == 0) {
            sendAll(now);
        }
    }

    private void sendAll(State now) {
        if (beating) {
            sendHeartbeat(now);
        }
        if (hasPosition()) {
            sendPosition(now);
        }
        int battery =
                EnumValue.of(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY).value();
        int present = battery | now.fence().present();
        beatsLeft = Math.max(0, beatsLeft - 1);
        send.accept(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(present))
                .onboardControlSensorsEnabled(
                        EnumValue.create(battery | now.fence().enabled()))
                .onboardControlSensorsHealth(EnumValue.create(batteryFails ? present & ~battery : present))
                .voltageBattery(12_600)
                .batteryRemaining(charge)
                .build());
        now.radio().message().ifPresent(send);
        send.accept(EkfStatusReport.builder().flags(EnumValue.create(filter)).build());
        send.accept(FenceStatus.builder()
                .breachStatus(now.fence().isOutside() ? 1 : 0)
                .build());
        send.accept(MissionCurrent.builder()
                .seq(now.mission().current())
                .total(now.mission().total())
                .build());
    }

    /** Reports that the camera has taken a picture, the so many-th, here. */
    synchronized void sendPicture(int number, SmallBoatMotion at) {
        send.accept(CameraFeedback.builder()
                .timeUsec(BigInteger.ZERO)
                .imgIdx(number)
                .lat(at.lat())
                .lng(at.lon())
                .build());
    }

    private void sendHeartbeat(State now) {
        send.accept(Heartbeat.builder()
                .type(type)
                .autopilot(autopilot)
                .baseMode(now.armed() ? EnumValue.of(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED) : EnumValue.create(0))
                .customMode(beatsLeft > 1 ? INITIALIZING : now.mode())
                .systemStatus(now.failsafe() ? MavState.MAV_STATE_CRITICAL : MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .build());
    }

    /** It was at a place within this step, from which it may have gone on; in 1e-7 degrees. */
    synchronized void passed(int lat, int lon, long bootMs, SmallBoatMotion motion) {
        if (hasPosition() && !seldom) {
            sendPosition(lat, lon, bootMs, claimedMps > 0 ? claimedMps : motion.speed());
        }
    }

    synchronized void sendPosition(State now) {
        double mps = claimedMps > 0 ? claimedMps : now.armed() ? now.motion().speed() : 0;
        sendPosition(now.motion().lat(), now.motion().lon(), now.bootMs(), mps);
    }

    private void sendPosition(int lat, int lon, long bootMs, double mps) {
        send.accept(GlobalPositionInt.builder()
                .timeBootMs(bootMs)
                .lat(lat)
                .lon(lon)
                .vx((int) (mps * 100))
                .hdg(9_000)
                .build());
    }
}
