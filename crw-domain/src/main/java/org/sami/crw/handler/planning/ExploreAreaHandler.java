package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.PlannedSwaps;
import org.sami.crw.handler.activation.Restrictions;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.ExecutePathHandler;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Move;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.message.MessageSink;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageAlgorithm;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.crw.service.coverage.Ranges;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/**
 * Proxy Explore Area: divides an area among the boats that enter together; each drives its share in lanes (thesis 6.2). A message to the operator
 * gives the length of the tracks and the uncovered rest.
 *
 * <p>The mission remembers the shares: a boat that returns after an interrupt goes on at its first unvisited point. A boat that comes later takes
 * over the rest of one that has left the mission; without such a rest it completes at once.
 */
public final class ExploreAreaHandler implements ActivationHandler {
    public static final String TYPE = "ProxyExploreArea";
    private static final String AREA = "area";
    private static final String SPACING = "spacing";

    private final CoverageAlgorithm algorithm;
    private final BoatPositions positions;
    private final MotionCommands motion;
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;
    private final BoatReach reach;
    private final ExploredAreas explored;
    /** What waits until an area is divided, by mission and area. */
    private final Map<String, List<Consumer<Map<String, GeoPath>>>> underWay = new HashMap<>();

    public ExploreAreaHandler(
            CoverageAlgorithm algorithm,
            BoatPositions positions,
            MotionCommands motion,
            MessageSink messages,
            Computations computations,
            BoatErrors errors,
            BoatReach reach,
            ExploredAreas explored) {
        this.reach = reach;
        this.explored = explored;
        this.algorithm = algorithm;
        this.positions = positions;
        this.motion = motion;
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) throws Exception {
        GeoArea area = Restrictions.area(ActivationFields.required(activation, AREA), AREA);
        double spacingM = ActivationFields.metres(activation, SPACING);
        String key = ExplorationShares.key(area, spacingM);
        Exploration one = new Exploration(activation, context, area, spacingM, key);
        List<Consumer<Map<String, GeoPath>>> others = underWay.get(one.name());
        if (others == null) {
            explore(one, context.query(view -> ExplorationShares.remembered(activation.mission(), key, view)));
        } else {
            others.add(shares -> exploreToo(one, shares));
        }
    }

    /** What an activation asks. */
    private record Exploration(
            Activation activation, HandlerContext context, GeoArea area, double spacingM, String key) {
        String name() {
            return activation.mission() + " " + key;
        }

        /** Where it is kept what the operator is to be asked before boats begin: of this activation alone. */
        String doubt() {
            return key + "/doubt/" + activation.id();
        }
    }

    /** It waited for another activation's division: what goes wrong now concerns it alone. */
    private void exploreToo(Exploration one, Map<String, GeoPath> shares) {
        try {
            explore(one, shares);
        } catch (Exception fault) {
            one.context.post(new Input.HandlerFailed(one.activation.id(), String.valueOf(fault.getMessage())));
        }
    }

    private void explore(Exploration one, Map<String, GeoPath> shares) throws Exception {
        List<Addressee> newcomers = Addressee.of(one.activation, one.context).stream()
                .filter(addressee -> !shares.containsKey(addressee.boat()))
                .toList();
        if (shares.isEmpty() && !newcomers.isEmpty()) {
            divide(newcomers, one);
            return;
        }
        if (!newcomers.isEmpty()) {
            takeOver(newcomers, shares, one.activation, one.context);
        }
        Optional<String> doubt = one.context
                .query(view -> view.memory(one.activation.mission(), one.doubt()))
                .filter(TextValue.class::isInstance)
                .map(words -> ((TextValue) words).value());
        drive(one, shares, Map.of(), doubt, OptionalDouble.empty());
    }

