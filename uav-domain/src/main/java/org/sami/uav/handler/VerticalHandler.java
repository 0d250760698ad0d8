package org.sami.uav.handler;

import java.util.List;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.Reply;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Take Off, Climb To and Land: each aircraft climbs or descends where it is. */
final class VerticalHandler implements ActivationHandler {
    private static final double GROUND_M = 0;

    private final Flights flights;
    private final String answer;
    private final boolean down;

    private VerticalHandler(Flights flights, String answer, boolean down) {
        this.flights = flights;
        this.answer = answer;
        this.down = down;
    }

    /** To the altitude that the event names. */
    static VerticalHandler climbing(Flights flights, String answer) {
        return new VerticalHandler(flights, answer, false);
    }

    /** To the ground. */
    static VerticalHandler landing(Flights flights) {
        return new VerticalHandler(flights, UavEvents.LANDED, true);
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double altM = down ? GROUND_M : ActivationFields.metres(activation, "altitude");
        flights.sendFromHere(
                activation,
                context,
                Addressee.of(activation, context),
                (aircraft, here) -> new Flights.Flight(aircraft, List.of(Flights.at(here, altM)), Flights.SPEED_MPS),
                Reply.way(answer, UavEvents.CANNOT_FLY));
    }
}
