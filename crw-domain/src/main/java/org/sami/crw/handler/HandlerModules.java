package org.sami.crw.handler;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.motion.BoatMoves;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** The {@link HandlerModule}s that are on the class path. */
public final class HandlerModules {
    private static final String BOATS = "crw";
    private static final List<HandlerModule> ALL = ServiceLoader.load(HandlerModule.class).stream()
            .map(ServiceLoader.Provider::get)
            .toList();

    private HandlerModules() {}

    /** Those of a vocabulary's domain and of the domains that it combines. */
    static List<HandlerModule> of(Vocabulary vocabulary) {
        List<String> domains = domains(vocabulary).toList();
        return ALL.stream().filter(module -> domains.contains(module.domain())).toList();
    }

    private static Stream<String> domains(Vocabulary vocabulary) {
        return Stream.concat(Stream.of(vocabulary.domain()), vocabulary.combines().stream());
    }

    /** What plans with these words command; boats where no module says otherwise, robots where the domains that are combined have several kinds. */
    public static RobotKind robotsOf(Vocabulary vocabulary) {
        if (vocabulary.combines().isEmpty()) {
            return robotsOf(vocabulary.domain());
        }
        Set<RobotKind> kinds =
                vocabulary.combines().stream().map(HandlerModules::robotsOf).collect(Collectors.toSet());
        return kinds.size() == 1 ? kinds.iterator().next() : RobotKind.ROBOT;
    }

    private static RobotKind robotsOf(String domain) {
        return ALL.stream()
                .filter(module -> module.domain().equals(domain))
                .map(HandlerModule::robots)
                .findFirst()
                .orElse(RobotKind.BOAT);
    }

    /** Which kind of robots an output event moves; empty for one that any robot can do, as far as its kind goes. */
    public static Optional<RobotKind> moving(String event) {
        return BoatMoves.TYPES.contains(event)
                ? Optional.of(RobotKind.BOAT)
                : ALL.stream()
                        .filter(module -> module.moves().contains(event))
                        .map(HandlerModule::robots)
                        .findFirst();
    }

    /** Which kind of robots does what an output event asks: that which it moves, or of which it demands more; empty for one that any robot can do. */
    public static Optional<RobotKind> doing(String event) {
        return moving(event)
                .or(() -> ALL.stream()
                        .filter(module -> module.demands().containsKey(event))
                        .map(HandlerModule::robots)
                        .findFirst());
    }

    /**
     * Why a robot cannot do what an output event of any of the domains asks of it, as a sentence without its full stop; empty where it can, or does not say.
     *
     * @param event the event's type
     * @param values of its fields, as far as they are known
     */
    public static Optional<String> missing(
            String robot, BoatCapabilities robotCan, String event, Map<String, Value> values) {
        return BoatDemands.missing(robot, robotCan, event, values)
                .or(() -> ALL.stream()
                        .flatMap(module -> Optional.ofNullable(module.demands().get(event)).stream())
                        .findFirst()
                        .flatMap(demand -> BoatDemands.missing(robot, robotCan, demand)));
    }

    /** Whether output events of a vocabulary have handlers on this class path: those of the boats always. */
    public static boolean isHandled(Vocabulary vocabulary) {
        return vocabulary.combines().isEmpty()
                ? isHandled(vocabulary.domain())
                : vocabulary.combines().stream().allMatch(HandlerModules::isHandled);
    }

    private static boolean isHandled(String domain) {
        return domain.equals(BOATS)
                || ALL.stream().anyMatch(module -> module.domain().equals(domain));
    }
}
