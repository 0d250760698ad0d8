package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.message.MessageSink;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoPoint;

/**
 * Warns the operator, once in a mission and before the boats go, of places in which boats would lie so close together that others cannot pass between
 * them (docs/services.md). For the fleet's thread.
 */
public final class NearPlaces {
    private static final String WARNED_KEY = "near-places";

    private final MessageSink messages;
    private final BoatErrors errors;

    public NearPlaces(MessageSink messages, BoatErrors errors) {
        this.messages = messages;
        this.errors = errors;
    }

    /**
     * Looks at the places of boats.
     *
     * @param activation what sends the boats there or finds these places; its mission has not ended
     * @param what the message's first word
     * @param places where each boat is to lie
     */
    public void look(Activation activation, HandlerContext context, String what, Map<String, GeoPoint> places) {
        double apartM = leastDistanceM(List.copyOf(places.values()));
        CrossTrackError error = errors.of(List.copyOf(places.keySet()));
        double berthM = new SafetyMargin(error).berthM(MotionDefaults.SEPARATION_M);
        long mission = activation.mission();
        if (apartM >= berthM
                || context.query(view -> view.memory(mission, WARNED_KEY).isPresent())) {
            return;
        }
        String words = String.format(
                Locale.ROOT,
                "%s: boats that lie %.0f m apart leave others no way between them, which wait near by; %.0f m are enough for boats whose positions err by"
                        + " %.1f m",
                what,
                apartM,
                Math.ceil(berthM),
                error.positionM());
        messages.tell(ActivationMessages.of(activation, context, Priority.MEDIUM, words, activation.proxies()));
        context.post(List.of(new Input.Remember(mission, WARNED_KEY, new BooleanValue(true))));
    }

    private static double leastDistanceM(List<GeoPoint> places) {
        double leastM = Double.POSITIVE_INFINITY;
        for (int i = 0; i < places.size(); i++) {
            for (GeoPoint other : places.subList(i + 1, places.size())) {
                leastM = Math.min(leastM, Geodesy.distanceM(places.get(i), other));
            }
        }
        return leastM;
    }
}
