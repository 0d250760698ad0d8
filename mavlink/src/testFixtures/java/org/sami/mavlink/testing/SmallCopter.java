package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * A simulated copter with an autopilot, on TCP on loopback: arming, take-off, missions, landing and brake as ArduPilot's copters have them, without any
 * aerodynamics. It is armed in GUIDED only, takes off in AUTO by its mission and in GUIDED where it is asked to, which it refuses in the air; refuses to be
 * disarmed in the air, and turns its motors off after a landing. Safe for use by several threads.
 */
public final class SmallCopter implements AutoCloseable {
    /** Numbers of its modes. */
    public static final int STABILIZE = 0;

    public static final int AUTO = 3;
    public static final int GUIDED = 4;
    public static final int RTL = 6;
    public static final int BRAKE = 17;

    private static final long STEP_MS = 50;
    private static final int BEAT_EVERY = 4; // steps
    private static final int LOCATED = 16;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int REPOSITION = 192;
    private static final int CHANGE_SPEED = 178;
    private static final int SWITCH_FENCE = 207;
    private static final int SET_CURRENT = 224;
    private static final int MISSION_START = 300;
    private static final int ARM = 400;
    private static final int REQUEST_MESSAGE = 512;
    private static final int AUTOPILOT_VERSION = 148;
    private static final double FORCED = 21_196;
    private static final float CHANGE_MODE = 1;

