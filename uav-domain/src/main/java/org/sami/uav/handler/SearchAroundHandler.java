package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Search Around: each aircraft flies a ring around the place where it is, at its altitude, and answers with the first target that its detector saw
 * within the ring, or with none. One that is not in the air cannot. For the fleet's thread.
 */
final class SearchAroundHandler implements ActivationHandler, Consumer<FleetEvent> {
    private static final int CORNERS = 8;
    private static final double SPEED_MPS = 6;
    private static final double RADIUS_M = 50;
    private static final Reply REPLY = new Reply("", UavEvents.CANNOT_FLY, "", true);

    private final Flights flights;
    private final Sightings sightings;
    private final Map<String, Search> byAircraft = new HashMap<>();

    private record Search(
            Activation activation, HandlerContext context, Addressee aircraft, GeoPoint middle, double radiusM) {}

    SearchAroundHandler(Flights flights, Sightings sightings) {
        this.flights = flights;
        this.sightings = sightings;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double radiusM = Flights.number(activation, "radius", RADIUS_M);
        flights.sendFromHere(
                activation,
                context,
                Addressee.of(activation, context),
                (aircraft, here) -> begin(new Search(activation, context, aircraft, here, radiusM)),
                REPLY);
    }

    private Flights.Flight begin(Search search) {
        String aircraft = search.aircraft.boat();
        if (!flights.isAirborne(aircraft)) {
            return new Flights.Flight(search.aircraft, List.of(), SPEED_MPS);
        }
        sightings.begin(aircraft);
        byAircraft.put(aircraft, search);
        return new Flights.Flight(search.aircraft, ring(search.middle, search.radiusM), SPEED_MPS);
    }

    /** Half the radius out, so that the camera sees the middle and the edge; and back to the middle. */
    private static List<GeoPoint> ring(GeoPoint middle, double radiusM) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i <= CORNERS; i++) {
            double angle = 2 * Math.PI * i / CORNERS;
            GeoPoint corner = Geodesy.offset(middle, radiusM / 2 * Math.sin(angle), radiusM / 2 * Math.cos(angle));
            points.add(Flights.at(corner, middle.altM()));
        }
        points.add(middle);
        return points;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.CommandCompleted done) {
            Search search = byAircraft.get(done.boat());
            if (search != null && search.activation.id() == done.command().activation()) {
                byAircraft.remove(done.boat());
                answer(search);
            }
        }
    }

    private void answer(Search search) {
        Optional<GeoPoint> seen = sightings.of(search.aircraft.boat()).values().stream()
                .filter(at -> Geodesy.distanceM(search.middle, at) <= search.radiusM)
                .findFirst();
        String type = seen.isPresent() ? UavEvents.TARGET_SEEN : UavEvents.NOTHING_SEEN;
        Map<String, Value> values =
                seen.map(at -> Map.<String, Value>of("at", at)).orElse(Map.of());
        search.context.post(new Input.Received(search.aircraft.answer(type, search.activation, values)));
    }
}
