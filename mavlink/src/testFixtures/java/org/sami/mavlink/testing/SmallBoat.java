package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import io.dronefleet.mavlink.common.SetPositionTargetLocalNed;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.IOException;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.ListKeeper;
import org.sami.mavlink.onboard.OnboardLists;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * A simulated boat with an autopilot, on TCP on loopback: modes, arming, a mission and single places as ArduPilot's boats have them, without any hydrodynamics.
 * It moves in straight lines at many times the requested speed. One client at a time. Safe for use by several threads.
 */
public final class SmallBoat implements AutoCloseable {
    private static final int AUTOPILOT = 1;
    private static final long STEP_MS = 50;
    private static final int BEAT_EVERY = 4; // steps
    private static final int POSITION_EVERY = 5; // steps, where it reports as seldom as a base asks for
    private static final int REST_EVERY = 20;
    private static final int LOCATED = 16;
    private static final int SET_MODE = 176;
    private static final int CHANGE_SPEED = 178;
    private static final int REPOSITION = 192;
    private static final int SET_CURRENT = 224;
    private static final int ARM = 400;
    private static final int SEND_EVERY = 511;
    private static final int TAKE_PICTURES = 2000;
    private static final String CAMERA = "CAM1_TYPE";
    private static final int FENCE_CORNERS = 84;
    private static final VehicleId STATION = new VehicleId(255, 190);
    private static final int POSITION = 33; // the number of its message

