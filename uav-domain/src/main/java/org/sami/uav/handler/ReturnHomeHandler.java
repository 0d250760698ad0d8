package org.sami.uav.handler;

import java.util.List;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.service.reach.Flight;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/**
 * Return Home: each aircraft flies to where it took off, at its altitude but not below 15 m, and lands there. One on the ground lands there.
 * One in the air that has not said where it took off stays in the air until it has, and the operator is told: below it may be water.
 */
final class ReturnHomeHandler implements ActivationHandler {
    private static final String NO_HOME =
            "it has not said where it took off, and flies there once it has; until then, send it where it can land";

    private final Flights flights;

    ReturnHomeHandler(Flights flights) {
        this.flights = flights;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double speedMps = Flights.number(activation, "speed", Flights.SPEED_MPS);
        flights.sendFromHere(
                activation,
                context,
                Addressee.of(activation, context),
                (aircraft, here) -> flight(aircraft, here, speedMps),
                Reply.way(UavEvents.LANDED, UavEvents.CANNOT_FLY));
    }

    private Flights.Flight flight(Addressee aircraft, GeoPoint here, double speedMps) {
        if (!flights.isAirborne(aircraft.boat())) {
            List<GeoPoint> down = List.of(Flights.at(here, 0)); // a command too, as one to take off may be under way
            return new Flights.Flight(aircraft, down, speedMps);
        }
        return flights.home(aircraft.boat())
                .map(home -> new Flights.Flight(aircraft, Flight.wayHome(here, home), speedMps))
                .orElseGet(() -> Flights.Flight.unknown(aircraft, NO_HOME));
    }
}
