package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.event.Numbers;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.boat.SessionMemory;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Move;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * Flights along points, for the handlers that need one. Altitudes are metres above the place of the take-off. An aircraft on the ground climbs on the
 * spot before it goes anywhere. What depends on where an aircraft is waits until the aircraft has said it, as after a restart of the base, or until it is
 * withdrawn or aborted. For the fleet's thread; it passes the engine's steps on to it.
 */
final class Flights implements Consumer<FleetEvent>, HostListener, LaterMoves {
    /** The legal ceiling of small aircraft in Europe, in metres above ground. */
    static final double CEILING_M = 120;

    /** Altitude in metres of flights that name none. */
    static final double ALTITUDE_M = 30;

    /** Speed in m/s of flights that name none. */
    static final double SPEED_MPS = 8;

    private static final double GROUND_M = 0.5;
    private static final double LAYER_M = 4;
    private static final int LAYERS = 8; // then they begin again: aircraft so far apart in the fleet rarely meet

    private final ProxyRegistry robots;
    private final MotionCommands motion;
    private final Executor fleet;
    private final List<Waiting> waiting = new ArrayList<>();

    /**
     * A flight that waits.
     *
     * @param ofEndPlace whether its mission is over, where nothing stands any longer
     * @param isPlaced whether the aircraft has said where it is, and something else is not known
     */
    private record Waiting(
            Activation activation,
            HandlerContext context,
            Addressee aircraft,
            BiFunction<Addressee, GeoPoint, Flight> flight,
            Reply reply,
            boolean ofEndPlace,
            boolean isPlaced) {
        /** Its command, without the points, which are not known. */
        Move placeless() {
            return move(activation, context, new Flight(aircraft, List.of(), SPEED_MPS), reply, "");
        }

        boolean stands() {
            return ofEndPlace || aircraft.stands(activation, context);
        }

        boolean isOf(long mission, List<String> named) {
            return activation.mission() == mission && (named.isEmpty() || named.contains(aircraft.boat()));
        }

        boolean isDue(GeoPoint here) {
            return !isPlaced || flight.apply(aircraft, here).unknown().isEmpty();
        }
    }

    Flights(ProxyRegistry robots, MotionCommands motion, Executor fleet) {
        this.robots = robots;
        this.motion = motion;
        this.fleet = fleet;
    }

    /** Where an aircraft said it was last. */
    Optional<GeoPoint> position(String aircraft) {
        return robots.find(aircraft).flatMap(proxy -> proxy.status().pose()).map(BoatPose::position);
    }

    /** Where it took off, on the ground; empty for one that has not said it, as one that this base met in the air. */
    Optional<GeoPoint> home(String aircraft) {
        return robots.find(aircraft).flatMap(BoatProxy::home);
    }

    /** Whether it is in the air. */
    boolean isAirborne(String aircraft) {
        return position(aircraft).filter(at -> at.altM() > GROUND_M).isPresent();
    }

    /** Whether its battery is neither low nor critical, as far as it has said, to this base or to one before it. */
    boolean isCharged(String aircraft, HandlerContext context) {
        return robots.find(aircraft)
                .flatMap(proxy -> proxy.status().battery())
                .map(battery -> battery.level().name())
                .or(() -> context.query(view -> SessionMemory.BATTERY.of(aircraft, view)))
                .filter(level -> !level.equals(BatteryLevel.NOMINAL.name()))
                .isEmpty();
    }

    /** A point at another altitude. */
    static GeoPoint at(GeoPoint point, double altM) {
        return new GeoPoint(point.latDeg(), point.lonDeg(), altM);
    }

    /**
     * Points of which those on the ground, as clicks on a map are, get an altitude: that of the flight and, so that aircraft do not meet, a layer of the
     * aircraft's own above it.
     */
    List<GeoPoint> raised(String aircraft, List<GeoPoint> points, double altM) {
        double layerM = Math.min(CEILING_M, altM + layer(aircraft) * LAYER_M);
        return lifted(points, Math.max(altM, layerM));
    }

    /** Points of which those on the ground get an altitude. */
    static List<GeoPoint> lifted(List<GeoPoint> points, double altM) {
        return points.stream()
                .map(point -> point.altM() == 0 ? at(point, altM) : point)
                .toList();
    }

