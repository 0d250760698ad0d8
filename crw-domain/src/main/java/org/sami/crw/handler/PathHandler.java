package org.sami.crw.handler;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.operator.MessageSink;
import org.sami.crw.operator.OperatorMessage;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.PathService;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Path Request: a way for each boat from where it is to its point, around what is to be avoided, in as many ways as the markup
 * Selection Options asks for. One answer names all boats. A boat that has no way is in none of its sets of paths; the answer
 * says why, and so is the operator told.
 */
final class PathHandler implements ActivationHandler {
    static final String TYPE = "PathRequest";
    private static final String POINTS = "points";
    private static final String CLEARANCE = "clearance";
    private static final String DETOUR = "detour";

    private final PathService service;
    private final BoatPositions positions;
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;

    PathHandler(
            PathService service,
            BoatPositions positions,
            MessageSink messages,
            Computations computations,
            BoatErrors errors) {
        this.service = service;
        this.positions = positions;
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) throws Exception {
        List<Addressee> addressees = Addressee.of(activation, context);
        if (addressees.isEmpty()) {
            throw new IllegalArgumentException("No boat entered " + activation.place() + ": nobody to find a way for");
        }
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        Map<String, CrossTrackError> error = new HashMap<>();
        for (Addressee one : addressees) {
            from.put(one.boat(), positions.positionOf(one.boat()));
            error.put(one.boat(), errors.of(one.boat()));
        }
        computations.compute(activation, context, new Computations.Task<Map<String, PathService.Options>>() {
            @Override
            public String what() {
                return "the ways of " + addressees.size() + " boats";
            }

            @Override
            public Map<String, PathService.Options> compute() {
                Map<String, PathService.Options> options = new LinkedHashMap<>();
                addressees.forEach(one ->
                        options.put(one.boat(), find(one, from.get(one.boat()), error.get(one.boat()), activation)));
                return options;
            }

            @Override
            public void found(Map<String, PathService.Options> options) {
                answer(activation, context, options);
            }
        });
    }

    private void answer(Activation activation, HandlerContext context, Map<String, PathService.Options> found) {
        Map<String, List<PathAnswer.Way>> ways = new LinkedHashMap<>();
        Map<String, Value> noWay = new LinkedHashMap<>();
        Set<String> reasons = new LinkedHashSet<>();
        found.forEach((boat, options) -> {
            if (options.ways().isEmpty()) {
                noWay.put(boat, new TextValue(options.reason()));
                tell(activation, context, Priority.HIGH, boat + ": " + options.reason(), boat);
            } else {
                ways.put(boat, options.ways());
                reasons.add(options.reason());
            }
        });
        if (Markups.criterion(activation).isPresent()) {
            reasons.forEach(reason -> tell(activation, context, Priority.LOW, "Path: " + reason));
        }
        Map<String, Value> values =
                Map.of("options", new ListValue(List.copyOf(sets(ways))), "noWay", ProxyMaps.toValue(noWay));
        context.post(new Input.Received(Occurrence.answer(
                EventNames.PATH_RESPONSE, activation, List.copyOf(found.keySet()), List.of(), values)));
    }

    private PathService.Options find(
            Addressee addressee, Optional<GeoPoint> from, CrossTrackError error, Activation activation) {
        Optional<GeoPoint> to = addressee.values(activation, POINTS).stream()
                .map(byBoat -> ProxyMaps.read(byBoat, GeoPoint.class).get(addressee.boat()))
                .filter(point -> point != null)
                .findFirst();
        if (from.isEmpty()) {
            return none("its position is not known yet");
        }
        if (to.isEmpty()) {
            return none("it was given no location");
        }
        Water water = Restrictions.water(activation, from.get(), error);
        double detour =
                activation.value(DETOUR).isPresent() ? ActivationFields.number(activation, DETOUR) : PathProblem.DETOUR;
        PathProblem problem =
                new PathProblem(from.get(), to.get(), water, ActivationFields.metres(activation, CLEARANCE), detour);
        return service.find(problem, Markups.criterion(activation), Markups.optionsWanted(activation));
    }

    private static PathService.Options none(String reason) {
        return new PathService.Options(List.of(), "There is no way: " + reason);
    }

    /** The first ways of all, the second ones and so on; a boat that has no more of them keeps its last. */
    private static Set<MapValue> sets(Map<String, List<PathAnswer.Way>> ways) {
        int most = ways.values().stream().mapToInt(List::size).max().orElse(0);
        Set<MapValue> sets = new LinkedHashSet<>();
        for (int i = 0; i < most; i++) {
            Map<String, Value> paths = new LinkedHashMap<>();
            int rank = i;
            ways.forEach((boat, own) -> paths.put(
                    boat, new GeoPath(own.get(Math.min(rank, own.size() - 1)).points())));
            sets.add(ProxyMaps.toValue(paths));
        }
        return sets;
    }

    private void tell(Activation activation, HandlerContext context, Priority priority, String text, String... boats) {
        messages.tell(new OperatorMessage(
                context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.DOMAIN,
                priority,
                text,
                List.of(boats),
                ""));
    }
}