    private final int system;
    private final SmallVehicleLink link;
    private final SmallBoatMotion motion;
    private final SmallBoatMission mission = new SmallBoatMission();
    private final ScheduledExecutorService steps = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "small boat moves");
        made.setDaemon(true);
        return made;
    });
    private final Map<String, Float> parameters = new HashMap<>(Map.ofEntries(
            Map.entry("STAT_BOOTCNT", 41f),
            Map.entry("FS_GCS_ENABLE", 0f),
            Map.entry("FS_ACTION", 2f),
            Map.entry("WP_SPEED", 1.5f),
            Map.entry("CRUISE_SPEED", 2f),
            Map.entry("TURN_RADIUS", 0.5f),
            Map.entry("WP_RADIUS", 2f),
            Map.entry("FENCE_ENABLE", 0f),
            Map.entry("FENCE_TYPE", 6f),
            Map.entry("FENCE_ACTION", 1f),
            Map.entry(CAMERA, 0f)));
    private final OnboardLists fence = new OnboardLists(FENCE_CORNERS, 0, new FenceKeeper(), this::send);
    private int fences; // that were sent to it
    private int refusedCorner = -1;
    private boolean outside;
    private int mode = SmallBoatMotion.HOLD;
    private boolean armed;
    private boolean silent;
    private final SmallBoatFaults faults = new SmallBoatFaults();
    private boolean failsafe;
    private boolean beating = true;
    private boolean placed = true;
    private int filter = LOCATED;
    private int refusedMode = -1;
    private boolean ignoresSpeeds;
    private boolean seldom;
    private double sail; // m/s, said in place of its speed
    private String refusal = "";
    private int charge = 87;
    private long bootMs = 60_000;
    private long stepped;
    private int armings;
    private int pictures;
    private final List<Integer> orderedModes = new ArrayList<>();
    private final List<Double> courses = new ArrayList<>();

    /**
     * A boat that lies at a place, disarmed in HOLD.
     *
     * @param times how many times faster it is than it is asked to be
     */
    public SmallBoat(int system, double latDeg, double lonDeg, double times) throws IOException {
        this.system = system;
        motion = new SmallBoatMotion(latDeg, lonDeg, times);
        link = new SmallVehicleLink(system, faults::isCut, this::heard);
        link.start();
        var unused = steps.scheduleWithFixedDelay(this::step, STEP_MS, STEP_MS, TimeUnit.MILLISECONDS);
    }

    /** Its address for a base. */
    public String address() {
        return link.address();
    }

    /** It has the key of a fleet from now on: it ignores what is not signed with it, and signs. */
    public void giveKey(SigningKey fleet) {
        link.keyed(fleet);
    }

    /** It speaks MAVLink 1 from now on. */
    public void speakFirstVersion() {
        link.speakFirstVersion();
    }

    /** Whether its motors may turn. */
    public synchronized boolean isArmed() {
        return armed;
    }

    /** The number of its mode. */
    public synchronized int mode() {
        return mode;
    }

    /** How often it was armed. */
    public synchronized int armings() {
        return armings;
    }

    /** The modes into which it was ordered, refused ones too. */
    public synchronized List<Integer> orderedModes() {
        return List.copyOf(orderedModes);
    }

    /** The headings that it was given in GUIDED, radians from north clockwise. */
    public synchronized List<Double> courses() {
        return List.copyOf(courses);
    }

    /** Holds no mission any longer: another ground station has taken it away. */
    public synchronized void loseMission() {
        mission.lose();
    }

    /** Somebody else has given it this mission, home first. */
    public synchronized void ownMission(List<MissionItem> items) {
        mission.put(items.stream()
                .map(item -> item.message(new VehicleId(system, AUTOPILOT), HeldKind.MISSION))
                .toList());
    }

    /** Somebody else has given it this mission, which it says, as ArduPilot's boats do where the items to which they go next change. */
    public synchronized void replaceMission(List<MissionItem> items) {
        ownMission(items);
        for (int i = 0; i < 3; i++) {
            say("Auto mission changed, restarted command");
        }
    }

    /** It refuses each mission, and each part of one, from now on, or no longer. */
    public synchronized void refuseMissions(boolean now) {
        mission.refuse(now);
    }

    /** It takes speeds, but does not answer, from now on; or answers again. */
    public synchronized void ignoreSpeeds(boolean now) {
        ignoresSpeeds = now;
    }

    /** How many whole missions were sent to it. */
    public synchronized int uploads() {
        return mission.uploads();
    }

    /** The waypoints of missions that it has reached, in their order, as latitude and longitude in degrees. */
    public synchronized List<List<Double>> visited() {
        return mission.visited().stream()
                .map(item -> List.of(item.x() / 1e7, item.y() / 1e7))
                .toList();
    }

    /** How often it went on along a mission after it had kept its place at an item for that. */
    public synchronized int stops() {
        return mission.stops();
    }

    /** How many parts of missions were sent to it. */
    public synchronized int parts() {
        return mission.parts();
    }

    /** How far it is from a place, in metres. */
    public synchronized double metresTo(double latDeg, double lonDeg) {
        return motion.metresTo(latDeg, lonDeg);
    }

    /** How near it ever came to a place, in metres. */
    public synchronized double nearestM(double latDeg, double lonDeg) {
        return motion.nearestM(latDeg, lonDeg);
    }

    /** How far it has moved, in metres. */
    public synchronized double movedM() {
        return motion.movedM();
    }

    /** One of its parameters. */
    public synchronized double parameter(String name) {
        return parameters.get(name);
    }

    /** Somebody sets one of its parameters on board. */
    public synchronized void parameter(String name, float value) {
        parameters.put(name, value);
    }

    /** Somebody with a radio changes its mode, and maybe arms it. */
    public synchronized void takenByPilot(int newMode, boolean nowArmed) {
        mode = newMode;
        armed = nowArmed;
    }

    /** Its failsafe acts: it says so and changes its mode. */
    public synchronized void failsafe(String words, int newMode) {
        failsafe = true;
        say(words);
        mode = newMode;
    }

    /** It refuses to be armed from now on, in these words; empty text to let it. */
    public synchronized void refuseArming(String words) {
        refusal = words;
    }

    /** Says nothing from now on, or again. */
    public synchronized void silent(boolean now) {
        silent = now;
    }

    /** What does not work on it or its link. */
    public SmallBoatFaults faults() {
        return faults;
    }

    /** Cuts its link, and each new connection, until they are let through again. */
    public void cut(boolean now) throws IOException {
        faults.cut(now);
        if (now) {
            link.cut();
        }
    }

    /** Sends a message of the library, whatever it says. */
    public synchronized void sends(Object payload) {
        send(payload);
    }

    /** Reports no more often than a base asks for, from now on: where it is four times a second, all else once. */
    public synchronized void reportSeldom() {
        seldom = true;
    }

    /** Sends no heartbeats from now on, or again. */
    public synchronized void beating(boolean now) {
        beating = now;
    }

    /** Does not say where it is from now on, before it is asked to. */
    public synchronized void forgetToSayWhere() {
        placed = false;
    }

    /** Whether it says where it is. */
    public synchronized boolean saysWhere() {
        return placed;
    }

    /** Its filter has no position from now on. */
    public synchronized void loseItsPlace() {
        filter = 0;
    }

    /** It refuses this mode from now on. */
    public synchronized void refuseMode(int number) {
        refusedMode = number;
    }

    /** Says that it has this speed north, in m/s, from now on. */
    public synchronized void claimSpeed(double mps) {
        sail = mps;
    }

    /** Its charge in percent from now on. */
    public synchronized void charge(int percent) {
        charge = percent;
    }

    /** The fence that it holds. */
    public synchronized List<MissionItem> fence() {
        return fence.held(HeldKind.FENCE);
    }

    /** Its owner has given it this fence. */
    public synchronized void ownFence(List<MissionItem> items) {
        fence.put(HeldKind.FENCE, items);
    }

    /** How many fences were sent to it. */
    public synchronized int fences() {
        return fences;
    }

    /** It refuses a corner of each fence from now on; -1 for none. */
    public synchronized void refuseCorner(int number) {
        refusedCorner = number;
    }

    /** Says that it is outside of its fence from now on, or no longer. */
    public synchronized void outsideFence(boolean now) {
        outside = now;
    }

    /** Its autopilot starts again: disarmed in HOLD, with the mission that it held. */
    public synchronized void restart() {
        armed = false;
        mode = SmallBoatMotion.HOLD;
        bootMs = 0;
        parameters.merge("STAT_BOOTCNT", 1f, Float::sum);
        failsafe = false;
    }

    private void heard(Object message) {
        faults.awaitThaw();
        if (!faults.isDeaf()) {
            take(message);
        }
    }

    private synchronized void take(Object message) {
        if (message instanceof CommandLong command
                && command.command().value() != SEND_EVERY
                && faults.isIgnoringOrder()) {
            return;
        }
        if (message instanceof CommandLong command) {
            boolean known = command(command.command().value(), command.param1(), command.param2());
            if (!ignoresSpeeds || command.command().value() != CHANGE_SPEED) {
                ack(command.command().value(), known);
            }
        } else if (message instanceof CommandInt command && command.command().value() == REPOSITION) {
            motion.goTo(command.x(), command.y());
            motion.speed(command.param1() > 0 ? command.param1() : motion.speed());
            mode = SmallBoatMotion.GUIDED;
            ack(REPOSITION, true);
        } else if (message instanceof SetPositionTargetLocalNed course && mode == SmallBoatMotion.GUIDED) {
            courses.add((double) course.yaw());
            motion.steer(course.yaw(), course.vx());
        } else if (message instanceof ManualControl sticks) {
            motion.sticks(sticks.z(), sticks.y());
        } else if (message instanceof ParamRequestRead asked) {
            report(asked.paramId());
        } else if (message instanceof ParamSet set) {
            parameters.put(set.paramId(), set.paramValue());
            report(set.paramId());
        } else if (isAboutFence(message)) {
            fence.take(STATION, message, bootMs);
        } else if (SmallBoatMission.isAboutMission(message) && faults.mayAnswer()) {
            mission.answers(message).forEach(this::send);
        }
    }

    static boolean isAboutFence(Object message) {
        Optional<EnumValue<MavMissionType>> type = Optional.empty();
        if (message instanceof MissionRequestList asked) {
            type = Optional.of(asked.missionType());
        } else if (message instanceof MissionRequestInt asked) {
            type = Optional.of(asked.missionType());
        } else if (message instanceof MissionCount count) {
            type = Optional.of(count.missionType());
        } else if (message instanceof MissionItemInt item) {
            type = Optional.of(item.missionType());
        } else if (message instanceof MissionClearAll all) {
            type = Optional.of(all.missionType());
        }
        return type.flatMap(HeldKind::of).filter(HeldKind.FENCE::equals).isPresent();
    }

    private void report(String name) {
        Optional.ofNullable(parameters.get(name))
                .ifPresent(value -> send(ParamValue.builder()
                        .paramId(name)
                        .paramValue(value)
                        .paramType(MavParamType.MAV_PARAM_TYPE_REAL32)
                        .paramCount(parameters.size())
                        .build()));
    }

    private boolean command(int number, double first, double second) {
        switch (number) {
            case SET_MODE -> {
                int next = (int) second;
                orderedModes.add(next);
                boolean refused = next == refusedMode || (next == SmallBoatMotion.AUTO && mission.isEmpty());
                mode = refused ? mode : next;
                motion.forgetCourse();
                return !refused;
            }
            case ARM -> {
                if (first > 0 && !refusal.isEmpty()) {
                    say(refusal);
                    return false;
                }
                armings += first > 0 && !armed ? 1 : 0;
                armed = first > 0 && faults.isArmable();
                return true;
            }
            case SET_CURRENT -> mission.setCurrent((int) first);
            case SEND_EVERY -> placed |= (int) first == POSITION;
            case CHANGE_SPEED -> motion.speed(second);
            case TAKE_PICTURES -> {
                return takePicture();
            }
            default -> {
                // it reports what it reports
            }
        }
        return true;
    }

    private boolean takePicture() {
        boolean hasCamera = parameters.get(CAMERA) > 0;
        if (hasCamera && !faults.isCameraJammed()) {
            send(CameraFeedback.builder()
                    .timeUsec(BigInteger.ZERO)
                    .imgIdx(++pictures)
                    .lat(motion.lat())
                    .lng(motion.lon())
                    .build());
        }
        return hasCamera;
    }

    private void ack(int command, boolean accepted) {
        send(CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, command))
                .result(accepted ? MavResult.MAV_RESULT_ACCEPTED : MavResult.MAV_RESULT_FAILED)
                .build());
    }

    private void say(String words) {
        send(Statustext.builder()
                .severity(MavSeverity.MAV_SEVERITY_CRITICAL)
                .text(words)
                .build());
    }

    private synchronized void step() {
        if (faults.isFrozen()) {
            return;
        }
        bootMs += STEP_MS;
        fence.tick(bootMs);
        if (armed && !faults.isStuck()) {
            motion.step(mode, mission, STEP_MS / 1000.0).forEach(this::reached);
        }
        long step = stepped++;
        if (seldom && step % REST_EVERY != 0) {
            if (placed && step % POSITION_EVERY == 0) {
                sayWhere();
            }
        } else if (step % (seldom ? REST_EVERY : BEAT_EVERY) == 0) {
            report();
        }
    }

    private void reached(int item) {
        if (placed && !seldom) { // it was there within this step, from which it may have gone on
            mission.item(item).ifPresent(place -> sayWhere(place.x(), place.y()));
        }
        send(MissionItemReached.builder().seq(item).build());
    }

    private void report() {
        if (beating) {
            beat();
        }
        if (placed) {
            sayWhere();
        }
        send(SysStatus.builder().voltageBattery(12_600).batteryRemaining(charge).build());
        send(EkfStatusReport.builder().flags(EnumValue.create(filter)).build());
        send(FenceStatus.builder().breachStatus(outside ? 1 : 0).build());
        send(MissionCurrent.builder()
                .seq(mission.current())
                .total(mission.total())
                .build());
    }

    private void beat() {
        send(Heartbeat.builder()
                .type(MavType.MAV_TYPE_SURFACE_BOAT)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                .baseMode(armed ? EnumValue.of(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED) : EnumValue.create(0))
                .customMode(mode)
                .systemStatus(failsafe ? MavState.MAV_STATE_CRITICAL : MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .build());
    }

    private void sayWhere() {
        sayWhere(motion.lat(), motion.lon());
    }

    private void sayWhere(int lat, int lon) {
        send(GlobalPositionInt.builder()
                .timeBootMs(bootMs)
                .lat(lat)
                .lon(lon)
                .vx((int) (sail > 0 ? sail * 100 : armed ? motion.speed() * 100 : 0))
                .hdg(9_000)
                .build());
    }

    private void send(Object payload) {
        if (!silent) {
            link.send(payload);
        }
    }

    /** Takes every fence but one with a corner that is to be refused. */
    private final class FenceKeeper implements ListKeeper {
        @Override
        public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
            return item.number() == refusedCorner ? Optional.of(Refusal.INVALID) : Optional.empty();
        }

        @Override
        public void changed(HeldKind kind, List<MissionItem> items) {
            fences++;
        }
    }

    /** Ends it: its port is free, and its client is cut off. */
    @Override
    public void close() throws IOException {
        link.close();
        steps.shutdownNow();
    }
}
