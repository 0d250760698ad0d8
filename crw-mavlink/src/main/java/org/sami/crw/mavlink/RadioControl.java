package org.sami.crw.mavlink;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.ModeNames;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * What a pilot does with a vehicle's radio control, from what ArduPilot reports of its channels: whether the mode switch was moved, and whether the stick that arms is
 * held. For the gateway's thread.
 */
final class RadioControl {
    private static final int RC_CHANNELS = 65;
    private static final long RECENT_MS = 4_000;
    private static final int ARMING_US = 1_850; // the stick that arms, held to the right
    private static final int LOWEST_US = 900; // less is no pulse
    private static final int[] POSITIONS_US = {1_231, 1_361, 1_491, 1_621, 1_750}; // between the six of a mode switch
    private static final int POSITIONS = 6;
    private static final int FIRST_SWITCH = 5; // the channels before it are sticks
    private static final int SWITCH_LOW_US =
            1_200; // below it, and above the next, a switch with three positions is at an end
    private static final int SWITCH_HIGH_US = 1_800;

    /** What it receives at a moment. */
    private record Sample(List<Integer> pulsesUs, long atMs) {
        int pulseUs(int channel) {
            return channel >= 1 && channel <= pulsesUs.size() ? pulsesUs.get(channel - 1) : 0;
        }

        /** The positions of all switches but one: 0 low, 1 in the middle, 2 high. */
        List<Integer> switches(int without) {
            return IntStream.rangeClosed(FIRST_SWITCH, pulsesUs.size())
                    .filter(channel -> channel != without)
                    .map(this::pulseUs)
                    .mapToObj(pulse -> pulse < SWITCH_LOW_US ? 0 : pulse > SWITCH_HIGH_US ? 2 : 1)
                    .toList();
        }
    }

    private final MavlinkBase base;
    private final VehicleId id;
    private final VehicleKind kind;
    private final Executor thread;
    private final Deque<Sample> samples = new ArrayDeque<>(); // oldest first
    private Optional<Sample> earlier = Optional.empty(); // the one before these
    private final List<Integer> modes = new ArrayList<>(); // by the positions of the switch; six once they are read
    private int modeChannel; // from 1 on; 0 before it is read
    private int armingChannel;
    private int reads;
    private int position = -1; // of the mode switch; -1 before it is known
    private long switchedMs = Long.MIN_VALUE / 2; // when the mode switch was moved

    RadioControl(MavlinkBase base, VehicleId id, VehicleKind kind, Executor thread) {
        this.base = base;
        this.id = id;
        this.kind = kind;
        this.thread = thread;
    }

    private boolean flies() {
        return kind == VehicleKind.COPTER;
    }

    /** Reads which channel does what, unless it is known, and where the switch is now. */
    void read() {
        ask();
        if (modes.size() == POSITIONS && armingChannel > 0) {
            return;
        }
        int number = ++reads;
        modes.clear();
        parameter(number, flies() ? "RCMAP_YAW" : "RCMAP_ROLL", channel -> {
            armingChannel = channel;
            parameter(number, flies() ? "FLTMODE_CH" : "MODE_CH", switching -> {
                modeChannel = switching;
                readMode(number, 1);
            });
        });
    }

    private void readMode(int number, int which) {
        if (which <= POSITIONS) {
            parameter(number, (flies() ? "FLTMODE" : "MODE") + which, mode -> {
                modes.add(mode);
                readMode(number, which + 1);
            });
        }
    }

    private void parameter(int number, String name, Consumer<Integer> found) {
        Results.when(
                base.parameter(id, name),
                thread,
                value -> {
                    if (number == reads) {
                        found.accept((int) Math.round(value));
                    }
                },
                unknown -> {}); // then nothing is concluded from its radio control
    }

    /** Asks what it receives now. */
    void ask() {
        Results.when(base.command(id, VehicleCommand.sendOnce(RC_CHANNELS)), thread, sent -> {}, unanswered -> {});
    }

    /** Its autopilot has started again, maybe with other parameters. */
    void restarted() {
        modes.clear();
        samples.clear();
        earlier = Optional.empty();
        position = -1;
        reads++;
    }

    /** It says what it receives, microseconds by channel. */
    void heard(List<Integer> pulsesUs, long atMs) {
        samples.addLast(new Sample(pulsesUs, atMs));
        while (atMs - samples.getFirst().atMs() > RECENT_MS) {
            earlier = Optional.of(samples.removeFirst());
        }
        int now = positionOf(samples.getLast().pulseUs(modeChannel));
        if (now >= 0 && position >= 0 && now != position) {
            switchedMs = atMs;
        }
        position = now;
    }

    private static int positionOf(int pulseUs) {
        if (pulseUs < LOWEST_US) {
            return -1;
        }
        int position = 0;
        while (position < POSITIONS_US.length && pulseUs >= POSITIONS_US[position]) {
            position++;
        }
        return position;
    }

    private boolean standsAt(String mode) {
        return position >= 0
                && position < modes.size()
                && ModeNames.ofArduPilot(kind, modes.get(position)).equals(mode);
    }

    private boolean isArmingHeld() {
        return samples.stream().anyMatch(sample -> sample.pulseUs(armingChannel) >= ARMING_US);
    }

    /**
     * Whether the pilot has done it: moved the mode switch to the vehicle's mode just now, or held the stick that arms. Switches that
     * ArduPilot announces by a text (RC7: CameraTrigger HIGH) change no mode and arm nothing.
     *
     * @param isArming whether the vehicle was armed just now
     */
    boolean hasActed(VehicleSnapshot vehicle, boolean isArming, long atMs) {
        boolean hasSwitched = atMs - switchedMs <= RECENT_MS && standsAt(vehicle.mode());
        return hasSwitched || (isArming && isArmingHeld());
    }

    /** Whether no other switch was moved around a moment, as far as what was received before and after it shows; any may change the mode or arm. */
    private boolean areOtherSwitchesStill(long sinceMs) {
        List<Sample> all = Stream.concat(earlier.stream(), samples.stream()).toList();
        return all.get(0).atMs() < sinceMs
                && all.stream()
                                .map(sample -> sample.switches(modeChannel))
                                .distinct()
                                .count()
                        == 1;
    }

    /**
     * Whether nothing is received of a pilot's radio control, as was seen since a moment.
     *
     * @param sinceMs when the vehicle reported a change
     */
    boolean isNotReceived(long sinceMs) {
        return !samples.isEmpty()
                && samples.getLast().atMs() >= sinceMs
                && samples.getLast().pulsesUs().isEmpty();
    }

    /**
     * Whether the pilot cannot have done it: what was received before and since then shows that the mode switch stands elsewhere, that no other switch was moved, and that
     * the stick that arms was not held.
     *
     * @param sinceMs when the vehicle reported the change
     */
    boolean isRuledOut(VehicleSnapshot vehicle, boolean isArming, long sinceMs) {
        boolean isSeenAfter = !samples.isEmpty() && samples.getLast().atMs() >= sinceMs;
        boolean isModeKnown = position >= 0 && modes.size() == POSITIONS;
        boolean isArmingKnown =
                !isArming || (samples.size() > 1 && samples.getFirst().atMs() < sinceMs && !isArmingHeld());
        return isSeenAfter
                && isModeKnown
                && !standsAt(vehicle.mode())
                && isArmingKnown
                && areOtherSwitchesStill(sinceMs);
    }
}
