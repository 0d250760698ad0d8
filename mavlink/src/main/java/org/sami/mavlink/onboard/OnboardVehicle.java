package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.FileTransferProtocol;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.MissionSetCurrent;
import io.dronefleet.mavlink.common.NamedValueFloat;
import io.dronefleet.mavlink.common.Ping;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.common.RequestDataStream;
import io.dronefleet.mavlink.common.SetMode;
import io.dronefleet.mavlink.common.SetPositionTargetGlobalInt;
import io.dronefleet.mavlink.common.Timesync;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/** A boat's end of MAVLink: reports how it is, and answers ground stations. It has no thread and no clock; one thread owns it. */
@SuppressWarnings("deprecation") // stations that are older use the older messages
final class OnboardVehicle {
    /** The component id of autopilots. */
    static final int AUTOPILOT = 1;

    private static final double TO_WHOLE = 1e7;
    private static final double FULL_STICK = 1000;
    private static final double MIDDLE_PULSE = 1500;
    private static final double HALF_PULSE = 500;
    private static final int POSITION_IGNORED = 0b11;
    private static final int LONGEST_NAME = 10;
    private static final long REFUSAL_AGAIN_MS = 2_000;

    private final String name;
    private final int system;
    private final OnboardHost host;
    private final Consumer<Object> send;
    private final MessageStreams streams = new MessageStreams();
    private final OnboardTexts texts = new OnboardTexts();
    private final OnboardLists lists;
    private final OnboardCommands commands;
    private final OnboardParameters parameters;
    private long nowMs;
    private String lastRefusal = "";
    private long lastRefusalMs;

    /**
     * An end that has said nothing yet.
     *
     * @param name of the boat, for its version
     * @param capacity how many items its mission may have
     * @param send sends a message of the library to ground stations; may lose it
     */
    OnboardVehicle(String name, int system, int capacity, OnboardHost host, Consumer<Object> send) {
        this.name = name;
        this.system = system;
        this.host = host;
        this.send = send;
        lists = new OnboardLists(capacity, 0, host, send);
        commands = new OnboardCommands(host, streams, this::report, send);
        parameters = new OnboardParameters(host, send);
    }

    /** Takes a message of a station; one for another vehicle changes nothing. */
    void take(VehicleId station, Object message, long now) {
        nowMs = now;
        if (station.system() == system || station.system() == 0) {
            return; // another part of this boat, or nobody
        }
        if (message instanceof Heartbeat beat) {
            if (beat.type().entry() == MavType.MAV_TYPE_GCS) {
                host.heard(station);
            }
            return;
        }
        Optional<MessageTargets> target = MessageTargets.of(message).filter(it -> it.isFor(system, AUTOPILOT));
        if (target.isEmpty()) {
            return;
        }
        boolean asksAll = target.get().system() == 0 && (message instanceof Timesync || message instanceof Ping);
        if (!asksAll) { // vehicles and computers aboard of them ask all too, and are no stations
            host.heard(station);
        }
        answer(station, message);
    }

    private void answer(VehicleId station, Object message) {
        if (message instanceof CommandLong command) {
            refused(commands.take(station, CommandValues.of(command), nowMs));
        } else if (message instanceof CommandInt command) {
            refused(commands.take(station, CommandValues.of(command), nowMs));
        } else if (message instanceof SetMode mode) {
            refused(commands.mode(station, mode.baseMode().value(), mode.customMode()));
        } else if (message instanceof MissionSetCurrent current) {
            refused(host.order(station, new StationOrder.GoOnAt(current.seq())));
        } else if (message instanceof SetPositionTargetGlobalInt target) {
            refused(goTo(station, target));
        } else if (message instanceof ManualControl sticks) {
            steer(station, sticks.z() / FULL_STICK, sticks.y() / FULL_STICK);
        } else if (message instanceof RcChannelsOverride pulses) {
            steer(station, stick(pulses.chan3Raw()), stick(pulses.chan1Raw()));
        } else if (message instanceof RequestDataStream asked) {
            streams.setGroup(asked.reqStreamId(), asked.reqMessageRate(), asked.startStop() == 1, nowMs);
        } else if (message instanceof Timesync sync) {
            answer(station, sync);
        } else if (message instanceof Ping ping) {
            answer(station, ping);
        } else if (message instanceof FileTransferProtocol file) {
            FileTransferAnswer.to(station, file).ifPresent(send);
        } else {
            lists.take(station, message, nowMs);
            lists.tick(nowMs); // the next item is asked for at once
            parameters.take(station, message).ifPresent(why -> say(TextSeverity.WARNING, why));
        }
    }

