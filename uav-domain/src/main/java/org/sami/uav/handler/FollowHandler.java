package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Move;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ProxyValue;

/**
 * Follow: each aircraft flies behind another robot, at a distance and an altitude and, so that followers do not meet, a layer of its own above that, until the
 * plan asks for something else. It gets a new place to fly to whenever the robot has moved a few metres.
 *
 * <p>Where that place is in a no-go area or outside of the fence, or there is no way to it, the aircraft stays where it is in the air and the operator is told once; it
 * goes on when the robot is where it can be followed. The robot itself, where it is among the aircraft, is left out, and the operator is told. One whose command was taken from it, as by a stop of the fleet, and one that waits and is aborted, do not follow any longer: they would fly off by
 * themselves. For the fleet's thread; it passes the engine's steps on to it.
 */
final class FollowHandler implements ActivationHandler, Consumer<FleetEvent>, HostListener, LaterMoves {
    private static final double STEP_M = 6; // the robot's way between two commands
    private static final double DISTANCE_M = 15;

    private final ProxyRegistry robots;
    private final Flights flights;
    private final MotionCommands motion;
    private final MessageSink messages;
    private final Executor fleet;
    private final Map<Long, Following> open = new LinkedHashMap<>(); // by activation

    FollowHandler(ProxyRegistry robots, Flights flights, MotionCommands motion, MessageSink messages, Executor fleet) {
        this.robots = robots;
        this.flights = flights;
        this.motion = motion;
        this.messages = messages;
        this.fleet = fleet;
    }

    /** One activation. */
    private static final class Following {
        final Activation activation;
        final HandlerContext context;
        final String leader;
        final List<Follower> aircraft;
        long commands; // their number, the last part of the id of each

        Following(Activation activation, HandlerContext context, String leader, List<Follower> aircraft) {
            this.activation = activation;
            this.context = context;
            this.leader = leader;
            this.aircraft = aircraft;
            commands =
                    context.redelivered() ? context.nowMillis() : 0; // a base before this one has used the first ones
        }

        String nextSuffix() {
            commands++;
            return "-" + commands;
        }
    }

    /** One aircraft. */
    private static final class Follower {
        final Addressee addressee;
        State state = State.FOLLOWS;
        Optional<GeoPoint> seen = Optional.empty(); // the robot's place for which it was sent last
        Optional<String> command = Optional.empty(); // that is under way

        Follower(Addressee addressee) {
            this.addressee = addressee;
        }

        String name() {
            return addressee.boat();
        }

        /** Whether it is this one, has no command now, and is to get one. */
        boolean willFly(String aircraft) {
            return name().equals(aircraft) && state != State.IS_OVER && command.isEmpty();
        }

        boolean isDue(GeoPoint leader) {
            return state == State.WAITS || seen.isEmpty() || Geodesy.distanceM(seen.get(), leader) >= STEP_M;
        }
    }

