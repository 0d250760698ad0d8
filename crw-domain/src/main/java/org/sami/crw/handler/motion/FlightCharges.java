package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
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
 * not known, nor of one that is to land or to stay where it is. For the fleet's thread.
 */
final class FlightCharges {
    private static final double GROUND_M = 0.5;
    private static final double PICTURE_S = 5; // to turn on, to stand and to take one

    private final ProxyRegistry robots;

    FlightCharges(ProxyRegistry robots) {
        this.robots = robots;
    }

    /** What is wrong with the charge of the robot that a move sends; empty where nothing is. */
    Optional<WayDoubt> doubt(Activation activation, Move move) {
        Optional<BoatProxy> robot = robots.find(move.addressee().boat());
        Optional<Endurance> endurance = robot.flatMap(BoatProxy::endurance);
        return robot.filter(known -> endurance.isPresent())
                .flatMap(known -> flight(activation, move.command(), known))
                .flatMap(flight -> FlightCheck.doubt(flight, endurance.orElseThrow()));
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
