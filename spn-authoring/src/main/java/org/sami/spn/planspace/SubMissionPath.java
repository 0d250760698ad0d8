package org.sami.spn.planspace;

import java.util.Optional;
import java.util.function.BiFunction;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** The ways to what sub-missions have, as nets that follow them say it: {@code swap/go} is {@code go} of the plan that runs on {@code swap}. */
final class SubMissionPath {
    private SubMissionPath() {}

    /**
     * A path in the names that authors gave.
     *
     * @param name of the last part, in the plan that has it
     */
    static String words(Project project, Plan root, String path, BiFunction<Plan, String, Optional<String>> name) {
        StringBuilder words = new StringBuilder();
        Optional<Plan> at = Optional.of(root);
        String rest = path;
        for (int slash = rest.indexOf('/'); slash >= 0; slash = rest.indexOf('/')) {
            String id = rest.substring(0, slash);
            Optional<Place> place = at.flatMap(plan -> plan.place(id));
            words.append(place.map(Place::name)
                            .filter(given -> !given.isBlank())
                            .orElse(id))
                    .append(" / ");
            at = place.flatMap(found -> found.subMissions().stream().findFirst())
                    .flatMap(sub -> project.plan(sub.plan()));
            rest = rest.substring(slash + 1);
        }
        String last = rest;
        return words
                + at.flatMap(plan -> name.apply(plan, last))
                        .filter(given -> !given.isBlank())
                        .orElse(last);
    }
}
