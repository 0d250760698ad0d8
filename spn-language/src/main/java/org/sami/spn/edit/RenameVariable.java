package org.sami.spn.edit;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;

/**
 * Renames a variable with all references: in the plan that declares it, in the plans that this runs and that see it, in what parents
 * give to sub-missions, and in test cases. A plan that others run as well, to which the name means something else, keeps it and is given
 * the variable under the old name.
 *
 * @param plan the plan that declares or writes it; empty for a variable of the project
 */
public record RenameVariable(Optional<String> plan, String from, String to) implements Edit {
    public RenameVariable {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }

    @Override
    public String label() {
        return "Rename " + from + " to " + to;
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        VariableReach reach = new VariableReach(project, from);
        Set<String> reached = new LinkedHashSet<>(reached(project, reach));
        Set<String> kept = kept(project, reach, reached);
        reached.removeAll(kept);
        for (Plan p : project.plans()) {
            if (reached.contains(p.id()) && reach.uses(p, from) && reach.uses(p, to)) {
                throw new EditRefusedException("The plan \"" + p.id() + "\" speaks of " + to + " already: as " + from
                        + " is used there too, both would be one variable");
            }
        }
        Project renamed = project.withPlans(project.plans().stream()
                .map(p -> PlanNames.replaced(p, use -> renamed(use, reached)))
                .map(p -> reached.contains(p.id()) ? given(p, kept, context) : p)
                .toList());
        return plan.isPresent()
                ? renamed
                : renamed.withGlobals(
                        Parts.replaced(renamed.globals(), v -> v.name().equals(from), v -> v.withName(to)));
    }

    private Set<String> reached(Project project, VariableReach reach) throws EditRefusedException {
        Optional<String> bad = VariableNameForm.problem(to);
        if (bad.isPresent()) {
            throw new EditRefusedException(bad.get());
        }
        if (plan.isEmpty()) {
            if (project.globals().stream().noneMatch(v -> v.name().equals(from))) {
                throw new EditRefusedException("The project declares no variable " + from);
            }
            return reach.ofProject();
        }
        Plan owner = Parts.plan(project, plan.get());
        Optional<String> above = reach.declares(owner) ? Optional.empty() : reach.declaredAbove(owner);
        if (above.isPresent()) {
            throw new EditRefusedException("In the plan \"" + owner.id() + "\" " + from + " is the variable of "
                    + above.get() + ": rename it there");
        }
        if (!reach.uses(owner, from)) {
            throw new EditRefusedException("The plan \"" + owner.id() + "\" has no variable " + from);
        }
        return reach.below(owner);
    }

    /** The plans that keep the old name, since others run them; with those that they run. */
    private Set<String> kept(Project project, VariableReach reach, Set<String> reached) {
        Set<String> kept = new LinkedHashSet<>();
        if (plan.isPresent()) {
            Set<String> shared = reach.shared(reached, plan.get());
            for (String id : shared) {
                project.plan(id).ifPresent(p -> kept.addAll(reach.below(p)));
            }
            kept.remove(plan.get());
        }
        return kept;
    }

    private String renamed(NameUse use, Set<String> reached) {
        boolean meant = use.kind() == NameUse.Kind.VARIABLE && use.name().equals(from) && reached.contains(use.of());
        return meant ? to : use.name();
    }

    /** A plan that gives the variable under its old name to the plans that keep it. */
    private Plan given(Plan p, Set<String> kept, EditContext context) {
        if (VariableReach.subMissions(p).noneMatch(s -> gives(s, kept))) {
            return p;
        }
        context.tell("The plan \"" + p.id() + "\" gives " + to + " as " + from
                + " to sub-missions that other plans run as well");
        return p.withPlaces(p.places().stream()
                .map(place -> place.withSubMissions(
                        Parts.replaced(place.subMissions(), s -> gives(s, kept), this::givingOldName)))
                .toList());
    }

    private boolean gives(SubMissionSpec s, Set<String> kept) {
        return kept.contains(s.plan()) && !s.variables().containsKey(from);
    }

    private SubMissionSpec givingOldName(SubMissionSpec s) {
        Map<String, String> variables = new LinkedHashMap<>(s.variables());
        variables.put(from, to);
        return s.withVariables(variables);
    }
}
