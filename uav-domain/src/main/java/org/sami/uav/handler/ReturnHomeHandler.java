package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;

/** Return Home: each aircraft flies to where it took off, at its altitude but not below {@link #LEAST_M}, and lands there. One on the ground lands there. */
final class ReturnHomeHandler implements ActivationHandler {
    private static final double LEAST_M = 15; // above trees and masts

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
                (aircraft, here) -> new Flights.Flight(aircraft, way(aircraft.boat(), here), speedMps, false),
                Reply.way(UavEvents.LANDED, ""));
    }

    private List<GeoPoint> way(String aircraft, GeoPoint here) {
        if (!flights.isAirborne(aircraft)) {
            return List.of(Flights.at(here, 0)); // a command too, as one to take off may be under way
        }
        List<GeoPoint> way = new ArrayList<>();
        double altM = Math.max(here.altM(), LEAST_M);
        if (altM > here.altM()) {
            way.add(Flights.at(here, altM));
        }
        GeoPoint home = flights.home(aircraft).orElse(here);
        way.add(Flights.at(home, altM));
        way.add(Flights.at(home, 0));
        return way;
    }
}
