package org.sami.crw.handler.planning;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.NearPlaces;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.placement.AssemblyAlgorithm;
import org.sami.crw.service.placement.AssemblyProblem;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;

/**
 * Assemble Location Request: a separate location for each boat, near a point. The mission remembers the locations, so that boats that arrive one by
 * one (thesis 6.3.2) do not get the same one. The answer holds the locations of all of them, because the plan keeps one table in which earlier boats
 * still find theirs. The operator is warned of places that are too close together ({@link NearPlaces}).
 */
public final class AssembleHandler implements ActivationHandler {
    public static final String TYPE = "AssembleLocationRequest";
    private static final String MEMORY = "assembly";

    private final AssemblyAlgorithm algorithm;
    private final BoatPositions positions;
    private final NearPlaces near;
    private final BoatErrors errors;

    public AssembleHandler(AssemblyAlgorithm algorithm, BoatPositions positions, NearPlaces near, BoatErrors errors) {
        this.algorithm = algorithm;
        this.positions = positions;
        this.near = near;
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
        assembled.keySet().removeAll(boats);
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        boats.forEach(boat -> from.put(boat, positions.positionOf(boat)));
        GeoPoint centre = ActivationFields.point(activation, "location");
        CrossTrackError error = errors.of(boats);
        Map<String, GeoPoint> points = algorithm.assemble(new AssemblyProblem(
                from,
                centre,
                ActivationFields.metres(activation, "spacing"),
                List.copyOf(assembled.values()),
                context.query(view -> PlanAreas.water(activation, view, centre, error))));
        assembled.putAll(points);
        near.look(activation, context, "Assembly", assembled);
        context.post(List.of(
                new Input.Remember(activation.mission(), MEMORY, ProxyMaps.toValue(assembled)),
                new Input.Received(Occurrence.answer(
                        EventNames.ASSEMBLE_RESPONSE,
                        activation,
                        boats,
                        List.of(),
                        Map.of("points", ProxyMaps.toValue(assembled))))));
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
