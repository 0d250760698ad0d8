package org.sami.crw.operator.alarm;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;

/**
 * Which boats of a fleet cannot do what a plan and its sub-missions ask of boats. Values that are known only during the mission are left out.
 *
 * @param missing a sentence without its full stop for each boat and each thing that it cannot do
 */
public record MissingCapabilities(List<String> missing) {
    public MissingCapabilities {
        missing = List.copyOf(missing);
    }

    /**
     * A robot, as far as it has said what it is.
     *
     * @param isKnown whether it has reported whether it flies
     */
    public record Robot(String name, boolean isKnown, boolean flies, BoatCapabilities can) {
        private static Robot of(BoatSnapshot boat) {
            return new Robot(
                    boat.boat(),
                    boat.pose().isPresent(),
                    boat.flies(),
                    boat.settings().map(BoatTuning::capabilities).orElse(BoatCapabilities.UNKNOWN));
        }
    }

    /**
     * Goes through all output events for all boats. In a fleet of several kinds a plan chooses for each event who can do it: there only what no robot
     * can do is missing.
     *
     * @param project with the plans of its sub-missions
     * @param robots what the fleet is
     */
    public static MissingCapabilities of(Plan plan, Project project, Collection<BoatSnapshot> boats, RobotKind robots) {
        return ofRobots(plan, project, boats.stream().map(Robot::of).toList(), robots);
    }

    /** The same for robots of which only this is known. */
    public static MissingCapabilities ofRobots(Plan plan, Project project, Collection<Robot> fleet, RobotKind robots) {
        Set<String> missing = new LinkedHashSet<>();
        withSubMissions(plan, project).stream()
                .flatMap(one -> one.places().stream())
                .flatMap(place -> place.outputs().stream())
                .forEach(event -> {
                    List<String> reasons = fleet.stream()
                            .flatMap(robot -> missing(robot, event, robots).stream())
                            .toList();
                    if (robots != RobotKind.ROBOT) {
                        missing.addAll(reasons);
                    } else if (!fleet.isEmpty() && reasons.size() == fleet.size()) {
                        missing.add("no robot can do " + event.type() + ": " + String.join(", ", reasons));
                    }
                });
        return new MissingCapabilities(List.copyOf(missing));
    }

    private static Optional<String> missing(Robot robot, OutputEventSpec event, RobotKind robots) {
        if (robots == RobotKind.ROBOT && robot.isKnown()) {
            Optional<RobotKind> does = HandlerModules.doing(event.type());
            if (does.isPresent() && does.get() != robots.of(robot.flies())) {
                return Optional.of(robot.name() + (robot.flies() ? " flies" : " does not fly"));
            }
        }
        return HandlerModules.missing(robot.name(), robot.can(), event.type(), fixed(event));
    }

    private static Collection<Plan> withSubMissions(Plan plan, Project project) {
        Map<String, Plan> found = new LinkedHashMap<>();
        Deque<Plan> open = new ArrayDeque<>(List.of(plan));
        while (!open.isEmpty()) {
            Plan next = open.remove();
            if (found.putIfAbsent(next.id(), next) == null) {
                next.places().stream()
                        .flatMap(place -> place.subMissions().stream())
                        .forEach(sub -> project.plan(sub.plan()).ifPresent(open::add));
            }
        }
        return found.values();
    }

    private static Map<String, Value> fixed(OutputEventSpec event) {
        return event.fields().entrySet().stream()
                .filter(field -> field.getValue() instanceof FieldSource.Fixed)
                .collect(Collectors.toMap(Map.Entry::getKey, field -> ((FieldSource.Fixed) field.getValue()).value()));
    }
}
