package org.sami.dreamm.tree;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.KeyStroke;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.tree.TreeItem.Kind;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.edit.Usage;
import org.sami.spn.edit.Usages;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.command.Command;

/** What can be done with lines of the mission tree, and with names everywhere. On the event thread. */
final class TreeCommands {
    private final DreammContext context;
    private final MissionTreeView tree;
    private final NameBar names;
    private final SearchView search;

    TreeCommands(DreammContext context, MissionTreeView tree, NameBar names, SearchView search) {
        this.context = Objects.requireNonNull(context, "context");
        this.tree = tree;
        this.names = names;
        this.search = search;
    }

    void register() {
        add(new Command("plan-new", "New plan…", this::newPlan)
                .withKey("ctrl shift N")
                .withIcon("plus"));
        add(new Command("folder-new", "New folder in the mission tree…", this::newFolder).withKey("alt shift N"));
        add(new Command("rename", "Rename everywhere…", this::rename)
                .withKey("shift F6")
                .withIcon("edit"));
        add(new Command("plan-clone", "Clone the plan…", this::clonePlan)
                .withKey("ctrl shift D")
                .unless(() -> unless(plan().isPresent(), "no plan is open")));
        add(new Command("tree-delete", "Delete from the mission tree", this::delete)
                .withFocusKeys(CanvasKey.strokes("DELETE"))
                .unless(() -> unless(
                        selected()
                                .filter(i -> i.kind() != Kind.PROJECT && i.kind() != Kind.VARIABLES)
                                .isPresent(),
                        "no line of the mission tree is selected that can be deleted")));
        add(new Command("plan-up", "Move up in the mission tree", () -> move(-1))
                .withKey("alt UP")
                .withIcon("up")
                .unless(() -> unless(movable().isPresent(), "no plan or folder is selected in the mission tree")));
        add(new Command("plan-down", "Move down in the mission tree", () -> move(1))
                .withKey("alt DOWN")
                .withIcon("down")
                .unless(() -> unless(movable().isPresent(), "no plan or folder is selected in the mission tree")));
        add(new Command("tree-open", "Open the plan that a sub-mission runs", this::open)
                .withFocusKeys(CanvasKey.strokes("ENTER"))
                .unless(() -> unless(
                        selected().filter(i -> i.kind() == Kind.SUB_MISSION).isPresent(),
                        "no sub-mission is selected in the mission tree")));
        add(new Command("usages-find", "Find usages", this::findUsages).withKey("alt F7"));
        add(new Command("search-everything", "Search everything", search::focusSearch)
                .withKey("ctrl shift F")
                .withIcon("search"));
        onTree("DELETE", "tree-delete");
        onTree("F2", "rename");
        onTree("ENTER", "tree-open");
    }

    /** A key that has its meaning on the tree alone. */
    private void onTree(String key, String id) {
        tree.getInputMap().put(KeyStroke.getKeyStroke(key), id);
        tree.getActionMap().put(id, context.commands().get(id));
    }

    /** Goes to the plan that a sub-mission's line runs. */
    private void open() {
        selected()
                .filter(item -> item.kind() == Kind.SUB_MISSION)
                .flatMap(this::runs)
                .ifPresent(context.editor()::open);
    }

    private void add(Command command) {
        context.commands().add(command);
    }

    private static Optional<String> unless(boolean possible, String reason) {
        return possible ? Optional.empty() : Optional.of(reason);
    }

    private Optional<TreeItem> selected() {
        return tree.selected();
    }

    private Optional<TreeItem> movable() {
        return selected().filter(TreeDrop::moves);
    }

    private Optional<Plan> plan() {
        return context.editor().plan();
    }

    private Project project() {
        return context.document().project();
    }

    private boolean take(Edit edit) {
        return context.apply(edit) instanceof EditResult.Done;
    }

    private void newPlan() {
        askPlan(
                "New plan",
                "Make",
                "",
                "",
                given -> new ProjectEdit.AddPlan(
                        new PlanBuilder(given.get(1)).named(given.get(0)).build()));
    }

    private void clonePlan() {
        Plan plan = plan().orElseThrow();
        askPlan(
                "Clone " + PlanTree.name(plan),
                "Clone",
                plan.name().isEmpty() ? "" : plan.name() + " (copy)",
                plan.id() + "-copy",
                given -> new ProjectEdit.ClonePlan(plan.id(), given.get(1), given.get(0)));
    }

    private void askPlan(String title, String button, String name, String id, Function<List<String>, Edit> edit) {
        Map<String, String> fields = new LinkedHashMap<>();
        fields.put("Name", name);
        fields.put("Id", id);
        names.ask(title, button, fields, given -> {
            List<String> whole = given.get(1).isEmpty() ? List.of(given.get(0), idOf(given.get(0))) : given;
            if (whole.get(1).isEmpty()) {
                context.notices().refused("a plan needs a name, or an id");
                return false;
            }
            if (project().plan(whole.get(1)).isPresent()) {
                context.notices().refused("the project has a plan \"" + whole.get(1) + "\" already");
                return false;
            }
            boolean made = take(edit.apply(whole));
            if (made) {
                context.editor().open(whole.get(1));
            }
            return made;
        });
    }