    /** Says why an order is refused; the same not again within some seconds, as some stations repeat orders many times a second. */
    private void refused(OrderReply reply) {
        boolean again = reply.words().equals(lastRefusal) && nowMs - lastRefusalMs < REFUSAL_AGAIN_MS;
        if (!reply.isAccepted() && !reply.words().isEmpty() && !again) {
            lastRefusal = reply.words();
            lastRefusalMs = nowMs;
            say(TextSeverity.WARNING, reply.words());
        }
    }

    private OrderReply goTo(VehicleId station, SetPositionTargetGlobalInt target) {
        double latDeg = target.latInt() / TO_WHOLE;
        double lonDeg = target.lonInt() / TO_WHOLE;
        if ((target.typeMask().value() & POSITION_IGNORED) != 0) {
            return OrderReply.unsupported("a target without a position is not followed");
        } else if (!CommandValues.isPlace(latDeg, lonDeg)) {
            return OrderReply.denied("it is no place: " + latDeg + ", " + lonDeg);
        }
        return host.order(station, new StationOrder.GoTo(latDeg, lonDeg, Optional.empty(), false));
    }

    /** Sticks come many times a second: a refusal is not said each time. */
    private void steer(VehicleId station, double thrust, double turn) {
        if (Math.abs(thrust) <= 1 && Math.abs(turn) <= 1) {
            host.order(station, new StationOrder.Steer(thrust, turn));
        }
    }

    /** A radio's pulse as a stick; one that is left out or given back is in the middle. */
    private static double stick(int pulse) {
        boolean none = pulse == 0 || pulse == 0xffff;
        return none ? 0 : Math.max(-1, Math.min(1, (pulse - MIDDLE_PULSE) / HALF_PULSE));
    }

    private void answer(VehicleId station, Timesync sync) {
        if (sync.tc1() == 0) { // a question; others are answers to somebody else
            send.accept(Timesync.builder()
                    .tc1(TimeUnit.MILLISECONDS.toNanos(nowMs))
                    .ts1(sync.ts1())
                    .targetSystem(station.system())
                    .targetComponent(station.component())
                    .build());
        }
    }

    private void answer(VehicleId station, Ping ping) {
        if (ping.targetSystem() == 0) {
            send.accept(Ping.builder()
                    .timeUsec(ping.timeUsec())
                    .seq(ping.seq())
                    .targetSystem(station.system())
                    .targetComponent(station.component())
                    .build());
        }
    }

    /** Sends what is due. */
    void tick(long now) {
        nowMs = now;
        lists.tick(now);
        for (int message : streams.due(now)) {
            report(message).ifPresent(send);
        }
    }

    private Optional<Object> report(int message) {
        OnboardState state = host.state();
        return switch (message) {
            case MessageStreams.HEARTBEAT -> Optional.of(OnboardReports.heartbeat(state));
            case MessageStreams.STATUS -> Optional.of(OnboardIdentity.status(state));
            case MessageStreams.GPS -> Optional.of(OnboardReports.gps(state, nowMs));
            case MessageStreams.ATTITUDE -> OnboardReports.attitude(state, nowMs);
            case MessageStreams.POSITION -> OnboardReports.position(state, nowMs);
            case MessageStreams.MISSION ->
                Optional.of(OnboardReports.missionCurrent(
                        state, lists.held(HeldKind.MISSION).size()));
            case MessageStreams.HUD -> OnboardReports.hud(state);
            case MessageStreams.BATTERY -> Optional.of(OnboardReports.battery(state));
            case MessageStreams.FENCE -> OnboardReports.fence(state);
            case MessageStreams.FILTER -> Optional.of(OnboardReports.filter(state));
            case MessageStreams.HOME -> OnboardReports.home(state, nowMs);
            case 148 -> Optional.of(OnboardIdentity.version(name));
            case 300 -> Optional.of(OnboardIdentity.protocol());
            default -> Optional.empty();
        };
    }

    /** Says something to the people at ground stations. */
    void say(TextSeverity severity, String text) {
        texts.messages(severity, text).forEach(send);
    }

    /** An item of the mission is reached. */
    void reached(int item) {
        send.accept(MissionItemReached.builder().seq(item).build());
    }

    /** The vehicle left its fence, came back or has another: stations hear it at once. */
    void fenceChanged() {
        report(MessageStreams.FENCE).ifPresent(send);
    }

    /** Something is measured. */
    void measured(String what, double value) {
        send.accept(NamedValueFloat.builder()
                .timeBootMs(nowMs)
                .name(what.length() <= LONGEST_NAME ? what : what.substring(0, LONGEST_NAME))
                .value((float) value)
                .build());
    }

    /** Puts a mission there from aboard. */
    void hold(List<MissionItem> mission) {
        lists.put(HeldKind.MISSION, mission);
    }
}
