package org.sami.mavlink.command;

import java.util.List;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * What became of a command.
 *
 * @param said what the autopilot said meanwhile, in its words and order; mostly why it refused
 */
public record CommandOutcome(VehicleId vehicle, VehicleCommand command, CommandVerdict verdict, List<String> said) {
    /** An outcome. */
    public CommandOutcome {
        said = List.copyOf(said);
    }

    /** Two vehicles have the id: the command was not given, as both would obey. */
    public static CommandOutcome ambiguous(VehicleId vehicle, VehicleCommand command) {
        return new CommandOutcome(vehicle, command, CommandVerdict.DENIED, List.of(ambiguous(vehicle)));
    }

    /** Why a vehicle is asked for nothing that changes it, where two have its id. */
    public static String ambiguous(VehicleId vehicle) {
        return "two vehicles have the id " + vehicle
                + "; give one of them another (ArduPilot: MAV_SYSID or SYSID_THISMAV)";
    }

    /** Whether the vehicle carries it out. */
    public boolean isAccepted() {
        return verdict == CommandVerdict.ACCEPTED;
    }

    /** A line for people, such as {@code vehicle 3 refuses to arm: PreArm: GPS 1: Bad fix}. */
    public String inWords() {
        String joint = switch (verdict) {
            case UNANSWERED -> " when it is asked to ";
            case REPLACED, CANCELLED -> " before it could ";
            default -> " to ";
        };
        String why = verdict == CommandVerdict.UNKNOWN_TO_IT ? " (its firmware lacks this command: update it)" : "";
        String line = "vehicle " + vehicle + " " + verdict.words() + joint + command.does() + why;
        return said.isEmpty() ? line : line + ": " + String.join("; ", said);
    }
}
