package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RenameElement;
import org.sami.spn.edit.RenameVariable;
import org.sami.spn.edit.SetMode;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.PartReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wizard.ChangeWaiting;
import org.sami.spn.wizard.RemoveWithRequirements;

/** Makes the edit that an element of a script is, as the palette, the net and the inspector of an editor make it. */
final class ScriptEdits {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;
    private final PartReader parts;

    ScriptEdits(Vocabulary vocabulary, AuthoringLibrary library) {
        this.vocabulary = vocabulary;
        this.library = library;
        this.parts = new PartReader(vocabulary);
    }

    /**
     * The edit; empty where the element changes nothing.
     *
     * @param open id of the plan that is open
     */
    Optional<Edit> edit(ScriptElement element, Project project, Optional<String> open) throws ScriptRefusedException {
        if (element instanceof ScriptElement.NewPlan e) {
            return Optional.of(new ProjectEdit.AddPlan(
                    new PlanBuilder(e.id()).named(e.name()).build()));
        }
        if (element instanceof ScriptElement.OpenPlan e) {
            List<String> ids = project.plans().stream().map(Plan::id).toList();
            if (!ids.contains(e.id())) {
                throw new ScriptRefusedException(
                        "/open", "The project has no plan \"" + e.id() + "\"" + Suggestions.meant(ids, e.id()));
            }
            return Optional.empty();
        }
        if (element instanceof ScriptElement.Give) {
            return Optional.empty();
        }
        Plan plan = open.flatMap(project::plan).orElseThrow(() -> new ScriptRefusedException("", "No plan is open"));
        PlanIds ids = new PlanIds(plan);
        if (element instanceof ScriptElement.Select e) {
            ids.all(e.what(), "/what");
            return Optional.empty();
        }
        if (element instanceof ScriptElement.Add e) {
            return Optional.of(new ScriptAdditions(vocabulary, library).edit(e, project, plan));
        }
        Optional<Edit> edit = ofNet(element, project, plan, ids);
        if (edit.isEmpty()) {
            edit = ofEvents(element, plan, ids);
        }
        return edit.isPresent() ? edit : ofPlan(element, plan, ids);
    }

    private Optional<Edit> ofNet(ScriptElement element, Project project, Plan plan, PlanIds ids)
            throws ScriptRefusedException {
        String in = plan.id();
        if (element instanceof ScriptElement.Connect e) {
            return Optional.of(connect(e, project, plan, ids));
        }
        if (element instanceof ScriptElement.Move e) {
            ids.vertex(e.what(), "/what");
            return Optional.of(new VertexEdit.MoveVertices(in, Map.of(e.what(), e.at())));
        }
        if (element instanceof ScriptElement.Start e) {
            ids.place(e.what(), "/what");
            return Optional.of(e.on() ? new VertexEdit.SetStart(in, e.what()) : new NoStart(in, e.what()));
        }
        if (element instanceof ScriptElement.End e) {
            ids.place(e.what(), "/what");
            return Optional.of(new VertexEdit.SetEnd(in, e.what(), e.on(), e.endsSharedInstance()));
        }
        if (element instanceof ScriptElement.InMode e) {
            ids.all(e.what(), "/what");
            return Optional.of(new SetMode(in, new LinkedHashSet<>(e.what()), e.mode()));
        }
        if (element instanceof ScriptElement.Waiting e) {
            ids.transition(e.what(), "/what");
            return Optional.of(new ChangeWaiting(in, e.what(), e.waitFor(), library));
        }
        if (element instanceof ScriptElement.Require e) {
            return Optional.of(require(e, plan, ids.edge(e.edge(), "/edge")));
        }
        return Optional.empty();
    }

    private Edit connect(ScriptElement.Connect e, Project project, Plan plan, PlanIds ids)
            throws ScriptRefusedException {
        ids.vertex(e.from(), "/from");
        ids.vertex(e.to(), "/to");
        Edit connect = new EdgeEdit.Connect(plan.id(), e.from(), e.to(), Mode.NOMINAL);
        if (e.id().isEmpty()) {
            return connect;
        }
        Plan drawn = Tried.plan(connect, project, plan.id(), vocabulary);
        String made = new PlanIds(drawn).edge(e.from() + ">" + e.to(), "");
        return NamedEdit.of(connect, List.of(new RenameElement(plan.id(), made, e.id().get())));
    }

    private Edit require(ScriptElement.Require e, Plan plan, String edge) throws ScriptRefusedException {
        boolean in = plan.inEdges().stream().anyMatch(i -> i.id().equals(edge));
        return in
                ? new EdgeEdit.SetInRequirements(
                        plan.id(), edge, part(parts.inRequirements(e.requirements()), "/requirements"))
                : new EdgeEdit.SetOutRequirements(
                        plan.id(), edge, part(parts.outRequirements(e.requirements()), "/requirements"));
    }

