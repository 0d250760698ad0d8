package org.sami.spn.edit;

import java.util.Objects;
import org.sami.spn.model.Project;

/** Renames an interrupt in all plans, because a button reaches sub-missions: where it is offered, taken, or pressed in a test case. */
public record RenameInterrupt(String from, String to) implements Edit {
    public RenameInterrupt {
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }

    @Override
    public String label() {
        return "Rename interrupt \"" + from + "\" to \"" + to + "\"";
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        Usages usages = new Usages(project);
        if (usages.ofInterrupt(from).isEmpty()) {
            throw new EditRefusedException("No plan has an interrupt \"" + from + "\"");
        }
        if (to.isBlank()) {
            throw new EditRefusedException("An interrupt has a name that is not empty");
        }
        if (!from.equals(to) && !usages.ofInterrupt(to).isEmpty()) {
            Usage other = usages.ofInterrupt(to).get(0);
            throw new EditRefusedException("The plan \"" + other.plan() + "\" has an interrupt \"" + to
                    + "\" already: both would be one button");
        }
        return project.withPlans(project.plans().stream()
                .map(p -> PlanNames.replaced(
                        p,
                        use -> use.kind() == NameUse.Kind.INTERRUPT
                                        && use.name().equals(from)
                                ? to
                                : use.name()))
                .toList());
    }
}
