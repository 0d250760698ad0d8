package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ProxyValue;

/**
 * Follow: each aircraft flies behind another robot, at a distance and an altitude and, so that followers do not meet, a layer of its own above that, until the
 * plan asks for something else. It gets a new place to fly to whenever the robot has moved a few metres. For the fleet's thread; it passes the engine's steps on to it.
 */
final class FollowHandler implements ActivationHandler, Consumer<FleetEvent>, HostListener {
    private static final double STEP_M = 6; // the robot's way between two commands
    private static final double DISTANCE_M = 15;

    private final ProxyRegistry robots;
    private final Flights flights;
    private final MotionCommands motion;
    private final Executor fleet;
    private final Map<Long, Following> open = new LinkedHashMap<>(); // by activation

    FollowHandler(ProxyRegistry robots, Flights flights, MotionCommands motion, Executor fleet) {
        this.robots = robots;
        this.flights = flights;
        this.motion = motion;
        this.fleet = fleet;
    }

    /** One activation. */
    private static final class Following {
        final Activation activation;
        final HandlerContext context;
        final String leader;
        final List<Addressee> aircraft;
        final Map<String, GeoPoint> seen = new HashMap<>(); // by aircraft: the robot's place for which it was sent
        final Set<String> refused = new HashSet<>();
        int commands;

        Following(Activation activation, HandlerContext context, String leader, List<Addressee> aircraft) {
            this.activation = activation;
            this.context = context;
            this.leader = leader;
            this.aircraft = aircraft;
        }
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, "robot") instanceof ProxyValue leader)) {
            throw new IllegalArgumentException("\"robot\" is no robot: " + activation.value("robot"));
        }
        List<Addressee> aircraft = Addressee.of(activation, context).stream()
                .filter(one -> !one.boat().equals(leader.proxy()))
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
        }
    }

    private void follow(Following following, GeoPoint leader) {
        for (Addressee one : following.aircraft) {
            GeoPoint seen = following.seen.get(one.boat());
            if ((seen == null || Geodesy.distanceM(seen, leader) >= STEP_M)
                    && one.stands(following.activation, following.context)) {
                flights.position(one.boat()).ifPresent(here -> send(following, one, here, leader));
            }
        }
    }

    /** The command replaces the one before it; nothing is to be answered for either. A refusal is said once. */
    private void send(Following following, Addressee one, GeoPoint here, GeoPoint leader) {
        following.seen.put(one.boat(), leader);
        double altM = Flights.number(following.activation, "altitude", Flights.ALTITUDE_M);
        List<GeoPoint> to = flights.raised(one.boat(), List.of(behind(following.activation, here, leader)), altM);
        Flights.Flight flight = new Flights.Flight(one, to, Flights.SPEED_MPS);
        Optional<String> reason = flights.refusal(flight);
        if (reason.isPresent()) {
            if (following.refused.add(one.boat())) {
                motion.refuse(following.activation, following.context, one, Reply.NONE, reason.get());
            }
        } else {
            following.commands++;
            String suffix = "-" + following.commands;
            robots.find(one.boat())
                    .ifPresent(proxy -> proxy.commands()
                            .submit(Flights.move(following.activation, following.context, flight, Reply.NONE, suffix)
                                    .command()));
        }
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