    private Optional<Edit> ofEvents(ScriptElement element, Plan plan, PlanIds ids) throws ScriptRefusedException {
        String in = plan.id();
        if (element instanceof ScriptElement.Field e) {
            FieldType field = field(ids.output(e.event(), "/event").type(), e.field());
            if (e.source().isEmpty()) {
                return Optional.of(new FieldEdit.ClearField(in, e.event(), e.field()));
            }
            FieldSource source = part(parts.source(e.source().get(), field), "/source");
            return Optional.of(new FieldEdit.SetField(in, e.event(), e.field(), source));
        }
        if (element instanceof ScriptElement.Write e) {
            field(ids.event(e.event(), "/event"), e.field());
            return Optional.of(
                    e.variable().isEmpty()
                            ? new FieldEdit.ClearWrite(in, e.event(), e.field())
                            : new FieldEdit.SetWrite(
                                    in, e.event(), e.field(), e.variable().get()));
        }
        if (element instanceof ScriptElement.SelectBy e) {
            InputEventSpec event = ids.input(e.event(), "/event");
            EventType type = type(event.type());
            return Optional.of(new EventEdit.ChangeInput(
                    in,
                    event.withFields(
                            part(parts.values(e.fields(), type.fields(), "event " + type.name()), "/fields"))));
        }
        if (element instanceof ScriptElement.Markup e) {
            ids.event(e.event(), "/event");
            if (!e.on()) {
                return Optional.of(new EventEdit.RemoveMarkup(in, e.event(), e.type()));
            }
            MarkupSpec markup = part(parts.markup(e.markup()), "");
            return Optional.of(new EventEdit.SetMarkup(in, e.event(), markup));
        }
        if (element instanceof ScriptElement.SubMission e) {
            SubMissionSpec sub = ids.subMission(e.what(), "/what");
            return Optional.of(new EventEdit.ChangeSubMission(
                    in,
                    new SubMissionSpec(
                            sub.id(),
                            sub.plan(),
                            e.shared().orElse(sub.shared()),
                            e.tasks().orElse(sub.tasks()),
                            e.variables().orElse(sub.variables()))));
        }
        return Optional.empty();
    }

    private EventType type(String name) throws ScriptRefusedException {
        return vocabulary
                .event(name)
                .orElseThrow(() -> new ScriptRefusedException("/event", "The domain has no event " + name));
    }

    private FieldType field(String event, String name) throws ScriptRefusedException {
        List<FieldType> fields = type(event).fields();
        List<String> names = fields.stream().map(FieldType::name).toList();
        return fields.stream()
                .filter(f -> f.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new ScriptRefusedException(
                        "/field",
                        "The event " + event + " has no field \"" + name + "\"; it has "
                                + (names.isEmpty() ? "none" : String.join(", ", names))
                                + Suggestions.meant(names, name)));
    }

    private Optional<Edit> ofPlan(ScriptElement element, Plan plan, PlanIds ids) throws ScriptRefusedException {
        String in = plan.id();
        if (element instanceof ScriptElement.Rename e) {
            if (e.what().startsWith("@")) {
                return Optional.of(new RenameVariable(Optional.of(in), e.what(), e.name()));
            }
            ids.vertex(e.what(), "/what");
            return Optional.of(new VertexEdit.NameVertex(in, e.what(), e.name()));
        }
        if (element instanceof ScriptElement.Variable e) {
            VariableSpec variable = part(parts.variable(e.declaration()), "");
            boolean declared = plan.variables().stream().anyMatch(v -> v.name().equals(variable.name()));
            return Optional.of(
                    declared
                            ? new VariableEdit.ChangeVariable(Optional.of(in), variable)
                            : new VariableEdit.AddVariable(Optional.of(in), variable));
        }
        if (element instanceof ScriptElement.Task e) {
            TaskSpec task = part(parts.task(e.task()), "");
            boolean there = plan.tasks().stream().anyMatch(t -> t.name().equals(task.name()));
            return Optional.of(there ? new TaskEdit.ChangeTask(in, task) : new TaskEdit.AddTask(in, task));
        }
        return Optional.of(delete((ScriptElement.Delete) element, plan, ids));
    }

    private Edit delete(ScriptElement.Delete e, Plan plan, PlanIds ids) throws ScriptRefusedException {
        Set<String> variables =
                plan.variables().stream().map(VariableSpec::name).collect(Collectors.toSet());
        Set<String> tasks = plan.tasks().stream().map(TaskSpec::name).collect(Collectors.toSet());
        Set<String> elements = plan.elementIds();
        List<Edit> edits = new ArrayList<>();
        Set<String> removed = new LinkedHashSet<>();
        for (String what : e.what()) {
            if (variables.contains(what)) {
                edits.add(new VariableEdit.RemoveVariable(Optional.of(plan.id()), what));
            } else if (tasks.contains(what) && !elements.contains(what)) {
                edits.add(new TaskEdit.RemoveTask(plan.id(), what));
            } else {
                removed.add(what.contains(">") ? ids.edge(what, "/what") : what);
            }
        }
        ids.all(removed, "/what");
        if (!removed.isEmpty()) {
            edits.add(0, new RemoveWithRequirements(plan.id(), removed, library));
        }
        return edits.size() == 1
                ? edits.get(0)
                : new EditSequence("Delete " + e.what().size() + " elements", edits);
    }

    private static <T> T part(Reading<T> reading, String pointer) throws ScriptRefusedException {
        if (reading.result().isEmpty()) {
            Finding first = reading.findings().get(0);
            throw new ScriptRefusedException(
                    pointer + first.pointer(),
                    reading.findings().stream().map(Finding::message).collect(Collectors.joining("; ")));
        }
        return reading.result().get();
    }
}