    private enum State {
        FOLLOWS,
        /** Where the robot is now, it cannot follow it. */
        WAITS,
        /** It follows no longer, or never can. */
        IS_OVER
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, "robot") instanceof ProxyValue leader)) {
            throw new IllegalArgumentException("\"robot\" is no robot: " + activation.value("robot"));
        }
        List<Addressee> all = Addressee.of(activation, context);
        if (all.stream().anyMatch(one -> one.boat().equals(leader.proxy()))) {
            tell(
                    activation,
                    context,
                    leader.proxy(),
                    Priority.MEDIUM,
                    "is the one that is followed, and follows nobody");
        }
        List<Follower> aircraft = all.stream()
                .filter(one -> !one.boat().equals(leader.proxy()))
                .filter(one -> !motion.isTakenBack(activation.id(), one.boat()))
                .map(Follower::new)
                .toList();
        Following following = new Following(activation, context, leader.proxy(), aircraft);
        open.put(activation.id(), following);
        flights.position(leader.proxy()).ifPresent(at -> follow(following, at));
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            for (Following one : new ArrayList<>(open.values())) {
                if (one.leader.equals(reported.status().boatId())) {
                    flights.position(one.leader).ifPresent(at -> follow(one, at));
                }
            }
        } else if (event instanceof FleetEvent.CommandCompleted done) {
            leftTheQueue(done.command());
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            leftTheQueue(withdrawn.command());
        }
    }

    /** Done, or another command took its place: what it is to do next is left to the following. */
    private void leftTheQueue(BoatCommand command) {
        Optional.ofNullable(open.get(command.activation())).stream()
                .flatMap(following -> following.aircraft.stream())
                .filter(one -> one.command.equals(Optional.of(command.commandId())))
                .forEach(one -> one.command = Optional.empty());
    }

    private void follow(Following following, GeoPoint leader) {
        for (Follower one : following.aircraft) {
            if (one.state != State.IS_OVER
                    && one.isDue(leader)
                    && one.addressee.stands(following.activation, following.context)) {
                if (isTakenFrom(one)) {
                    end(following, one);
                } else {
                    flights.position(one.name()).ifPresent(here -> send(following, one, here, leader));
                }
            }
        }
    }

    private void end(Following following, Follower one) {
        one.state = State.IS_OVER;
        tell(following, one, Priority.MEDIUM, "does not follow " + following.leader + " any longer");
    }

    @Override
    public Set<Long> missions(String robot) {
        return missionsWith(one -> one.willFly(robot));
    }

    /** An aircraft that has caught up with a robot that stands still follows it. */
    @Override
    public Set<Long> begunMissions(String robot) {
        return missionsWith(one -> one.willFly(robot) && one.seen.isPresent());
    }

    private Set<Long> missionsWith(Predicate<Follower> kind) {
        return open.values().stream()
                .filter(following -> following.aircraft.stream().anyMatch(kind))
                .map(following -> following.activation.mission())
                .collect(Collectors.toSet());
    }

    /** One that flies now ends when its command is taken from it. Its failure is no answer to the plan. */
    @Override
    public void withdraw(long mission, List<String> named, Optional<String> why, MotionCommands through) {
        for (Following following : open.values()) {
            if (following.activation.mission() == mission) {
                following.aircraft.stream()
                        .filter(one -> named.isEmpty() || named.contains(one.name()))
                        .filter(one -> one.willFly(one.name()))
                        .forEach(one -> end(following, one));
            }
        }
    }

    private boolean isTakenFrom(Follower one) {
        return one.command
                .filter(id -> robots.find(one.name()).stream()
                        .flatMap(proxy -> commands(proxy.commands()))
                        .noneMatch(command -> command.commandId().equals(id)))
                .isPresent();
    }

    private static Stream<BoatCommand> commands(ProxyCommands of) {
        return Stream.concat(of.current().stream(), of.waiting().stream());
    }

    /** The command replaces the one before it; nothing is to be answered for either. */
    private void send(Following following, Follower one, GeoPoint here, GeoPoint leader) {
        one.seen = Optional.of(leader);
        double altM = Flights.number(following.activation, "altitude", Flights.ALTITUDE_M);
        List<GeoPoint> to = flights.raised(one.name(), List.of(behind(following.activation, here, leader)), altM);
        Flights.Flight flight = new Flights.Flight(one.addressee, to, Flights.SPEED_MPS);
        Optional<String> never = flights.refusal(flight);
        if (never.isPresent()) {
            one.state = State.IS_OVER;
            motion.refuse(following.activation, following.context, one.addressee, Reply.NONE, never.get());
            return;
        }
        Move move = Flights.move(following.activation, following.context, flight, Reply.NONE, following.nextSuffix());
        Optional<String> before = one.command;
        one.command = Optional.of(move.command().commandId());
        Optional<String> refusal = motion.sendUnasked(following.activation, following.context, move);
        if (refusal.isEmpty()) {
            goOn(following, one);
        } else {
            one.command = before;
            stay(following, one, refusal.get());
        }
    }

    private void goOn(Following following, Follower one) {
        if (one.state == State.WAITS) {
            one.state = State.FOLLOWS;
            tell(following, one, Priority.LOW, "follows " + following.leader + " again");
        }
    }

    private void stay(Following following, Follower one, String why) {
        if (one.state == State.WAITS) {
            return;
        }
        one.state = State.WAITS;
        tell(
                following,
                one,
                Priority.HIGH,
                "stays where it is, and follows " + following.leader + " again once it can: " + why);
        if (one.command.isPresent()) { // else it has nothing to stop for
            Move stop = HoverHandler.stay(following.activation, one.addressee, Reply.NONE, following.nextSuffix());
            one.command = Optional.of(stop.command().commandId());
            motion.send(following.activation, following.context, List.of(stop));
        }
    }

    /** A later message of the same takes its place. */
    private void tell(Activation activation, HandlerContext context, String aircraft, Priority priority, String words) {
        messages.tell(new OperatorMessage(
                context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.DOMAIN,
                priority,
                aircraft + " " + words,
                List.of(aircraft),
                "follow/" + aircraft));
    }

    private void tell(Following following, Follower one, Priority priority, String words) {
        tell(following.activation, following.context, one.name(), priority, words);
    }

    /** On the line from the leader to the follower, so that it does not fly over the leader. */
    private static GeoPoint behind(Activation activation, GeoPoint here, GeoPoint leader) {
        double distanceM = Flights.number(activation, "distance", DISTANCE_M);
        double awayM = Geodesy.distanceM(leader, here);
        double share = awayM > 1 ? Math.min(1, distanceM / awayM) : 0;
        return new GeoPoint(
                leader.latDeg() + (here.latDeg() - leader.latDeg()) * share,
                leader.lonDeg() + (here.lonDeg() - leader.lonDeg()) * share,
                0);
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded ended) {
                fleet.execute(() -> open.remove(ended.activation()));
            }
        }
    }
}
