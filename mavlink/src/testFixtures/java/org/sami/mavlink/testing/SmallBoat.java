package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.SetPositionTargetLocalNed;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.mission.MissionItem;

/**
 * A simulated boat with an autopilot, on TCP on loopback: modes, arming, a mission and single places as ArduPilot's boats have them, without any hydrodynamics.
 * It moves in straight lines at many times the requested speed. It has two links, each with one client at a time, as autopilots have several ports: it reports on
 * both, and answers on the one on which it was asked. Safe for use by several threads.
 */
public final class SmallBoat implements AutoCloseable {
    private static final long STEP_MS = 50;
    private static final String CHANGED = "Auto mission changed, restarted command";
    private static final int SET_MODE = 176;
    private static final int CHANGE_SPEED = 178;
    private static final int SWITCH_FENCE = 207;
    private static final float CHANGE_MODE = 1; // of param2
    private static final int REPOSITION = 192;
    private static final int SET_CURRENT = 224;
    private static final int ARM = 400;
    private static final int SEND_EVERY = 511;
    private static final int TAKE_PICTURES = 2000;
    private static final int REQUEST_MESSAGE = 512;
    private static final int RC_CHANNELS = 65;
    private static final int AUTOPILOT_VERSION = 148;
    private static final int POSITION = 33; // the number of its message

