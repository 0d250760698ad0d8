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
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Search Around: each aircraft flies a ring around the place where it is, at its altitude, and answers with the first target that its detector saw
 * within the ring, or with none. One that is not in the air cannot. The mission remembers where a ring is and the first target seen within it, for a base that goes on
 * with the search. For the fleet's thread.
 */
final class SearchAroundHandler implements ActivationHandler, Consumer<FleetEvent> {
    private static final int CORNERS = 8;
    private static final double SPEED_MPS = 6;
    private static final double RADIUS_M = 50;
    private static final Reply REPLY = new Reply("", UavEvents.CANNOT_FLY, "", true);

    private static final String MIDDLE = "middle";
    private static final String SEEN = "seen";

    private final Flights flights;
    private final Map<String, Search> byAircraft = new HashMap<>();

    /** One aircraft's search. */
    private static final class Search {
        final Activation activation;
        final HandlerContext context;
        final Addressee aircraft;
        final GeoPoint middle;
        final double radiusM;
        Optional<GeoPoint> seen; // the first target

        Search(Activation activation, HandlerContext context, Addressee aircraft, GeoPoint here, double radiusM) {
            this.activation = activation;
            this.context = context;
            this.aircraft = aircraft;
            this.radiusM = radiusM;
            middle = recalled(MIDDLE).orElse(here);
            seen = recalled(SEEN);
        }

        private Optional<GeoPoint> recalled(String what) {
            return !context.redelivered()
                    ? Optional.empty()
                    : context.query(view -> view.memory(activation.mission(), key(what)))
                            .filter(GeoPoint.class::isInstance)
                            .map(GeoPoint.class::cast);
        }

        void remember(String what, GeoPoint at) {
            context.post(new Input.Remember(activation.mission(), key(what), at));
        }

        private String key(String what) {
            return "search/" + activation.id() + "/" + aircraft.boat() + "/" + what;
        }

        boolean isWithin(GeoPoint at) {
            return Geodesy.distanceM(middle, at) <= radiusM;
        }
    }

    SearchAroundHandler(Flights flights, Sightings sightings) {
        this.flights = flights;
        sightings.listen((aircraft, number, at) -> seen(aircraft, at));
    }

    private void seen(String aircraft, GeoPoint at) {
        Search search = byAircraft.get(aircraft);
        if (search != null && search.seen.isEmpty() && search.isWithin(at)) {
            search.seen = Optional.of(at);
            search.remember(SEEN, at);
        }
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
        search.remember(MIDDLE, search.middle);
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
            over(done.command(), done.boat()).ifPresent(this::answer);
        } else if (event instanceof FleetEvent.CommandFailed failed) {
            over(failed.command(), failed.boat());
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            over(withdrawn.command(), withdrawn.boat());
        }
    }

    /** The search of which a command was the flight: it looks for nothing more. */
    private Optional<Search> over(BoatCommand command, String aircraft) {
        Optional<Search> search = Optional.ofNullable(byAircraft.get(aircraft))
                .filter(one -> one.activation.id() == command.activation());
        search.ifPresent(one -> byAircraft.remove(aircraft));
        return search;
    }

    private void answer(Search search) {
        Optional<GeoPoint> seen = search.seen;
        String type = seen.isPresent() ? UavEvents.TARGET_SEEN : UavEvents.NOTHING_SEEN;
        Map<String, Value> values =
                seen.map(at -> Map.<String, Value>of("at", at)).orElse(Map.of());
        search.context.post(new Input.Received(search.aircraft.answer(type, search.activation, values)));
    }
}
