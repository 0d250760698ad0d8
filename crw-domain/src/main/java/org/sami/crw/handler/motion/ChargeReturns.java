package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;
import org.sami.boat.link.BatteryDefaults;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.ExplainedCommand;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.service.reach.Flight;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/**
 * Aircraft that the base itself brings home, as their charges last for that alone. The command is no mission's, so that the end of a plan does not take it back. What a
 * plan asks of such an aircraft meanwhile takes its place, as it was checked; once the aircraft has nothing to do and is still in the air, it comes home again. That
 * ends on the ground, and where a person decides: by hand, with a stop, or with a yes to a flight. For the fleet's thread.
 */
final class ChargeReturns implements AircraftMemory.Part {
    private static final double GROUND_M = 0.5;

    private final ProxyRegistry robots;
    private final ClearWays clearWays;
    private final MessageSink messages;
    private final Map<String, Return> all = new HashMap<>(); // by aircraft

    /** The charges with which an earlier base sent aircraft home, of those that have not said theirs since. */
    private final Map<String, Double> earlier = new HashMap<>();

    private long made;

    ChargeReturns(ProxyRegistry robots, ClearWays clearWays, MessageSink messages) {
        this.robots = robots;
        this.clearWays = clearWays;
        this.messages = messages;
    }

    /**
     * An aircraft that comes home.
     *
     * @param mission whose flight was not sent
     * @param limit has its way keep clear of what is to be avoided
     * @param percent its charge when it was sent home, as far as it had said
     * @param command with which it comes; empty while something else has taken its place
     */
    private record Return(
            long mission,
            OptionalDouble percent,
            Priority priority,
            LongSupplier nowMillis,
            UnaryOperator<Move> limit,
            Optional<String> command) {
        Return with(Optional<String> other) {
            return new Return(mission, percent, priority, nowMillis, limit, other);
        }

        boolean is(BoatCommand other) {
            return command.filter(other.commandId()::equals).isPresent();
        }
    }

    /** Whether a command brings an aircraft home in this way. */
    static boolean isOne(BoatCommand command) {
        return command.commandId().startsWith(ExplainedCommand.FOR_CHARGE);
    }

    /** Whether it is known where an aircraft is and where its home is. */
    static boolean isWayKnown(ProxyRegistry robots, String aircraft) {
        return robots.find(aircraft).flatMap(ChargeReturns::way).isPresent();
    }

    private static Optional<List<GeoPoint>> way(BoatProxy robot) {
        return robot.home().flatMap(home -> robot.status().pose().map(pose -> Flight.wayHome(pose.position(), home)));
    }

    /** Has an aircraft in the air come home and land, where it does not do so yet; nothing becomes of one whose home is not known. */
    void begin(Activation activation, HandlerContext context, String aircraft) {
        Return before = all.get(aircraft);
        if (before == null || before.command.isEmpty()) {
            robots.find(aircraft).ifPresent(robot -> {
                Return one = new Return(
                        activation.mission(),
                        percent(robot),
                        activation.priority(),
                        context::nowMillis,
                        move -> clearWays
                                .limit(activation, context, List.of(move))
                                .get(0),
                        Optional.empty());
                send(one, robot);
            });
            if (has(aircraft)) { // at once, as the answer is: a base that goes on sends it nowhere else
                context.post(new Input.Remember(Ids.NONE, prefix() + aircraft, of(aircraft)));
            }
        }
    }

    private static OptionalDouble percent(BoatProxy robot) {
        return robot.status().battery().stream()
                .mapToDouble(BatteryState::percent)
                .findFirst();
    }

    private void send(Return one, BoatProxy robot) {
        String aircraft = robot.boatId();
        way(robot).ifPresent(way -> {
            String id = ExplainedCommand.FOR_CHARGE + one.nowMillis.getAsLong() + "-" + ++made + "-" + aircraft;
            FollowPath path = new FollowPath(
                    id, Ids.NONE, Ids.NONE, way, OptionalDouble.of(Flight.HOME_MPS), 0, one.priority, false);
            Move move = new Move(new Addressee(aircraft, true, List.of()), path, Optional.empty(), Reply.NONE);
            all.put(aircraft, one.with(Optional.of(id)));
            robot.commands().submit(one.limit.apply(move).command());
        });
    }

    /**
     * Whether the aircraft is on the last metres of a command home, which it is left to end. Where others have it, or it has started anew, the command waits: it
     * would take off from where it was put down as soon as it can be commanded.
     */
    private static boolean isCarriedOut(BoatProxy robot, String command) {
        return robot.isCommanding() && robot.commands().isBegun(command);
    }

