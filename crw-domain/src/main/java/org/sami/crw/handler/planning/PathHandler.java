package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.event.PathOption;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.Markups;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.message.MessageSink;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.PathService;
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
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Path Request: a way for each boat from its position to its point, around areas to avoid, in as many alternatives as the markup Selection Options
 * asks for. One answer names all boats. A boat without a way is in none of the sets of paths; the answer and a message to the operator give the
 * reason.
 */
public final class PathHandler implements ActivationHandler {
    public static final String TYPE = "PathRequest";
    private static final String POINTS = "points";
    private static final String CLEARANCE = "clearance";
    private static final String DETOUR = "detour";
    private static final int NAMED = 5;

    private final PathService service;
    private final BoatPositions positions;
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;

    public PathHandler(
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
        Map<Addressee, Optional<Start>> starts = new LinkedHashMap<>();
        for (Addressee one : addressees) {
            starts.put(
                    one,
                    positions
                            .positionOf(one.boat())
                            .map(at -> new Start(
                                    at,
                                    context.query(
                                            view -> PlanAreas.water(activation, view, at, errors.of(one.boat()))))));
        }
        computations.compute(activation, context, new Computations.Task<Map<String, Found>>() {
            @Override
            public String what() {
                return "the ways of " + addressees.size() + " boats";
            }

            @Override
            public Map<String, Found> compute() {
                Map<String, Found> options = new LinkedHashMap<>();
                starts.forEach((one, start) -> options.put(one.boat(), find(one, start, activation)));
                return options;
            }

            @Override
            public void found(Map<String, Found> options) {
                answer(activation, context, options);
            }
        });
    }

    private void answer(Activation activation, HandlerContext context, Map<String, Found> found) {
        Map<String, Found> ways = new LinkedHashMap<>();
        Map<String, Value> noWay = new LinkedHashMap<>();
        Set<String> reasons = new LinkedHashSet<>();
        found.forEach((boat, one) -> {
            if (one.ways().isEmpty()) {
                noWay.put(boat, new TextValue(one.reason()));
                tell(activation, context, Priority.HIGH, boat + ": " + one.reason(), boat);
            } else {
                ways.put(boat, one);
                reasons.add(one.reason());
            }
        });
        if (Markups.criterion(activation).isPresent()) {
            reasons.forEach(reason -> tell(activation, context, Priority.LOW, "Path: " + reason));
        }
        List<PathOption> options = options(ways);
        tellWhatIsKept(activation, context, options);
        boolean areRecords = context.query(view -> view.vocabulary().types().containsKey(PathOption.TYPE));
        List<Value> values = options.stream()
                .<Value>map(option -> areRecords ? option.toValue() : option.pathsValue())
                .toList();
        context.post(new Input.Received(Occurrence.answer(
                EventNames.PATH_RESPONSE,
                activation,
                List.copyOf(found.keySet()),
                List.of(),
                Map.of("options", new ListValue(values), "noWay", ProxyMaps.toValue(noWay)))));
    }

    /** The distance that each set of paths keeps from no-go areas, and its cost; nothing in open water. */
    private void tellWhatIsKept(Activation activation, HandlerContext context, List<PathOption> options) {
        for (int i = 0; i < options.size(); i++) {
            String kept = options.get(i).kept();
            String which =
                    options.size() == 1 ? "Paths: " : "Paths, option " + (i + 1) + " of " + options.size() + ": ";
            if (!kept.isEmpty()) {
                tell(activation, context, Priority.LOW, which + kept);
            }
        }
    }

    /** The first ways of all, the second ones and so on, each set once; a boat that has no more of them keeps its last. */
    private static List<PathOption> options(Map<String, Found> ways) {
        int most =
                ways.values().stream().mapToInt(one -> one.ways().size()).max().orElse(0);
        Map<Map<String, GeoPath>, PathOption> options = new LinkedHashMap<>();
        for (int i = 0; i < most; i++) {
            int rank = i;
            Map<String, KeptWay> chosen = new LinkedHashMap<>();
            ways.forEach((boat, own) ->
                    chosen.put(boat, own.ways().get(Math.min(rank, own.ways().size() - 1))));
            PathOption option = option(chosen);
            options.putIfAbsent(option.paths(), option);
        }
        return List.copyOf(options.values());
    }

    private static PathOption option(Map<String, KeptWay> chosen) {
        Map<String, GeoPath> paths = new LinkedHashMap<>();
        Set<String> methods = new LinkedHashSet<>();
        List<String> kept = new ArrayList<>();
        double totalM = 0;
        double longestM = 0;
        for (Map.Entry<String, KeptWay> one : chosen.entrySet()) {
            PathAnswer.Way way = one.getValue().way();
            paths.put(one.getKey(), new GeoPath(way.points()));
            methods.add(way.method());
            one.getValue().kept().ifPresent(words -> kept.add(one.getKey() + " " + words));
            totalM += way.lengthM();
            longestM = Math.max(longestM, way.lengthM());
        }
        int more = kept.size() - NAMED;
        String words = String.join("; ", kept.subList(0, Math.min(NAMED, kept.size())))
                + (more > 0 ? "; and " + more + " boats more" : "");
        return new PathOption(paths, totalM, longestM, String.join(", ", methods), words);
    }

    /** Where a boat's way begins, and where the boat may go. */
    private record Start(GeoPoint at, Water water) {}

    private Found find(Addressee addressee, Optional<Start> from, Activation activation) {
        Optional<GeoPoint> to = addressee.values(activation, POINTS).stream()
                .map(byBoat -> ProxyMaps.read(byBoat, GeoPoint.class).get(addressee.boat()))
                .filter(point -> point != null)
                .findFirst();
        if (from.isEmpty()) {
            return Found.none("its position is not known yet");
        }
        if (to.isEmpty()) {
            return Found.none("it was given no location");
        }
        double detour =
                activation.value(DETOUR).isPresent() ? ActivationFields.number(activation, DETOUR) : PathProblem.DETOUR;
        GeoPoint at = from.get().at();
        Water water = from.get().water();
        PathProblem problem =
                new PathProblem(at, to.get(), water, ActivationFields.metres(activation, CLEARANCE), detour);
        PathService.Options options =
                service.find(problem, Markups.criterion(activation), Markups.requestedOptions(activation));
        return new Found(
                options.ways().stream()
                        .map(way -> new KeptWay(way, way.words(at, water)))
                        .toList(),
                options.reason());
    }

    /**
     * A way of a boat.
     *
     * @param kept the distance that it keeps from no-go areas, in words; empty in open water
     */
    private record KeptWay(PathAnswer.Way way, Optional<String> kept) {}

    /**
     * The ways of a boat.
     *
     * @param reason why the first was chosen, or why there is none
     */
    private record Found(List<KeptWay> ways, String reason) {
        static Found none(String reason) {
            return new Found(List.of(), "There is no way: " + reason);
        }
    }

    private void tell(Activation activation, HandlerContext context, Priority priority, String text, String... boats) {
        messages.tell(ActivationMessages.of(activation, context, priority, text, List.of(boats)));
    }
}