    private final SmallVehicleLink link;
    private final SmallBoatNumber number;
    private final SmallFlight flight;
    private final SmallBoatMission mission;
    private final SmallVehicleParameters parameters = SmallVehicleParameters.ofCopter(this::send);
    private final SmallVehicleFence fence = new SmallVehicleFence(this::send);
    private final ScheduledExecutorService steps = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "small copter moves");
        made.setDaemon(true);
        return made;
    });
    private int mode = STABILIZE;
    private boolean armed;
    private boolean started; // the mission, since it was armed
    private boolean fell;
    private int armings;
    private int takeOffs; // in GUIDED
    private int takenAt; // a command; 0 for none
    private int takenInto;
    private boolean takesOff = true; // where it is asked to
    private boolean answersTakeOffs = true;
    private Optional<Target> target = Optional.empty(); // in GUIDED
    private final double times;
    private long bootMs = 60_000;
    private long stepped;
    private double reportedM; // the way that it had gone when it reported last

    /** Where it goes to in GUIDED; straight up where it has no place. */
    private record Target(Optional<int[]> place, double heightM) {}

    /**
     * A copter that stands at a place, disarmed.
     *
     * @param times how many times faster it is than it is asked to be
     */
    public SmallCopter(int system, double latDeg, double lonDeg, double times) throws IOException {
        this(system, latDeg, lonDeg, times, 0, 0);
    }

    /** The same on a port, where another vehicle was before, and in the air, where its pilot has flown it in STABILIZE. */
    public SmallCopter(int system, double latDeg, double lonDeg, double times, int port, double heightM)
            throws IOException {
        number = new SmallBoatNumber(system);
        mission = new SmallBoatMission(system);
        this.times = times;
        flight = new SmallFlight(new SmallBoatMotion(latDeg, lonDeg, times), times, heightM);
        armed = heightM > 0;
        link = new SmallVehicleLink(system, port, () -> false, this::take);
        link.start();
        var unused = steps.scheduleWithFixedDelay(this::step, STEP_MS, STEP_MS, TimeUnit.MILLISECONDS);
    }

    /** Its address for a base. */
    public String address() {
        return link.address();
    }

    /** Whether its motors may turn. */
    public synchronized boolean isArmed() {
        return armed;
    }

    /** How often it was armed. */
    public synchronized int armings() {
        return armings;
    }

    /** How often it has taken off in GUIDED. */
    public synchronized int takeOffs() {
        return takeOffs;
    }

    /** It refuses from now on to take off in GUIDED. */
    public synchronized void refuseTakeOffs() {
        takesOff = false;
    }

    /** Its first answer to each order to take off in GUIDED is lost from now on. */
    public synchronized void loseAnswersToTakeOffs() {
        answersTakeOffs = false;
    }

    /** It climbs no higher than that from now on, in metres. */
    public synchronized void ceiling(double metres) {
        flight.ceiling(metres);
    }

    /** The mission that it holds. */
    public SmallBoatMission mission() {
        return mission;
    }

    /** How near it ever came to a place, in metres. */
    public synchronized double nearestM(double latDeg, double lonDeg) {
        return flight.motion().nearestM(latDeg, lonDeg);
    }

    /** The number of its mode. */
    public synchronized int mode() {
        return mode;
    }

    /** Its height in metres. */
    public synchronized double heightM() {
        return flight.heightM();
    }

    /** The largest height that it had, in metres. */
    public synchronized double highestM() {
        return flight.highestM();
    }

    /** How far it is from a place, in metres. */
    public synchronized double metresTo(double latDeg, double lonDeg) {
        return flight.motion().metresTo(latDeg, lonDeg);
    }

    /** Whether its motors were turned off in the air. */
    public synchronized boolean fell() {
        return fell;
    }

    /** Its pilot takes it. */
    public synchronized void takenByPilot(int newMode) {
        mode = newMode;
        target = Optional.empty();
    }

    /** Its pilot lets its motors turn, on the ground. */
    public synchronized void armedByPilot() {
        homeHere();
        armed = true;
    }

    private void homeHere() {
        if (!armed) {
            mission.home(flight.motion().lat() / 1e7, flight.motion().lon() / 1e7);
        }
    }

    /** One of its parameters. */
    public synchronized double parameter(String name) {
        return parameters.value(name);
    }

    /** Somebody sets one of its parameters on board. */
    public synchronized void parameter(String name, float value) {
        parameters.set(name, value);
    }

    /** Another ground station sets one of its parameters: it says so on all its links, as ArduPilot's copters do. */
    public synchronized void setByAnother(String name, float value) {
        parameters.change(name, value);
    }

    /** At the next command of a number its pilot takes it, and does so before it carries that out or answers. */
    public synchronized void takenByPilotAt(int command, int newMode) {
        takenAt = command;
        takenInto = newMode;
    }

    private synchronized void take(Object message) {
        if (takenAt != 0 && takenAt == number(message)) {
            takenAt = 0;
            takenByPilot(takenInto);
        } else {
            carryOut(message);
        }
    }

    private static int number(Object message) {
        if (message instanceof CommandLong command) {
            return command.command().value();
        }
        return message instanceof CommandInt command ? command.command().value() : 0;
    }

    private void carryOut(Object message) {
        if (message instanceof CommandLong command) {
            int number = command.command().value();
            boolean done = number == TAKE_OFF
                    ? takesOff(command.param7())
                    : command(number, command.param1(), command.param2());
            if (number != TAKE_OFF || answersTakeOffs || !done) {
                answer(number, done);
            }
        } else if (message instanceof CommandInt command && command.command().value() == REPOSITION) {
            boolean done = flight.isInTheAir() && (mode == GUIDED || command.param2() == CHANGE_MODE);
            if (done) {
                mode = GUIDED;
                target = Optional.of(new Target(Optional.of(new int[] {command.x(), command.y()}), command.z()));
            }
            answer(REPOSITION, done);
        } else if (!parameters.take(message) && !fence.take(message, bootMs)) {
            mission.answers(message).forEach(link::send);
        }
    }

    private void answer(int command, boolean done) {
        link.send(CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, command))
                .result(done ? MavResult.MAV_RESULT_ACCEPTED : MavResult.MAV_RESULT_FAILED)
                .build());
    }

    private boolean takesOff(double toM) {
        boolean may = takesOff && armed && mode == GUIDED && !flight.isInTheAir() && toM > flight.heightM();
        takeOffs += may ? 1 : 0;
        target = may ? Optional.of(new Target(Optional.empty(), toM)) : target;
        return may;
    }

    private void send(Object message) {
        link.send(message);
    }

    /** The fence that it holds. */
    public SmallVehicleFence fence() {
        return fence;
    }

    private boolean command(int number, double first, double second) {
        switch (number) {
            case SET_MODE -> {
                boolean lacksTakeOff = second == AUTO && !flight.isInTheAir() && !flight.beginsWithTakeOff(mission);
                if (!lacksTakeOff && mode != (int) second) {
                    mode = (int) second;
                    target = Optional.empty();
                }
                return !lacksTakeOff;
            }
            case ARM -> {
                return first > 0 ? arm() : disarm(second == FORCED);
            }
            case REQUEST_MESSAGE -> {
                if ((int) first == AUTOPILOT_VERSION) {
                    link.send(this.number.message());
                }
            }
            case MISSION_START -> started = true;
            case SET_CURRENT -> mission.setCurrent((int) first);
            case CHANGE_SPEED -> flight.motion().speed(second);
            case SWITCH_FENCE -> fence.switched(first == 1);
            default -> {
                // it reports what it reports
            }
        }
        return true;
    }

    private boolean arm() {
        if (!armed && mode != GUIDED && mode != STABILIZE) {
            return false;
        }
        armings += armed ? 0 : 1;
        homeHere();
        armed = true;
        return true;
    }

    private boolean disarm(boolean forced) {
        if (flight.isInTheAir() && !forced) {
            return false;
        }
        fell |= flight.isInTheAir();
        armed = false;
        started = false;
        target = Optional.empty();
        return true;
    }

    private synchronized void step() {
        bootMs += STEP_MS;
        fence.set(parameters.value("FENCE_ENABLE"), parameters.value("FENCE_TYPE"));
        fence.tick(bootMs);
        mission.question().ifPresent(this::send);
        if (armed && mode == GUIDED) {
            target.ifPresent(to -> to.place.ifPresentOrElse(
                    place -> flight.stepTo(place[0], place[1], to.heightM, STEP_MS / 1000.0),
                    () -> flight.stepTo(to.heightM, STEP_MS / 1000.0)));
        }
        if (armed && mode == AUTO && (started || flight.isInTheAir())) {
            flight.step(mission, STEP_MS / 1000.0)
                    .ifPresent(item ->
                            link.send(MissionItemReached.builder().seq(item).build()));
            if (flight.hasLanded()) {
                disarm(false);
                mission.setCurrent(1);
            }
        }
        if (stepped++ % BEAT_EVERY == 0) {
            report();
        }
    }

    /** In hundredths of metres a second since the last report, as its base sees it. */
    private int speed() {
        double metres = flight.motion().movedM() - reportedM;
        reportedM += metres;
        return (int) Math.round(metres * 100 * 1000 / (BEAT_EVERY * STEP_MS));
    }

    private void report() {
        link.send(Heartbeat.builder()
                .type(MavType.MAV_TYPE_QUADROTOR)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                .baseMode(armed ? EnumValue.of(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED) : EnumValue.create(0))
                .customMode(mode)
                .systemStatus(MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .build());
        link.send(GlobalPositionInt.builder()
                .timeBootMs((long) (bootMs * times)) // its own clock is as fast as it is
                .lat(flight.motion().lat())
                .lon(flight.motion().lon())
                .relativeAlt((int) Math.round(flight.heightM() * 1000))
                .vx(speed())
                .hdg(9_000)
                .build());
        link.send(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(fence.present()))
                .onboardControlSensorsEnabled(EnumValue.create(fence.enabled()))
                .onboardControlSensorsHealth(EnumValue.create(fence.present()))
                .voltageBattery(12_600)
                .batteryRemaining(87)
                .build());
        link.send(EkfStatusReport.builder().flags(EnumValue.create(LOCATED)).build());
        link.send(MissionCurrent.builder()
                .seq(mission.current())
                .total(mission.total())
                .build());
    }

    /** Ends it: its port is free, and its client is cut off. */
    @Override
    public void close() throws IOException {
        link.close();
        steps.shutdownNow();
    }
}
