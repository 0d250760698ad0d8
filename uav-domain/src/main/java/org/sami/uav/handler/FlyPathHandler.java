package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Fly Path: each aircraft flies its own path of the map, from the first location that it has not visited in this mission; one without a path has nothing
 * to do. Locations without an altitude get that of the event.
 */
final class FlyPathHandler implements ActivationHandler {
    private final Flights flights;

    FlyPathHandler(Flights flights) {
        this.flights = flights;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double altM = Flights.number(activation, "altitude", Flights.ALTITUDE_M);
        double speedMps = Flights.number(activation, "speed", Flights.SPEED_MPS);
        List<Flights.Flight> all = new ArrayList<>();
        for (Addressee aircraft : Addressee.of(activation, context)) {
            List<GeoPoint> path = path(activation, aircraft);
            all.add(Flights.Flight.remembered(
                    aircraft,
                    flights.raised(aircraft.boat(), path, altM),
                    speedMps,
                    Flights.lifted(path, altM))); // without the aircraft's layer, which may be another after a restart
        }
        flights.send(activation, context, all, Reply.way(UavEvents.PATH_FLOWN, UavEvents.CANNOT_FLY));
    }

    private static List<GeoPoint> path(Activation activation, Addressee aircraft) {
        for (Value paths : aircraft.values(activation, "paths")) {
            Map<String, GeoPath> byAircraft = ProxyMaps.read(paths, GeoPath.class);
            if (byAircraft.containsKey(aircraft.boat())) {
                return byAircraft.get(aircraft.boat()).points();
            }
        }
        return List.of();
    }
}