    private void drive(
            Exploration one,
            Map<String, GeoPath> shares,
            Map<String, String> noWay,
            Optional<String> doubt,
            OptionalDouble uncoveredM2) {
        Activation activation = one.activation;
        HandlerContext context = one.context;
        context.post(ExplorationShares.remember(activation.mission(), one.key, shares));
        if (!shares.isEmpty()) {
            explored.explore(one.name(), activation, context, one.area, one.spacingM, shares, uncoveredM2);
        }
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            if (noWay.containsKey(addressee.boat())) {
                motion.refuse(activation, context, addressee, noWay.get(addressee.boat()));
            } else if (!computations.areElsewhere() || addressee.stands(activation, context)) {
                GeoPath path = shares.getOrDefault(addressee.boat(), new GeoPath(List.of()));
                int behind = behind(addressee.boat(), path, activation, context);
                Move move = ExecutePathHandler.move(activation, context, addressee, path, behind, false);
                moves.add(doubt.map(words -> move.doubted(new WayDoubt(WayDoubt.Kind.CHARGE, words)))
                        .orElse(move));
            }
        }
        motion.send(activation, context, moves);
    }

    private void divide(List<Addressee> boats, Exploration one) throws Exception {
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        boats.forEach(boat -> from.put(boat.boat(), positions.positionOf(boat.boat())));
        Map<String, Double> speedsMps = new LinkedHashMap<>();
        from.keySet().forEach(boat -> reach.cruiseMps(boat).ifPresent(mps -> speedsMps.put(boat, mps)));
        Map<String, Double> radiiM = new LinkedHashMap<>();
        from.keySet().forEach(boat -> radiiM.put(boat, reach.turningRadiusM(boat)));
        CoverageProblem problem = new CoverageProblem(
                from,
                one.area,
                one.spacingM,
                one.context.query(view -> PlanAreas.avoided(one.activation, view)),
                Restrictions.within(one.activation),
                errors.of(List.copyOf(from.keySet())),
                ranges(boats, one),
                speedsMps,
                radiiM);
        underWay.put(one.name(), new ArrayList<>());
        boolean[] begun = new boolean[1];
        try {
            computations.compute(one.activation, one.context, new Dividing(one, problem));
            begun[0] = true;
        } finally {
            if (!begun[0]) {
                letOthersGo(one, new LinkedHashMap<>());
            }
        }
    }

    private Ranges ranges(List<Addressee> boats, Exploration one) {
        Map<String, Double> metres = new LinkedHashMap<>();
        boats.forEach(
                boat -> reach.rangeM(boat.boat(), one.activation).ifPresent(range -> metres.put(boat.boat(), range)));
        if (!PlannedSwaps.keepWaysHome(one.activation, one.context)) {
            return Ranges.out(metres, one.context.query(view -> PlannedSwaps.areOf(one.activation.mission(), view)));
        }
        Map<String, GeoPoint> home = new LinkedHashMap<>();
        boats.forEach(boat -> reach.home(boat.boat()).ifPresent(at -> home.put(boat.boat(), at)));
        boolean keepHome =
                ActivationFields.flag(one.activation, PlannedSwaps.KEEP_HOME).orElse(false);
        return new Ranges(metres, home, false, keepHome);
    }

    private final class Dividing implements Computations.Task<Coverage> {
        private final Exploration one;
        private final CoverageProblem problem;

        Dividing(Exploration one, CoverageProblem problem) {
            this.one = one;
            this.problem = problem;
        }

        @Override
        public String what() {
            return "the division of the area to explore";
        }

        @Override
        public boolean commandsBoats() {
            return true;
        }

        @Override
        public Coverage compute() {
            return algorithm.cover(problem);
        }

        private String likelyMissed() {
            return AreaCoverage.of(problem.area(), problem.spacingM(), problem.avoid(), problem.within())
                    .likelyMissed(problem.error().positionM());
        }

        @Override
        public void found(Coverage coverage) {
            Map<String, GeoPath> shares = new LinkedHashMap<>();
            coverage.shares().forEach((boat, share) -> shares.put(boat, share.path()));
            tell(
                    one.activation,
                    one.context,
                    "Exploring " + coverage.words() + likelyMissed(),
                    List.copyOf(shares.keySet()));
            Optional<String> doubt = coverage.doubt();
            doubt.ifPresent(words ->
                    one.context.post(new Input.Remember(one.activation.mission(), one.doubt(), new TextValue(words))));
            drive(one, shares, coverage.noWay(), doubt, OptionalDouble.of(coverage.uncoveredM2()));
            letOthersGo(one, shares);
        }

        @Override
        public void gone() {
            motion.forget(one.activation.id());
            letOthersGo(one, new LinkedHashMap<>());
        }
    }

    private void letOthersGo(Exploration one, Map<String, GeoPath> shares) {
        List<Consumer<Map<String, GeoPath>>> others = underWay.remove(one.name());
        if (others != null) {
            others.forEach(other -> other.accept(shares));
        }
    }

    /** Each newcomer gets the longest of what is left of boats that are in the mission no longer. */
    private void takeOver(
            List<Addressee> newcomers, Map<String, GeoPath> shares, Activation activation, HandlerContext context) {
        Set<String> present = context.query(view -> inMission(activation, view));
        for (Addressee newcomer : newcomers) {
            String gone = "";
            List<GeoPoint> most = List.of();
            for (Map.Entry<String, GeoPath> share : shares.entrySet()) {
                List<GeoPoint> left = left(share.getKey(), share.getValue(), activation, context);
                if (!present.contains(share.getKey()) && left.size() > most.size()) {
                    gone = share.getKey();
                    most = left;
                }
            }
            String words = gone.isEmpty()
                    ? newcomer.boat() + " has nothing to explore: the area is divided among others"
                    : newcomer.boat() + " explores what " + gone + " has left: " + most.size() + " waypoints";
            shares.remove(gone);
            shares.put(newcomer.boat(), new GeoPath(most));
            tell(activation, context, words, List.of(newcomer.boat()));
        }
    }

    private static Set<String> inMission(Activation activation, EngineView view) {
        Set<String> present = new HashSet<>(activation.proxies());
        view.mission(activation.mission())
                .ifPresent(mission -> mission.marking()
                        .values()
                        .forEach(tokens -> tokens.forEach(token -> {
                            if (token instanceof Token.Proxy proxy) {
                                present.add(proxy.proxy());
                            }
                        })));
        return present;
    }

    private static List<GeoPoint> left(String boat, GeoPath path, Activation activation, HandlerContext context) {
        return path.points()
                .subList(behind(boat, path, activation, context), path.points().size());
    }

    /** How many points nobody has to drive to again: a lane that was begun and not ended is driven from its beginning. */
    private static int behind(String boat, GeoPath path, Activation activation, HandlerContext context) {
        int size = path.points().size();
        int visited = PathProgress.visited(context, activation.mission(), PathProgress.key(boat, path), size);
        return visited == size ? size : Math.max(0, visited - 1);
    }

    private void tell(Activation activation, HandlerContext context, String text, List<String> boats) {
        messages.tell(ActivationMessages.of(activation, context, Priority.MEDIUM, text, boats));
    }
}
