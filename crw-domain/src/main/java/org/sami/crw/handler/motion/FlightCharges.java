package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.reach.Flight;
import org.sami.crw.service.reach.FlightCheck;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Whether the charges of aircraft last for what they are about to fly, and for the way home: they pay for time. Nothing is said of one of which position or charge are
 * not known, nor of one that is to land or to stay where it is, nor where the operator has accepted it on the same flight. For the fleet's thread.
 */
final class FlightCharges {
    private static final double GROUND_M = 0.5;
    private static final double PICTURE_S = 5; // to turn on, to stand and to take one
    private static final double SPEED_MPS = 1; // of one that stays where it is: any

    private final ProxyRegistry robots;
    private final AcceptedShortfalls accepted = new AcceptedShortfalls();

    FlightCharges(ProxyRegistry robots) {
        this.robots = robots;
    }

    /** What is wrong with the charge of the robot that a move sends; empty where nothing is. */
    Optional<WayDoubt> doubt(Activation activation, Move move) {
        Optional<BoatProxy> robot = robots.find(move.addressee().boat());
        Optional<Endurance> endurance = robot.flatMap(BoatProxy::endurance);
        return robot.filter(known -> endurance.isPresent())
                .flatMap(known -> flight(activation, move.command(), known))
                .filter(flight -> !accepted.covers(
                        move.addressee(),
                        activation.mission(),
                        flight.end(),
                        FlightCheck.shortfallS(flight, endurance.orElseThrow())))
                .flatMap(flight -> FlightCheck.doubt(flight, endurance.orElseThrow()));
    }

    /** What the operator has accepted. */
    AcceptedShortfalls accepted() {
        return accepted;
    }

    /** The operator sends a robot, although its charge may not last. */
    void accept(Activation activation, Move move) {
        robots.find(move.addressee().boat())
                .ifPresent(robot -> robot.endurance()
                        .ifPresent(endurance -> flight(activation, move.command(), robot)
                                .ifPresent(flight -> accepted.add(
                                        move.addressee(),
                                        activation.mission(),
                                        flight.end(),
                                        FlightCheck.shortfallS(flight, endurance)))));
    }

    /** Takes in what happened to a robot. */
    void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            reported.status()
                    .pose()
                    .ifPresent(pose -> accepted.isAt(
                            reported.status().boatId(), pose.position().altM() < GROUND_M));
        }
    }

    /**
     * How long a robot can wait in the air until its charge lasts for the way home alone, in seconds, 0 or more; empty for one on the ground, and where its position or
     * its charge are not known.
     */
    OptionalDouble waitS(Move move) {
        Optional<BoatProxy> robot = robots.find(move.addressee().boat()).filter(BoatProxy::isFlying);
        Optional<Double> waitS = robot.flatMap(known -> known.endurance()
                .flatMap(endurance -> known.status()
                        .pose()
                        .map(BoatPose::position)
                        .filter(here -> here.altM() >= GROUND_M)
                        .map(here -> Math.max(
                                0,
                                endurance.seconds()
                                        - flight(known, here, move.command()).homeS()))));
        return waitS.isPresent() ? OptionalDouble.of(waitS.get()) : OptionalDouble.empty();
    }

    /** One that stays where it is until it comes home. */
    private static Flight flight(BoatProxy robot, GeoPoint here, BoatCommand command) {
        return new Flight(robot.boatId(), here, List.of(), SPEED_MPS, 0, robot.home(), command.water());
    }

    /** Whether the robot that a move sends can come home: it is known where it is, and where that is. */
    boolean canComeHome(Move move) {
        return ChargeReturns.isWayKnown(robots, move.addressee().boat());
    }

    private static Optional<Flight> flight(Activation activation, BoatCommand command, BoatProxy robot) {
        boolean isFlown = command instanceof Panorama || (command instanceof FollowPath path && !path.nothingIsLeft());
        return robot.status()
                .pose()
                .map(BoatPose::position)
                .filter(from -> isFlown)
                .map(from -> new Flight(
                        robot.boatId(),
                        from,
                        command instanceof FollowPath ? command.unvisitedPoints() : List.of(),
                        SpeedChoice.mps(activation, command, robot),
                        command instanceof Panorama panorama ? panorama.pictures() * PICTURE_S : 0,
                        home(robot, from),
                        command.water()));
    }

    /** One on the ground takes off there, and that is its home then. */
    private static Optional<GeoPoint> home(BoatProxy robot, GeoPoint from) {
        return from.altM() < GROUND_M ? Optional.of(from) : robot.home();
    }
}
