package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.vocabulary.Vocabulary;

/** A project while its plans are checked: which plan runs which, and one context a plan, made when it is first needed. */
final class ProjectContext {
    private final Project project;
    private final Vocabulary vocabulary;
    private final Map<String, Plan> plans = new HashMap<>();
    private final IdentityHashMap<Plan, Integer> indices = new IdentityHashMap<>();
    private final IdentityHashMap<Plan, PlanContext> contexts = new IdentityHashMap<>();
    private final Map<String, List<Plan>> parents = new HashMap<>();
    private final IdentityHashMap<Plan, PlanContext> earlier;

    ProjectContext(Project project, Vocabulary vocabulary) {
        this(project, vocabulary, new IdentityHashMap<>());
    }

    private ProjectContext(Project project, Vocabulary vocabulary, IdentityHashMap<Plan, PlanContext> earlier) {
        this.project = project;
        this.vocabulary = vocabulary;
        this.earlier = earlier;
        for (int i = 0; i < project.plans().size(); i++) {
            Plan plan = project.plans().get(i);
            plans.putIfAbsent(plan.id(), plan);
            indices.putIfAbsent(plan, i);
            for (String child : children(plan)) {
                parents.computeIfAbsent(child, id -> new ArrayList<>()).add(plan);
            }
        }
    }

    /** The context of a later version of the project; what is known of plans that are the same objects at the same index is kept. */
    ProjectContext after(Project later) {
        IdentityHashMap<Plan, PlanContext> known = new IdentityHashMap<>(earlier);
        known.putAll(contexts);
        known.keySet().retainAll(identities(later));
        return new ProjectContext(later, vocabulary, known);
    }

    private static Set<Plan> identities(Project project) {
        Set<Plan> identities = Collections.newSetFromMap(new IdentityHashMap<>());
        identities.addAll(project.plans());
        return identities;
    }

    Project project() {
        return project;
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    Optional<Plan> plan(String id) {
        return Optional.ofNullable(plans.get(id));
    }

    /** Plans that run a plan as a sub-mission. */
    List<Plan> parents(String plan) {
        return parents.getOrDefault(plan, List.of());
    }

    /** The ids of the plans that a plan runs as sub-missions. */
    static Set<String> children(Plan plan) {
        Set<String> children = new LinkedHashSet<>();
        for (Place place : plan.places()) {
            place.subMissions().stream().map(SubMissionSpec::plan).forEach(children::add);
        }
        return children;
    }

    /** The context of a plan of the project, found by identity: comparing whole plans would take long. */
    PlanContext of(Plan plan) {
        PlanContext context = contexts.get(plan);
        if (context == null) {
            Integer index = indices.get(plan);
            if (index == null) {
                throw new IllegalArgumentException("The project has no plan " + plan.id());
            }
            String pointer = "/plans/" + index;
            PlanContext known = earlier.get(plan);
            context = known != null && known.pointer().equals(pointer)
                    ? known.in(this)
                    : new PlanContext(this, plan, pointer);
            contexts.put(plan, context);
        }
        return context;
    }
}
