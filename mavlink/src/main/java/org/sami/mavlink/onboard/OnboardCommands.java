package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MessageInterval;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.sami.mavlink.vehicle.VehicleId;

/** Answers the command protocol: reads what a command asks for, has it done, and says how it went (COMMAND_ACK). For one thread. */
final class OnboardCommands {
    private static final int CUSTOM_MODE = 1;
    private static final int HOME_POSITION = 242;
    private static final int VERSION = 148;
    private static final int PROTOCOL = 300;

    private final OnboardHost host;
    private final MessageStreams streams;
    private final IntFunction<Optional<Object>> reports;
    private final Consumer<Object> send;

    /**
     * Answers commands.
     *
     * @param reports makes a message by its number; empty for one that this vehicle does not send
     */
    OnboardCommands(
            OnboardHost host, MessageStreams streams, IntFunction<Optional<Object>> reports, Consumer<Object> send) {
        this.host = host;
        this.streams = streams;
        this.reports = reports;
        this.send = send;
    }

    /** Takes a command; the answer that was given. */
    OrderReply take(VehicleId station, CommandValues command, long nowMs) {
        OrderReply reply = reply(station, command, nowMs);
        send.accept(CommandAck.builder()
                .command(EnumValue.create(MavCmd.class, command.number()))
                .result(result(reply.result()))
                .targetSystem(station.system())
                .targetComponent(station.component())
                .build());
        return reply;
    }

    private static MavResult result(OrderReply.Result result) {
        return switch (result) {
            case ACCEPTED -> MavResult.MAV_RESULT_ACCEPTED;
            case TEMPORARILY_REJECTED -> MavResult.MAV_RESULT_TEMPORARILY_REJECTED;
            case DENIED -> MavResult.MAV_RESULT_DENIED;
            case UNSUPPORTED -> MavResult.MAV_RESULT_UNSUPPORTED;
            case FAILED -> MavResult.MAV_RESULT_FAILED;
        };
    }

    private OrderReply reply(VehicleId station, CommandValues command, long nowMs) {
        MavCmd known = EnumValue.create(MavCmd.class, command.number()).entry();
        if (known == null) {
            return OrderReply.unsupported("");
        }
        return switch (known) {
            case MAV_CMD_COMPONENT_ARM_DISARM -> arm(station, command);
            case MAV_CMD_DO_SET_MODE -> mode(station, command);
            case MAV_CMD_DO_REPOSITION -> goTo(station, command);
            case MAV_CMD_DO_CHANGE_SPEED -> speed(station, command);
            case MAV_CMD_MISSION_START ->
                command.isWhole(1)
                        ? host.order(station, new StationOrder.StartMission((int) command.param(1)))
                        : OrderReply.denied("the first item is no whole number");
            case MAV_CMD_DO_SET_MISSION_CURRENT ->
                command.isWhole(1)
                        ? host.order(station, new StationOrder.GoOnAt((int) command.param(1)))
                        : OrderReply.denied("the item is no whole number");
            case MAV_CMD_DO_PAUSE_CONTINUE -> pause(station, command);
            case MAV_CMD_NAV_LOITER_UNLIM -> host.order(station, new StationOrder.Pause());
            case MAV_CMD_NAV_RETURN_TO_LAUNCH -> host.order(station, new StationOrder.ChangeMode(OnboardModes.RETURN));
            case MAV_CMD_SET_MESSAGE_INTERVAL -> interval(command, nowMs);
            case MAV_CMD_GET_MESSAGE_INTERVAL -> tellInterval(command);
            case MAV_CMD_REQUEST_MESSAGE -> command.isWhole(1) ? report((int) command.param(1)) : OrderReply.denied("");
            case MAV_CMD_GET_HOME_POSITION -> report(HOME_POSITION);
            case MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES -> report(VERSION);
            case MAV_CMD_REQUEST_PROTOCOL_VERSION -> report(PROTOCOL);
            case MAV_CMD_RUN_PREARM_CHECKS -> OrderReply.ACCEPTED;
            case MAV_CMD_DO_SET_HOME -> OrderReply.denied("its home is where its server was started");
            case MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN -> OrderReply.denied("it is not started again over this link");
            default -> OrderReply.unsupported("");
        };
    }

    private OrderReply arm(VehicleId station, CommandValues command) {
        double value = command.param(1);
        if (value != 0 && value != 1) {
            return OrderReply.denied("arming is 1 or 0, not " + value);
        }
        return host.order(station, value == 1 ? new StationOrder.Arm() : new StationOrder.Disarm());
    }

    private OrderReply mode(VehicleId station, CommandValues command) {
        return command.isWhole(1) && command.isWhole(2)
                ? mode(station, (int) command.param(1), (long) command.param(2))
                : noMode();
    }

    /**
     * Changes the mode.
     *
     * @param flags of the mode, the base mode: without that of custom modes, the number is none of these, whatever it is
     */
    OrderReply mode(VehicleId station, int flags, long customMode) {
        return (flags & CUSTOM_MODE) == 0 ? noMode() : host.order(station, new StationOrder.ChangeMode(customMode));
    }

    private static OrderReply noMode() {
        return OrderReply.denied("a mode is a custom mode with a whole number");
    }

    private OrderReply goTo(VehicleId station, CommandValues command) {
        if (!command.isGlobal()) {
            return OrderReply.denied("its place is no latitude and longitude: another frame is not known");
        }
        if (!command.hasPlace()) {
            return OrderReply.denied("it is no place: " + command.latDeg() + ", " + command.lonDeg());
        }
        double speed = command.param(1);
        if (Double.isInfinite(speed)) {
            return OrderReply.denied("no boat has the speed " + speed);
        }
        boolean changes = command.isWhole(2) && ((int) command.param(2) & 1) != 0;
        return host.order(
                station,
                new StationOrder.GoTo(
                        command.latDeg(),
                        command.lonDeg(),
                        speed > 0 ? Optional.of(speed) : Optional.empty(),
                        changes));
    }

    private OrderReply speed(VehicleId station, CommandValues command) {
        double speed = command.param(2);
        if (speed == -1) { // no change
            return OrderReply.ACCEPTED;
        }
        return speed > 0 && !Double.isInfinite(speed)
                ? host.order(station, new StationOrder.ChangeSpeed(speed))
                : OrderReply.denied("no boat has the speed " + speed);
    }

    private OrderReply pause(VehicleId station, CommandValues command) {
        double value = command.param(1);
        if (value != 0 && value != 1) {
            return OrderReply.denied("going on is 1, pausing 0, not " + value);
        }
        return host.order(station, value == 0 ? new StationOrder.Pause() : new StationOrder.StartMission(0));
    }

    private OrderReply interval(CommandValues command, long nowMs) {
        boolean set = command.isWhole(1) && streams.set((int) command.param(1), command.param(2), nowMs);
        return set ? OrderReply.ACCEPTED : OrderReply.denied("");
    }

    private OrderReply tellInterval(CommandValues command) {
        if (!command.isWhole(1)) {
            return OrderReply.denied("");
        }
        int number = (int) command.param(1);
        send.accept(MessageInterval.builder()
                .messageId(number)
                .intervalUs(streams.intervalUs(number).orElse(0)) // 0: there is none
                .build());
        return OrderReply.ACCEPTED;
    }

    private OrderReply report(int number) {
        Optional<Object> message = reports.apply(number);
        message.ifPresent(send);
        return message.isPresent() ? OrderReply.ACCEPTED : OrderReply.denied("");
    }
}
