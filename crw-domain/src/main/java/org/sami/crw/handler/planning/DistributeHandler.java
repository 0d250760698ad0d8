package org.sami.crw.handler.planning;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.Markups;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.Restrictions;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.NearPlaces;
import org.sami.crw.message.MessageSink;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.allocation.WorkItem;
import org.sami.crw.service.placement.SpreadLocations;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;

/**
 * Distribute Locations Request: a list of locations for each boat, in the order of its visits; each location is in one list. The locations are those
 * of the activation, or spread over its area at a spacing. They are divided as the markup Optimize asks, with ways around areas to avoid. A location
 * that no boat can reach is in no list, and a boat without a known position gets none; the operator is notified of both, and of lists that end too
 * close together ({@link NearPlaces}).
 */
public final class DistributeHandler implements ActivationHandler {
    public static final String TYPE = "DistributeLocationsRequest";
    private static final String LOCATIONS = "locations";
    private static final String AREA = "area";

    private final AllocationService service;
    private final BoatPositions positions;
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;
    private final NearPlaces near;

    public DistributeHandler(
            AllocationService service,
            BoatPositions positions,
            MessageSink messages,
            Computations computations,
            BoatErrors errors,
            NearPlaces near) {
        this.service = service;
        this.positions = positions;
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
        this.near = near;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) throws Exception {
        List<String> boats =
                Addressee.of(activation, context).stream().map(Addressee::boat).toList();
        Map<String, GeoPoint> from = new LinkedHashMap<>();
        boats.forEach(boat -> positions.positionOf(boat).ifPresent(at -> from.put(boat, at)));
        if (from.isEmpty()) {
            throw new IllegalStateException("There is no boat whose position is known, of " + boats);
        }
        CrossTrackError error = errors.of(boats);
        Water water = context.query(view ->
                PlanAreas.water(activation, view, from.values().iterator().next(), error));
        computations.compute(activation, context, new Computations.Task<AllocationService.Options>() {
            @Override
            public String what() {
                return "the distribution of locations";
            }

            @Override
            public AllocationService.Options compute() {
                return service.solve(
                        AllocationProblem.ofVisits(from, locations(activation, error))
                                .in(water),
                        Markups.criterion(activation),
                        1);
            }

            @Override
            public void found(AllocationService.Options options) {
                answer(activation, context, boats, options);
            }
        });
    }

    private void answer(
            Activation activation, HandlerContext context, List<String> boats, AllocationService.Options options) {
        Map<String, ListValue> lists = new LinkedHashMap<>();
        boats.forEach(boat -> lists.put(
                boat,
                new ListValue(List.copyOf(options.best().paths().getOrDefault(boat, List.of()).stream()
                        .map(WorkItem::location)
                        .toList()))));
        near.look(activation, context, "Distribution", ends(options));
        options.best()
                .shortfall()
                .ifPresent(words -> tell(activation, context, Priority.HIGH, "Distribution: " + words));
        options.best()
                .unallocated()
                .forEach(one -> tell(activation, context, Priority.HIGH, "Distribution: " + one.words()));
        if (Markups.criterion(activation).isPresent()) {
            tell(activation, context, Priority.LOW, "Distribution: " + options.reason());
        }
        context.post(new Input.Received(Occurrence.answer(
                EventNames.DISTRIBUTE_RESPONSE,
                activation,
                boats,
                List.of(),
                Map.of("locations", ProxyMaps.toValue(lists)))));
    }

    /** Where each boat is left: at the last location of its list. */
    private static Map<String, GeoPoint> ends(AllocationService.Options options) {
        Map<String, GeoPoint> ends = new LinkedHashMap<>();
        options.best()
                .paths()
                .forEach((boat, path) ->
                        path.stream().reduce((a, b) -> b).ifPresent(last -> ends.put(boat, last.location())));
        return ends;
    }

    private void tell(Activation activation, HandlerContext context, Priority priority, String text) {
        messages.tell(ActivationMessages.of(activation, context, priority, text, List.of()));
    }

    private static List<GeoPoint> locations(Activation activation, CrossTrackError error) {
        Optional<GeoArea> area = activation.value(AREA).map(value -> Restrictions.area(value, AREA));
        if (activation.value(LOCATIONS).isPresent() || area.isEmpty()) {
            return ActivationFields.points(ActivationFields.required(activation, LOCATIONS), LOCATIONS);
        }
        Water water = Restrictions.water(activation, area.get().outline().get(0), error);
        List<GeoPoint> spread = SpreadLocations.over(area.get(), ActivationFields.metres(activation, "spacing"), water);
        if (spread.isEmpty()) {
            throw new IllegalArgumentException("There is no room for a location in the area, clear of no-go areas");
        }
        return spread;
    }
}