    /** An id of a name: small letters and digits, with hyphens between words. */
    static String idOf(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}]+", "-").replaceAll("^-|-$", "");
    }

    private void newFolder() {
        names.ask("New folder", "Make", Map.of("Name", ""), given -> take(PlanTree.addFolder(project(), given.get(0))));
    }

    private void rename() {
        Optional<Renaming> renaming = tree.focusedItem().flatMap(this::ofLine).or(this::ofSelection);
        if (renaming.isEmpty()) {
            context.notices().refused("select a plan, a variable, a place or a transition to rename it");
            return;
        }
        names.ask(
                renaming.get().title(),
                "Rename",
                renaming.get().fields(),
                given -> given.equals(List.copyOf(renaming.get().fields().values()))
                        || take(renaming.get().edit().apply(given)));
    }

    private Optional<Renaming> ofLine(TreeItem item) {
        return switch (item.kind()) {
            case PROJECT -> Optional.of(Renaming.project(project()));
            case FOLDER -> Optional.of(Renaming.folder(project(), item));
            case PLAN -> project().plan(item.plan()).map(plan -> Renaming.plan(project(), plan));
            case VARIABLE -> Optional.of(Renaming.variable(project(), scope(item), item.id()));
            case SUB_MISSION ->
                project()
                        .plan(item.plan())
                        .flatMap(parent -> runs(item)
                                .flatMap(project()::plan)
                                .map(plan -> Renaming.subMission(project(), parent, item.id(), plan)));
            case TASK -> Optional.of(Renaming.task(project(), item.plan(), item.id()));
            case VARIABLES -> Optional.empty();
        };
    }

    private Optional<Renaming> ofSelection() {
        Optional<Plan> plan = plan();
        Optional<String> element = context.editor().selection().stream().findFirst();
        if (plan.isEmpty() || element.isEmpty()) {
            return plan.map(p -> Renaming.plan(project(), p));
        }
        return Renaming.vertex(project(), plan.get(), ProjectSearch.shown(plan.get(), element.get()));
    }

    private static Optional<String> scope(TreeItem variable) {
        return Optional.of(variable.plan()).filter(plan -> !plan.isEmpty());
    }

    /** The plan that a sub-mission's line runs. */
    private Optional<String> runs(TreeItem item) {
        return project().plan(item.plan()).stream()
                .flatMap(plan -> plan.places().stream())
                .flatMap(place -> place.subMissions().stream())
                .filter(sub -> sub.id().equals(item.id()))
                .map(sub -> sub.plan())
                .findFirst();
    }

    private void delete() {
        TreeItem item = selected().orElseThrow();
        switch (item.kind()) {
            case FOLDER -> context.apply(PlanTree.removeFolder(project(), item));
            case PLAN -> context.apply(new ProjectEdit.RemovePlan(item.plan()));
            case VARIABLE -> context.apply(new VariableEdit.RemoveVariable(scope(item), item.id()));
            case TASK -> context.apply(new TaskEdit.RemoveTask(item.plan(), item.id()));
            case SUB_MISSION -> context.apply(new RemoveElements(item.plan(), java.util.Set.of(item.id())));
            case PROJECT, VARIABLES -> context.notices().refused(item.title() + " cannot be deleted");
        }
    }

    private void move(int by) {
        TreeItem item = movable().orElseThrow();
        List<Integer> parent = item.path().subList(0, item.path().size() - 1);
        int index = item.path().get(item.path().size() - 1) + by;
        if (index >= 0) {
            context.apply(PlanTree.move(project(), item, parent, index));
        }
    }

    private void findUsages() {
        Usages usages = new Usages(project());
        Optional<TreeItem> line = tree.focusedItem();
        if (line.isPresent()) {
            TreeItem item = line.get();
            switch (item.kind()) {
                case PLAN -> showUsages(item.title(), usages.ofPlan(item.plan()));
                case VARIABLE -> showUsages(item.title(), usages.ofVariable(scope(item), item.id()));
                case TASK -> showUsages(item.title(), usages.ofTask(item.plan(), item.id()));
                case SUB_MISSION ->
                    showUsages(item.title(), runs(item).map(usages::ofPlan).orElse(List.of()));
                case PROJECT, FOLDER, VARIABLES -> context.notices().refused(item.title() + " is used nowhere");
            }
            return;
        }
        Optional<String> element = context.editor().selection().stream().findFirst();
        if (plan().isPresent() && element.isPresent()) {
            Plan plan = plan().get();
            Optional<String> type = eventType(plan, element.get());
            showUsages(
                    type.orElse(element.get()),
                    type.map(usages::ofEventType).orElseGet(() -> usages.ofElement(plan.id(), element.get())));
        } else {
            plan().ifPresent(plan -> showUsages(PlanTree.name(plan), usages.ofPlan(plan.id())));
        }
    }

    private static Optional<String> eventType(Plan plan, String element) {
        Optional<String> output = plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .filter(event -> event.id().equals(element))
                .map(OutputEventSpec::type)
                .findFirst();
        return output.or(() -> plan.transitions().stream()
                .flatMap(transition -> transition.inputs().stream())
                .filter(event -> event.id().equals(element))
                .map(InputEventSpec::type)
                .findFirst());
    }

    private void showUsages(String what, List<Usage> usages) {
        List<Hit> found = new ProjectSearch(project(), context.vocabulary()).of(usages);
        search.showHits(found.isEmpty() ? what + " is used nowhere" : what + ": " + found.size() + " usages", found);
        search.focusHits();
    }
}
