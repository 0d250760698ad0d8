package org.sami.spn.statespace;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.stepping.MomentKey;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.vocabulary.Reserved;

/**
 * Which states a search takes for one: those that differ only in which robot is which, which of the made tasks is which, where points lie and
 * how long timers have to run. Robots are like one another where no plan of the project names one and none filters them.
 */
final class AlikeRobots {
    private final boolean areAlike;

    AlikeRobots(Project project, List<String> robots) {
        areAlike = project.plans().stream().noneMatch(plan -> filters(plan) || names(project, plan, robots));
    }

    private static boolean filters(Plan plan) {
        return plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .flatMap(output -> output.markups().stream())
                .anyMatch(markup -> markup.type().equals(Reserved.FILTER));
    }

    private static boolean names(Project project, Plan plan, List<String> robots) {
        String words = Stream.of(plan.places(), plan.transitions(), plan.tasks(), plan.variables(), project.globals())
                .map(Object::toString)
                .reduce("", String::concat);
        return robots.stream()
                .anyMatch(robot -> Pattern.compile("(?<![\\w-])" + Pattern.quote(robot) + "(?![\\w-])")
                        .matcher(words)
                        .find());
    }

    MomentKey key(Stepper at) {
        return at.keyAlike(areAlike ? new HashSet<>(at.view().proxies()) : Set.of());
    }
}
