package org.sami.crw.handler.planning;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.operator.message.MessageSink;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.assembly.AssemblyAlgorithm;
import org.sami.crw.service.assembly.AssemblyProblem;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Assemble Location Request: a location of its own for each boat, near a point. The mission remembers who has which, so that
 * boats that are added one by one (thesis 6.3.2) do not get the same one. It answers with the locations of all of them: the plan keeps
 * one table, and whoever came earlier still finds its own in it.
 * Of a spacing that leaves boats no way between those that lie there the operator is told, once a mission.
 */
public final class AssembleHandler implements ActivationHandler {
    public static final String TYPE = "AssembleLocationRequest";
    private static final String MEMORY = "assembly";

    private final AssemblyAlgorithm algorithm;
    private final BoatPositions positions;
    private final MessageSink messages;
    private final BoatErrors errors;

    public AssembleHandler(
            AssemblyAlgorithm algorithm, BoatPositions positions, MessageSink messages, BoatErrors errors) {
        this.algorithm = algorithm;
        this.positions = positions;
        this.messages = messages;
        this.errors = errors;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<String> boats =
                Addressee.of(activation, context).stream().map(Addressee::boat).toList();
        if (boats.isEmpty()) {
            throw new IllegalArgumentException("No boat entered " + activation.place() + ": nobody to assemble");
        }
        Map<String, GeoPoint> assembled = remembered(activation, context);
        boolean wereMany = assembled.size() > 1;
        assembled.keySet().removeAll(boats);
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        boats.forEach(boat -> from.put(boat, positions.positionOf(boat)));
        GeoPoint centre = ActivationFields.point(activation, "location");
        double spacingM = ActivationFields.metres(activation, "spacing");
        CrossTrackError error = errors.of(boats);
        Map<String, GeoPoint> points = algorithm.assemble(new AssemblyProblem(
                from,
                centre,
                spacingM,
                List.copyOf(assembled.values()),
                context.query(view -> PlanAreas.water(activation, view, centre, error))));
        assembled.putAll(points);
        if (assembled.size() > 1 && !wereMany && spacingM < error.berthM()) {
            tellTooNear(activation, context, spacingM, error);
        }
        context.post(List.of(
                new Input.Remember(activation.mission(), MEMORY, ProxyMaps.toValue(assembled)),
                new Input.Received(Occurrence.answer(
                        EventNames.ASSEMBLE_RESPONSE,
                        activation,
                        boats,
                        List.of(),
                        Map.of("points", ProxyMaps.toValue(assembled))))));
    }

    private void tellTooNear(Activation activation, HandlerContext context, double spacingM, CrossTrackError error) {
        String words = String.format(
                Locale.ROOT,
                "Assembly: boats that lie %.0f m apart leave others no way between them, which wait near by; %.0f m are enough for boats whose positions err by"
                        + " %.1f m",
                spacingM,
                Math.ceil(error.berthM()),
                error.positionM());
        messages.tell(ActivationMessages.of(activation, context, Priority.MEDIUM, words, activation.proxies()));
    }

    private static Map<String, GeoPoint> remembered(Activation activation, HandlerContext context) {
        return context.query(view -> {
            Map<String, GeoPoint> points = view.memory(activation.mission(), MEMORY)
                    .map(value -> ProxyMaps.read(value, GeoPoint.class))
                    .orElseGet(LinkedHashMap::new);
            points.keySet().retainAll(view.proxies());
            return points;
        });
    }
}