    private int layer(String aircraft) {
        return Math.max(0, robots.boatIds().indexOf(aircraft)) % LAYERS;
    }

    /** A number that the plan gives, else a default. */
    static double number(Activation activation, String field, double otherwise) {
        return activation.value(field).map(Numbers::real).orElse(otherwise);
    }

    /**
     * One aircraft's flight.
     *
     * @param points along which it flies; empty where it is not known where the aircraft is, or where the flight begins in the air and it is not there
     * @param remembered the path, at the altitudes at which the plan wants it, of which the mission remembers how far it came; without points there is
     *     nothing to do then. Empty where the mission remembers nothing
     * @param unknown what is not known of where it is to fly: it stays where it is in the air; empty where all is known
     */
    record Flight(
            Addressee aircraft,
            List<GeoPoint> points,
            double speedMps,
            Optional<GeoPath> remembered,
            Optional<String> unknown) {
        Flight {
            points = List.copyOf(points);
        }

        /** Along points that are known, of which nothing is remembered. */
        Flight(Addressee aircraft, List<GeoPoint> points, double speedMps) {
            this(aircraft, points, speedMps, Optional.empty(), Optional.empty());
        }

        /** The same, of which the mission remembers how far it came. */
        static Flight remembered(Addressee aircraft, List<GeoPoint> points, double speedMps, List<GeoPoint> asked) {
            return new Flight(aircraft, points, speedMps, Optional.of(new GeoPath(asked)), Optional.empty());
        }

        /** Not known yet. The operator is told, and the plan is answered nothing, as the flight comes later. */
        static Flight unknown(Addressee aircraft, String why) {
            return new Flight(aircraft, List.of(), SPEED_MPS, Optional.empty(), Optional.of(why));
        }
    }

    /** Sends flights; those that no aircraft can fly are answered as failed. */
    void send(Activation activation, HandlerContext context, List<Flight> flights, Reply reply) {
        List<Move> moves = new ArrayList<>();
        for (Flight flight : flights) {
            replaceWaiting(activation, flight.aircraft());
            Optional<String> reason = refusal(flight);
            if (reason.isPresent()) {
                Reply failed = reason.equals(flight.unknown()) ? Reply.NONE : reply; // for the former comes later
                motion.refuse(activation, context, flight.aircraft(), failed, reason.get());
                boolean stays = flight.unknown().isPresent()
                        && !context.redelivered(); // after a restart it may be on its way there
                if (stays) {
                    moves.add(HoverHandler.stay(activation, flight.aircraft(), Reply.NONE, "-stay"));
                }
            } else {
                moves.add(move(activation, context, flight, reply, ""));
            }
        }
        motion.send(activation, context, moves);
    }

    /**
     * Sends flights that follow from where the aircraft are. One that has not said it yet, but is known, gets its flight when it has, and so does one of which
     * something else is not known; the operator is told of that.
     */
    void sendFromHere(
            Activation activation,
            HandlerContext context,
            List<Addressee> all,
            BiFunction<Addressee, GeoPoint, Flight> flight,
            Reply reply) {
        boolean ofEndPlace =
                !context.query(view -> view.mission(activation.mission()).isPresent());
        List<Flight> now = new ArrayList<>();
        List<Waiting> later = new ArrayList<>();
        for (Addressee aircraft : all) {
            Optional<GeoPoint> here = position(aircraft.boat());
            if (here.isEmpty() && robots.find(aircraft.boat()).isPresent()) {
                if (!motion.isTakenBack(activation.id(), aircraft.boat())) {
                    replaceWaiting(activation, aircraft);
                    waiting.add(new Waiting(activation, context, aircraft, flight, reply, ofEndPlace, false));
                }
            } else {
                Flight one = here.map(at -> flight.apply(aircraft, at))
                        .orElseGet(() -> new Flight(aircraft, List.of(), SPEED_MPS));
                now.add(one);
                if (one.unknown().isPresent() && !motion.isTakenBack(activation.id(), aircraft.boat())) {
                    later.add(new Waiting(activation, context, aircraft, flight, reply, ofEndPlace, true));
                }
            }
        }
        send(activation, context, now, reply);
        waiting.addAll(later);
    }

