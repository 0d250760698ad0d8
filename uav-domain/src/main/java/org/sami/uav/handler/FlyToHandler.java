package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Fly To: each aircraft flies to the location; where tasks entered, to those of its tasks one after another ({@link TaskFlights}). A location without an
 * altitude gets that of the event.
 */
final class FlyToHandler implements ActivationHandler {
    private final Flights flights;
    private final TaskFlights tasks;

    FlyToHandler(Flights flights, TaskFlights tasks) {
        this.flights = flights;
        this.tasks = tasks;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Flights.Flight> now = new ArrayList<>();
        for (Addressee aircraft : Addressee.of(activation, context)) {
            if (aircraft.byProxy()) {
                now.add(flight(activation, aircraft, ActivationFields.required(activation, "location")));
            } else {
                for (TaskId task : aircraft.tasks()) {
                    Addressee one = new Addressee(aircraft.boat(), false, List.of(task));
                    Value location = one.values(activation, "location").stream()
                            .findFirst()
                            .orElseGet(() -> ActivationFields.required(activation, "location"));
                    tasks.add(activation, context, flight(activation, one, location));
                }
            }
        }
        flights.send(activation, context, now, Reply.way(UavEvents.REACHED_LOCATION, UavEvents.CANNOT_FLY));
        tasks.startWaiting();
    }

    private Flights.Flight flight(Activation activation, Addressee aircraft, Value location) {
        GeoPoint to = ActivationFields.point(location, "location");
        double altM = Flights.number(activation, "altitude", Flights.ALTITUDE_M);
        double speedMps = Flights.number(activation, "speed", Flights.SPEED_MPS);
        return new Flights.Flight(aircraft, flights.raised(aircraft.boat(), List.of(to), altM), speedMps);
    }
}
