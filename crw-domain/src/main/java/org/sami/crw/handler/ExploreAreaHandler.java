package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.decision.MessageSink;
import org.sami.crw.decision.OperatorMessage;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageAlgorithm;
import org.sami.crw.service.coverage.CoverageProblem;
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

/**
 * Proxy Explore Area: the area is divided among the boats that enter together, and each drives its share in lanes (thesis 6.2). The
 * operator is told how long the tracks are and what stays uncovered.
 *
 * <p>The mission remembers who has which share: a boat that comes back, after an interrupt, goes on at its first unvisited point. A
 * boat that comes later takes over what a boat that has left the mission did not drive; where nobody left anything, it completes
 * at once.
 */
final class ExploreAreaHandler implements ActivationHandler {
    static final String TYPE = "ProxyExploreArea";
    private static final String AREA = "area";
    private static final String SPACING = "spacing";

    private final CoverageAlgorithm algorithm;
    private final BoatPositions positions;
    private final MotionCommands motion;
    private final MessageSink messages;

    ExploreAreaHandler(
            CoverageAlgorithm algorithm, BoatPositions positions, MotionCommands motion, MessageSink messages) {
        this.algorithm = algorithm;
        this.positions = positions;
        this.motion = motion;
        this.messages = messages;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Addressee> addressees = Addressee.of(activation, context);
        GeoArea area = Restrictions.area(Fields.required(activation, AREA), AREA);
        double spacingM = Fields.metres(activation, SPACING);
        String key = "explore/" + PathProgress.key(Double.toString(spacingM), new GeoPath(allPoints(area)));
        Map<String, GeoPath> shares = remembered(activation, context, key);
        List<Addressee> newcomers = addressees.stream()
                .filter(one -> !shares.containsKey(one.boat()))
                .toList();
        Map<String, String> noWay = new LinkedHashMap<>();
        if (shares.isEmpty() && !newcomers.isEmpty()) {
            shares.putAll(divide(newcomers, area, spacingM, activation, context, noWay));
        } else if (!newcomers.isEmpty()) {
            takeOver(newcomers, shares, activation, context);
        }
        context.post(new Input.Remember(activation.mission(), key, ProxyMaps.toValue(shares)));
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : addressees) {
            if (noWay.containsKey(addressee.boat())) {
                motion.refuse(activation, context, addressee, noWay.get(addressee.boat()));
            } else {
                GeoPath path = shares.getOrDefault(addressee.boat(), new GeoPath(List.of()));
                moves.add(ExecutePathHandler.move(activation, context, addressee, path, false));
            }
        }
        motion.send(activation, context, moves);
    }

    private static List<GeoPoint> allPoints(GeoArea area) {
        List<GeoPoint> points = new ArrayList<>(area.outline());
        area.holes().forEach(points::addAll);
        return points;
    }

    private static Map<String, GeoPath> remembered(Activation activation, HandlerContext context, String key) {
        return context.query(view -> view.memory(activation.mission(), key)
                .map(value -> ProxyMaps.read(value, GeoPath.class))
                .orElseGet(LinkedHashMap::new));
    }

    private Map<String, GeoPath> divide(
            List<Addressee> boats,
            GeoArea area,
            double spacingM,
            Activation activation,
            HandlerContext context,
            Map<String, String> noWay) {
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        boats.forEach(one -> from.put(one.boat(), positions.positionOf(one.boat())));
        Coverage coverage = algorithm.cover(new CoverageProblem(
                from, area, spacingM, Restrictions.avoid(activation), Restrictions.within(activation)));
        noWay.putAll(coverage.noWay());
        Map<String, GeoPath> shares = new LinkedHashMap<>();
        coverage.shares().forEach((boat, share) -> shares.put(boat, share.path()));
        tell(activation, context, "Exploring " + coverage.words(), List.copyOf(shares.keySet()));
        return shares;
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
        int size = path.points().size();
        int visited = PathProgress.visited(context, activation.mission(), PathProgress.key(boat, path), size);
        return path.points().subList(visited, size);
    }

    private void tell(Activation activation, HandlerContext context, String text, List<String> boats) {
        messages.tell(new OperatorMessage(
                context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.DOMAIN,
                Priority.MEDIUM,
                text,
                boats,
                ""));
    }
}