    /** What a mission asks of an aircraft replaces what it asked before, as with commands. */
    private void replaceWaiting(Activation activation, Addressee aircraft) {
        List<Waiting> older = waiting.stream()
                .filter(one -> one.activation.mission() == activation.mission()
                        && one.aircraft.boat().equals(aircraft.boat()))
                .toList();
        waiting.removeAll(older);
        older.stream()
                .filter(one -> one.activation.id() != activation.id())
                .forEach(one -> motion.replace(one.activation, one.context, one.aircraft, one.reply));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.CommandsWithdrawn withdrawn) {
                fleet.execute(() -> waiting.removeIf(one -> one.isOf(withdrawn.mission(), withdrawn.proxies())));
            }
        }
    }

    @Override
    public Set<Long> missions(String robot) {
        return waiting.stream()
                .filter(one -> one.aircraft.boat().equals(robot))
                .map(one -> one.activation.mission())
                .collect(Collectors.toSet());
    }

    @Override
    public void withdraw(long mission, List<String> named, Optional<String> why, MotionCommands through) {
        List<Waiting> taken =
                waiting.stream().filter(one -> one.isOf(mission, named)).toList();
        waiting.removeAll(taken);
        taken.forEach(one -> through.takeBack(one.activation, one.context, one.placeless(), why));
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            String aircraft = reported.status().boatId();
            position(aircraft).ifPresent(here -> {
                List<Waiting> due = waiting.stream()
                        .filter(one -> one.aircraft.boat().equals(aircraft) && one.isDue(here))
                        .toList();
                waiting.removeAll(due);
                due.stream()
                        .filter(Waiting::stands)
                        .forEach(one -> sendFromHere(
                                one.activation, one.context, List.of(one.aircraft), one.flight, one.reply));
            });
        }
    }

    /** Why a flight cannot be flown, as far as is known now; empty where it can. */
    Optional<String> refusal(Flight flight) {
        String aircraft = flight.aircraft().boat();
        boolean isPlaced = position(aircraft).isPresent();
        if (isPlaced && !robots.find(aircraft).map(BoatProxy::isFlying).orElse(true)) {
            return Optional.of(aircraft + " does not fly");
        } else if (flight.unknown().isPresent()) {
            return flight.unknown();
        } else if (flight.points().isEmpty() && flight.remembered().isEmpty()) {
            return Optional.of(isPlaced ? "it is not in the air" : "it has not said yet where it is");
        }
        return flight.points().stream()
                .mapToDouble(GeoPoint::altM)
                .filter(altM -> altM > CEILING_M)
                .boxed()
                .findFirst()
                .map(altM -> String.format("%.0f m is above the ceiling of %.0f m", altM, CEILING_M));
    }

    /**
     * The command of a flight.
     *
     * @param suffix of its id, where one activation gives an aircraft several commands
     */
    static Move move(Activation activation, HandlerContext context, Flight flight, Reply reply, String suffix) {
        String aircraft = flight.aircraft().boat();
        Optional<String> key = flight.remembered().map(path -> PathProgress.flightKey(aircraft, path));
        int visited = flight.remembered()
                .map(path -> visited(activation, context, aircraft, path))
                .orElse(0);
        FollowPath command = new FollowPath(
                Move.commandId(activation, flight.aircraft()) + suffix,
                activation.mission(),
                activation.id(),
                flight.points(),
                OptionalDouble.of(flight.speedMps()),
                visited,
                activation.priority(),
                false);
        return new Move(flight.aircraft(), command, key.map(one -> new PathProgress.Along(one, 0)), reply);
    }

    /** Also where an earlier version remembered it, which left the altitudes out. */
    private static int visited(Activation activation, HandlerContext context, String aircraft, GeoPath path) {
        return Stream.of(PathProgress.flightKey(aircraft, path), PathProgress.key(aircraft, path))
                .mapToInt(key -> PathProgress.visited(
                        context, activation.mission(), key, path.points().size()))
                .max()
                .orElse(0);
    }
}