    /** Whether an aircraft comes home, or does so again once it has nothing else to do. */
    boolean has(String aircraft) {
        return all.containsKey(aircraft);
    }

    /** A person knows that the charge of an aircraft falls short, and sends it. */
    void end(String aircraft) {
        giveWay(aircraft);
        all.remove(aircraft);
    }

    /** A plan sends an aircraft, and the way was checked. */
    void giveWay(String aircraft) {
        Return one = all.get(aircraft);
        if (one != null && one.command.isPresent()) {
            all.put(aircraft, one.with(Optional.empty()));
            robots.find(aircraft).ifPresent(robot -> robot.commands().withdraw(one.command.get()));
        }
    }

    /** Takes in what happened to an aircraft. */
    void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            robots.find(reported.status().boatId()).ifPresent(this::follow);
        } else if (event instanceof FleetEvent.CommandCompleted done && isOf(done.boat(), done.command())) {
            all.remove(done.boat());
        } else if (event instanceof FleetEvent.CommandFailed failed && isOf(failed.boat(), failed.command())) {
            tell(all.remove(failed.boat()), failed.boat(), failed.reason());
        } else if (event instanceof FleetEvent.CommandWithdrawn taken && isOf(taken.boat(), taken.command())) {
            all.computeIfPresent(taken.boat(), (name, one) -> one.with(Optional.empty()));
        }
    }

    private boolean isOf(String aircraft, BoatCommand command) {
        Return one = all.get(aircraft);
        return one != null && one.is(command);
    }

    private void tell(Return one, String aircraft, String reason) {
        String words = aircraft + " could not come home, for which alone its charge lasted: " + reason;
        messages.tell(new OperatorMessage(
                one.nowMillis.getAsLong(),
                one.mission,
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                words,
                List.of(aircraft),
                ""));
    }

    @Override
    public String prefix() {
        return "charge-return/";
    }

    /** The mission whose flight was not sent, and its charge then, where that is known. */
    @Override
    public ListValue of(String aircraft) {
        return Optional.ofNullable(all.get(aircraft))
                .map(one -> {
                    List<Value> values = new ArrayList<>(List.of(new IntegerValue(one.mission)));
                    one.percent.ifPresent(percent -> values.add(new RealValue(percent)));
                    return new ListValue(values);
                })
                .orElse(AircraftMemory.NOTHING);
    }

    /** It comes home once it has nothing else to do, unless it has had another battery since. */
    @Override
    public void goOn(String aircraft, ListValue before, EngineHost host) {
        if (before.items().get(0) instanceof IntegerValue mission) {
            OptionalDouble percent = before.items().stream()
                    .filter(RealValue.class::isInstance)
                    .mapToDouble(value -> ((RealValue) value).value())
                    .findFirst();
            percent.ifPresent(charge -> earlier.put(aircraft, charge));
            all.putIfAbsent(
                    aircraft,
                    new Return(
                            mission.value(),
                            percent,
                            Priority.HIGH,
                            host::nowMillis,
                            move -> clearWays.limit(host.ask(view -> WayLimits.of(mission.value(), view)), move),
                            Optional.empty()));
        }
    }

    /** Whether nothing is to be done with an aircraft that an earlier base sent home: it has not said its charge yet, or has had another battery, and is forgotten. */
    private boolean isUndecided(BoatProxy robot) {
        Double before = earlier.get(robot.boatId());
        OptionalDouble now = percent(robot);
        if (before == null) {
            return false;
        } else if (now.isPresent()) {
            earlier.remove(robot.boatId());
        }
        if (now.isPresent() && now.getAsDouble() >= before + BatteryDefaults.RECHARGED_PERCENT) {
            all.remove(robot.boatId());
            return true;
        }
        return now.isEmpty();
    }

    private void follow(BoatProxy robot) {
        Return one = all.get(robot.boatId());
        if (one == null || isUndecided(robot)) {
            return;
        }
        boolean isDown = robot.status()
                .pose()
                .filter(pose -> pose.position().altM() < GROUND_M)
                .isPresent();
        boolean isTaken = one.command
                .filter(id -> robot.commands().visitedCount(id).isEmpty()) // only a person takes it without a word
                .isPresent();
        Optional<BoatCommand> current = robot.commands().current();
        boolean isByHand = one.command.isEmpty()
                && current.filter(other -> other.mission() == Ids.NONE).isPresent();
        if (isDown || isTaken || isByHand) {
            all.remove(robot.boatId());
            one.command.filter(id -> !isCarriedOut(robot, id)).ifPresent(robot.commands()::withdraw);
        } else if (one.command.isEmpty() && current.isEmpty()) {
            send(one, robot);
        }
    }
}
