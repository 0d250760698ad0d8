package org.sami.mavlink.vehicle;

import java.util.List;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/** Something that happened to a vehicle, as against a state of it, which a {@link VehicleSnapshot} has. */
public sealed interface VehicleEvent {
    /** Which vehicle. */
    VehicleId vehicle();

    /** It was heard for the first time. */
    record Appeared(VehicleId vehicle) implements VehicleEvent {}

    /** Its mode is another. */
    record ModeChanged(VehicleId vehicle, String before, String mode) implements VehicleEvent {}

    /** Its motors may turn now, or may not any more. */
    record ArmedChanged(VehicleId vehicle, boolean armed) implements VehicleEvent {}

    /** Its autopilot said something. */
    record Said(VehicleId vehicle, StatusText text) implements VehicleEvent {}

    /**
     * The item of its mission that is carried out, or would be in mode AUTO, is another.
     *
     * @param heardMs when it said so, on the base's clock
     */
    record ItemCurrent(VehicleId vehicle, int item, long heardMs) implements VehicleEvent {}

    /**
     * It says that an item of its mission has been reached; it may say so more than once.
     *
     * @param at where it said last that it is; empty where it has not
     * @param heardMs when it said that it reached the item, on the base's clock
     */
    record ItemReached(VehicleId vehicle, int item, Optional<VehiclePosition> at, long heardMs)
            implements VehicleEvent {}

    /**
     * It is at a command that takes it a while. Comes for each percentage that it says, also for the same one again.
     *
     * @param does what it was ordered, in words such as {@code take off to 20 m over its home}
     * @param percent how far it is
     */
    record CommandProgressed(VehicleId vehicle, String does, int percent) implements VehicleEvent {}

    /** A sensor has a value. */
    record Measured(VehicleId vehicle, VehicleReading reading) implements VehicleEvent {}

    /** It says what one of its parameters is: to who asked, or to all as somebody has set it. */
    record ParameterReported(VehicleId vehicle, String name, double value) implements VehicleEvent {}

    /**
     * It says what it receives from a pilot's radio control.
     *
     * @param pulsesUs the pulse of each channel from the first one on, microseconds; 0 where it has none. Empty where no radio control is received
     */
    record RadioHeard(VehicleId vehicle, List<Integer> pulsesUs) implements VehicleEvent {
        /** Pulses. */
        public RadioHeard {
            pulsesUs = List.copyOf(pulsesUs);
        }
    }

    /**
     * It has obeyed another ground station, whose answer came on a link of this base too.
     *
     * @param station the system id of that station
     */
    record ObeyedStation(VehicleId vehicle, int station) implements VehicleEvent {}

    /**
     * Its camera was triggered, whoever asked for it.
     *
     * @param number of the picture, since the autopilot's start
     * @param latDeg where, WGS 84 degrees
     * @param lonDeg likewise
     */
    record PictureTaken(VehicleId vehicle, int number, double latDeg, double lonDeg) implements VehicleEvent {}

    /**
     * A camera on board follows a target on the ground or the water, by its detector or by who watches its picture; comes again as long as it does.
     *
     * @param latDeg where the target is, WGS 84 degrees
     * @param lonDeg likewise
     */
    record TargetTracked(VehicleId vehicle, double latDeg, double lonDeg) implements VehicleEvent {}

    /** Its autopilot has started again: what is known of its lists and parameters may not hold any more. */
    record Restarted(VehicleId vehicle) implements VehicleEvent {}

    /**
     * Another vehicle answers with its id from now on: one of another kind, or with another number of its autopilot. What was known of the one before says nothing
     * of it.
     */
    record Replaced(VehicleId vehicle, VehicleKind before, VehicleKind now) implements VehicleEvent {}

    /** Its clock is behind: its autopilot may have started again while it was not heard, or what it says comes late. Comes again every 30 s for as long as it is. */
    record ClockBehind(VehicleId vehicle) implements VehicleEvent {}

    /** It is heard on a further link, on which it can be commanded from now on as well. */
    record LinkJoined(VehicleId vehicle, MavlinkAddress link) implements VehicleEvent {}

    /**
     * It is commanded on another link from now on.
     *
     * @param why what is wrong with the link before, in words that continue the link's name
     */
    record LinkChanged(VehicleId vehicle, MavlinkAddress before, MavlinkAddress now, String why)
            implements VehicleEvent {}

    /** Another vehicle has its id, on a link on which this vehicle is not heard; {@code own} is one on which it is. */
    record OtherVehicle(VehicleId vehicle, MavlinkAddress link, MavlinkAddress own) implements VehicleEvent {}

    /** Another vehicle has its id on the same link: which of both has sent a message cannot be told. */
    record SharedId(VehicleId vehicle, MavlinkAddress link) implements VehicleEvent {}
}