    private final SmallVehicleLink link;
    private final SmallVehicleLink secondLink;
    private final SmallBoatNumber number;
    private volatile boolean secondCut;
    private Optional<SmallVehicleLink> asking = Optional.empty(); // on which a message came that is being taken
    private final SmallBoatMotion motion;
    private final SmallBoatMission mission;
    private final ScheduledExecutorService steps = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "small boat moves");
        made.setDaemon(true);
        return made;
    });
    private final SmallVehicleParameters parameters = SmallVehicleParameters.ofBoat(this::send);
    private final SmallVehicleFence fence = new SmallVehicleFence(this::send);
    private final SmallVehicleRadio radio = new SmallVehicleRadio();
    private final SmallBoatReports reports = new SmallBoatReports(this::send);
    private final SmallBoatFaults faults = new SmallBoatFaults();
    private int mode = SmallBoatMotion.HOLD;
    private boolean armed;
    private boolean failsafe;
    private boolean off;
    private final double times;
    private long bootMs = 60_000;
    private int armings;
    private int pictures;
    private int keptCommand; // the number of those whose answers are kept
    private final List<Object> keptAnswers = new ArrayList<>();
    private final List<Integer> orderedModes = new ArrayList<>();
    private final List<Double> courses = new ArrayList<>();
    private final List<Integer> restarts = new ArrayList<>();

    /**
     * A boat that lies at a place, disarmed in HOLD.
     *
     * @param times how many times faster it is than it is asked to be
     */
    public SmallBoat(int system, double latDeg, double lonDeg, double times) throws IOException {
        this(system, latDeg, lonDeg, times, 0);
    }

    /** The same on a port, where another vehicle was before. */
    public SmallBoat(int system, double latDeg, double lonDeg, double times, int port) throws IOException {
        mission = new SmallBoatMission(system);
        this.times = times;
        motion = new SmallBoatMotion(latDeg, lonDeg, times);
        number = new SmallBoatNumber(system);
        link = new SmallVehicleLink(system, port, faults::isCut, message -> heard(message, link()));
        secondLink = new SmallVehicleLink(system, 0, () -> secondCut, message -> heard(message, second()));
        link.passHeartbeatsTo(secondLink);
        secondLink.passHeartbeatsTo(link);
        link.start();
        secondLink.start();
        var unused = steps.scheduleWithFixedDelay(this::step, STEP_MS, STEP_MS, TimeUnit.MILLISECONDS);
    }

    /** Its address for a base. */
    public String address() {
        return link.address();
    }

    /** The port of {@link #address}. */
    public int port() {
        return link.port();
    }

    /** The address of its second link. */
    public String secondAddress() {
        return secondLink.address();
    }

    private SmallVehicleLink link() {
        return link;
    }

    private SmallVehicleLink second() {
        return secondLink;
    }

    /** The number of its autopilot. */
    public SmallBoatNumber number() {
        return number;
    }

    /** It has the key of a fleet from now on: it ignores what is not signed with it, and signs. */
    public void giveKey(SigningKey fleet) {
        link.keyed(fleet);
        secondLink.keyed(fleet);
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

    /** The mission that it holds. */
    public SmallBoatMission mission() {
        return mission;
    }

    /** The items to which it was under way when it began a leg again from a standstill, as its mission had changed; a step of it each. */
    public synchronized List<Integer> restarts() {
        return List.copyOf(restarts);
    }

    /** Somebody else has given it this mission, home first, and it says so, as ArduPilot's boats do where the items to which they go next change. */
    public synchronized void replaceMission(List<MissionItem> items) {
        mission.put(items);
        for (int i = 0; i < 3; i++) {
            say(CHANGED);
        }
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
        return parameters.value(name);
    }

    /** Whether it was asked for one of its parameters. */
    public synchronized boolean wasAsked(String name) {
        return parameters.wasAsked(name);
    }

    /** Somebody sets one of its parameters on board. */
    public synchronized void parameter(String name, float value) {
        parameters.set(name, value);
    }

    /** Another ground station sets one of its parameters: it says so on all its links, as ArduPilot's boats do. */
    public synchronized void setByAnother(String name, float value) {
        parameters.change(name, value);
    }

    /** Somebody with a radio changes its mode, and maybe arms it. */
    public synchronized void takenByPilot(int newMode, boolean nowArmed) {
        mode = newMode;
        armed = nowArmed;
    }

    /** Another ground station that shares its link changes its mode, and maybe arms it: the answer to that station is heard by all there. */
    public synchronized void obeys(int station, int newMode, boolean nowArmed) {
        send(CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, SET_MODE))
                .result(MavResult.MAV_RESULT_ACCEPTED)
                .targetSystem(station)
                .build());
        takenByPilot(newMode, nowArmed);
    }

    /** Its battery is low: as ArduPilot's boats do, it warns, has an unhealthy battery from then on, and changes its mode. Its heartbeats are as before. */
    public synchronized void batteryFailsafe(int newMode) {
        reports.batteryFails(true);
        says(4, "Battery 1 is low 10.94V used 12 mAh");
        mode = newMode;
    }

    /** It stands still though it drives: as ArduPilot's boats do, it says so and goes into HOLD. Its heartbeats are as before. */
    public synchronized void crash() {
        says(0, "Crash: Going to HOLD");
        mode = SmallBoatMotion.HOLD;
    }

    /** Its failsafe for radio, ground station or filter acts: it says so, its heartbeats are critical from then on, and it changes its mode. */
    public synchronized void failsafe(String words, int newMode) {
        failsafe = true;
        say(words);
        mode = newMode;
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

    /** Cuts its second link, and each new connection there, until they are let through again. */
    public void cutSecond(boolean now) throws IOException {
        secondCut = now;
        if (now) {
            secondLink.cut();
        }
    }

    /** Sends a message of the library, whatever it says. */
    public synchronized void sends(Object payload) {
        send(payload);
    }

    /** It says a text of a severity, from 0 (emergency) to 7 (debug). */
    public synchronized void says(int severity, String text) {
        send(Statustext.builder()
                .severity(EnumValue.create(MavSeverity.class, severity))
                .text(text)
                .build());
    }

    /** What it reports of itself. */
    public SmallBoatReports reports() {
        return reports;
    }

    /** The fence that it holds. */
    public SmallVehicleFence fence() {
        return fence;
    }

    /** Its receiver of a pilot's radio control. */
    public SmallVehicleRadio radio() {
        return radio;
    }

    /** Its autopilot starts again: disarmed in HOLD, with the mission that it held. */
    public synchronized void restart() {
        armed = false;
        mode = SmallBoatMotion.HOLD;
        bootMs = 0;
        parameters.set("STAT_BOOTCNT", parameters.value("STAT_BOOTCNT") + 1);
        failsafe = false;
        reports.batteryFails(false);
        reports.restarts();
    }

    /** Its autopilot has no power from now on. */
    public synchronized void switchOff() {
        off = true;
    }

    /** Its autopilot starts again, and is heard once its clock shows as much as when it was switched off. */
    public synchronized void switchOn() {
        long before = bootMs;
        restart();
        bootMs = before;
        off = false;
    }

    private void heard(Object message, SmallVehicleLink from) {
        faults.awaitThaw();
        if (!faults.isDeaf() && !isOff()) {
            take(message, from);
        }
    }

    private synchronized boolean isOff() {
        return off;
    }

    private synchronized void take(Object message, SmallVehicleLink from) {
        asking = Optional.of(from);
        take(message);
        asking = Optional.empty();
    }

    private void take(Object message) {
        parameters.set("FENCE_TOTAL", fence.items().size());
        if (message instanceof CommandLong command
                && command.command().value() != SEND_EVERY
                && command.command().value() != REQUEST_MESSAGE
                && (faults.isIgnoringOrder()
                        || faults.isIgnoring(command.command().value()))) {
            return;
        }
        if (message instanceof CommandLong command
                && faults.isLacking(command.command().value())) {
            answer(command.command().value(), MavResult.MAV_RESULT_UNSUPPORTED);
        } else if (message instanceof CommandLong command) {
            boolean known = command(command.command().value(), command.param1(), command.param2());
            if (!faults.isIgnoringSpeeds() || command.command().value() != CHANGE_SPEED) {
                ack(command.command().value(), known);
            }
        } else if (message instanceof CommandInt command && command.command().value() == REPOSITION) {
            ack(REPOSITION, goTo(command));
        } else if (message instanceof SetPositionTargetLocalNed course && mode == SmallBoatMotion.GUIDED) {
            courses.add((double) course.yaw());
            motion.steer(course.yaw(), course.vx());
        } else if (message instanceof ManualControl sticks) {
            motion.sticks(sticks.z(), sticks.y());
        } else if (!parameters.take(message)
                && !fence.take(message, bootMs)
                && SmallBoatMission.isAboutMission(message)
                && faults.mayAnswer()) {
            mission.answers(message).forEach(this::send);
        }
    }

    private boolean goTo(CommandInt command) {
        boolean may = mode == SmallBoatMotion.GUIDED || command.param2() == CHANGE_MODE;
        if (may) {
            motion.goTo(command.x(), command.y());
            motion.speed(command.param1() > 0 ? command.param1() : motion.speed());
            mode = SmallBoatMotion.GUIDED;
        }
        return may;
    }

    private boolean command(int number, double first, double second) {
        switch (number) {
            case SET_MODE -> {
                int next = (int) second;
                orderedModes.add(next);
                boolean refused = faults.isRefused(next) || (next == SmallBoatMotion.AUTO && mission.isEmpty());
                mode = refused ? mode : next;
                motion.forgetCourse();
                return !refused;
            }
            case ARM -> {
                if (first > 0 && !faults.whyNotArm().isEmpty()) {
                    say(faults.whyNotArm());
                    return false;
                }
                armings += first > 0 && !armed ? 1 : 0;
                armed = first > 0 && faults.isArmable();
                return true;
            }
            case REQUEST_MESSAGE -> request((int) first);
            case SET_CURRENT -> mission.setCurrent((int) first);
            case SEND_EVERY -> {
                if ((int) first == POSITION) {
                    reports.askedForPosition();
                }
            }
            case CHANGE_SPEED -> motion.speed(second);
            case SWITCH_FENCE -> fence.switched(first == 1);
            case TAKE_PICTURES -> {
                return takePicture();
            }
            default -> {
                // it reports what it reports
            }
        }
        return true;
    }

    private void request(int message) {
        if (message == AUTOPILOT_VERSION) {
            send(number.message());
        } else if (message == POSITION && reports.hasPosition()) {
            reports.sendPosition(state());
        } else if (message == RC_CHANNELS) {
            radio.message().ifPresent(this::send);
        }
    }

    private boolean takePicture() {
        boolean hasCamera = parameters.value(SmallVehicleParameters.CAMERA) > 0;
        if (hasCamera && faults.refusesPicture()) {
            return false;
        }
        if (hasCamera && !faults.isCameraJammed()) {
            reports.sendPicture(++pictures, motion);
        }
        return hasCamera;
    }

    private void ack(int command, boolean accepted) {
        answer(command, accepted ? MavResult.MAV_RESULT_ACCEPTED : MavResult.MAV_RESULT_FAILED);
    }

    private void answer(int command, MavResult result) {
        CommandAck answer = CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, command))
                .result(result)
                .build();
        if (command == keptCommand) {
            keptAnswers.add(answer);
        } else {
            send(answer);
        }
    }

    /** It says how far it is with a command, in percent. */
    public synchronized void isAt(int command, int percent) {
        send(CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, command))
                .result(MavResult.MAV_RESULT_IN_PROGRESS)
                .progress(percent)
                .build());
    }

    /** Its answers to commands of a number are under way from now on, and arrive together once this ends. */
    public synchronized void keepAnswers(boolean now, int command) {
        keptCommand = now ? command : 0;
        if (!now) {
            keptAnswers.forEach(this::send);
            keptAnswers.clear();
        }
    }

    private void say(String words) {
        send(Statustext.builder()
                .severity(MavSeverity.MAV_SEVERITY_CRITICAL)
                .text(words)
                .build());
    }

    private synchronized void step() {
        if (faults.isFrozen() || off) {
            return;
        }
        bootMs += STEP_MS;
        fence.set(parameters.value("FENCE_ENABLE"), parameters.value("FENCE_TYPE"));
        fence.tick(bootMs);
        mission.question().ifPresent(this::send);
        boolean beginsAgain = mission.takeChange() && armed && mode == SmallBoatMotion.AUTO;
        if (beginsAgain) {
            restarts.add(mission.current());
            say(CHANGED);
        } else if (armed && !faults.isStuck()) {
            motion.step(mode, mission, STEP_MS / 1000.0).forEach(this::reached);
        }
        reports.step(state());
    }

    /** Since its autopilot started, by its own clock, which is as fast as the vehicle. */
    private long ownMs() {
        return (long) (bootMs * times);
    }

    private SmallBoatReports.State state() {
        return new SmallBoatReports.State(armed, mode, failsafe, fence, radio, ownMs(), motion, mission);
    }

    private void reached(int item) {
        mission.item(item).ifPresent(place -> reports.passed(place.x(), place.y(), ownMs(), motion));
        send(MissionItemReached.builder().seq(item).build());
    }

    private void send(Object payload) {
        if (reports.isSilent()) {
            return;
        }
        boolean toAll = payload instanceof Statustext || payload instanceof CameraFeedback;
        if (asking.isPresent() && !toAll) {
            asking.get().send(payload);
        } else {
            link.send(payload);
            secondLink.send(payload);
        }
    }

    /** Ends it: its port is free, and its client is cut off. */
    @Override
    public void close() throws IOException {
        link.close();
        secondLink.close();
        steps.shutdownNow();
    }
}
