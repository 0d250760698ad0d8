package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import org.sami.mavlink.vehicle.VehicleId;

/** Commands as messages. */
public final class CommandMessages {
    private static final double TO_WHOLE = 1e7; // degrees of a position's whole numbers

    private CommandMessages() {}

    /** A message as it may be sent to what flies: one that turns motors off whatever the vehicle does leaves it to the vehicle, and a copter in the air refuses. */
    public static Object unforced(Object message) {
        boolean disarms = message instanceof CommandLong command
                && command.command().value() == VehicleCommand.ARM_DISARM
                && command.param1() == 0;
        if (!disarms) {
            return message;
        }
        CommandLong disarm = (CommandLong) message;
        return of(
                new VehicleId(disarm.targetSystem(), disarm.targetComponent()),
                VehicleCommand.disarm(),
                disarm.confirmation());
    }

    /** A command as a message of the library; {@code again} is how often it was sent before. */
    public static Object of(VehicleId vehicle, VehicleCommand command, int again) {
        EnumValue<MavCmd> number = EnumValue.create(MavCmd.class, command.number());
        List<Double> params = command.params();
        return command.place()
                .<Object>map(place -> CommandInt.builder()
                        .targetSystem(vehicle.system())
                        .targetComponent(vehicle.component())
                        .frame(MavFrame.MAV_FRAME_GLOBAL_RELATIVE_ALT)
                        .command(number)
                        .param1(params.get(0).floatValue())
                        .param2(params.get(1).floatValue())
                        .param3(params.get(2).floatValue())
                        .param4(params.get(3).floatValue())
                        .x((int) Math.round(place.latDeg() * TO_WHOLE))
                        .y((int) Math.round(place.lonDeg() * TO_WHOLE))
                        .z((float) place.heightM())
                        .build())
                .orElseGet(() -> CommandLong.builder()
                        .targetSystem(vehicle.system())
                        .targetComponent(vehicle.component())
                        .command(number)
                        .confirmation(again)
                        .param1(params.get(0).floatValue())
                        .param2(params.get(1).floatValue())
                        .param3(params.get(2).floatValue())
                        .param4(params.get(3).floatValue())
                        .param5(params.get(4).floatValue())
                        .param6(params.get(5).floatValue())
                        .param7(params.get(6).floatValue())
                        .build());
    }
}
