package org.sami.spn.edit;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** Gives a vertex, edge, event or sub-mission another id, with all references in the plan: edges, orders, layout, test cases. */
public record RenameElement(String plan, String from, String to) implements Edit {
    public RenameElement {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }

    @Override
    public String label() {
        return "Rename \"" + from + "\" to \"" + to + "\"";
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        Plan before = Parts.plan(project, plan);
        if (!Parts.ids(before).contains(from)) {
            throw new EditRefusedException("The plan \"" + plan + "\" has no element " + from);
        }
        if (Parts.ids(before).contains(to)) {
            throw new EditRefusedException("In the plan \"" + plan + "\" the id " + to + " is used already");
        }
        Plan after = PlanNames.replaced(before, use -> use.is(NameUse.Kind.ELEMENT, from, before) ? to : use.name());
        Optional<ImportOrigin> origin = project.importedFrom()
                .map(o -> new ImportOrigin(
                        o.file(), Parts.replaced(o.remarks(), r -> r.plan().equals(plan), this::renamed)));
        return project.withPlans(Parts.replaced(project.plans(), p -> p.id().equals(plan), p -> after))
                .withImportedFrom(origin);
    }

    private ImportOrigin.Remark renamed(ImportOrigin.Remark remark) {
        return new ImportOrigin.Remark(
                remark.code(),
                remark.plan(),
                Parts.replaced(remark.elements(), from::equals, e -> to),
                remark.message());
    }
}
