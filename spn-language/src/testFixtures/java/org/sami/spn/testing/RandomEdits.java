package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.ExtractSubMission;
import org.sami.spn.edit.Fragment;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.edit.NoteEdit;
import org.sami.spn.edit.Paste;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.RenameElement;
import org.sami.spn.edit.RenameInterrupt;
import org.sami.spn.edit.RenameVariable;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.edit.SetMode;
import org.sami.spn.edit.SetReads;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Note;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes random edits, of every kind, of whatever project it is shown; some of them speak of what is not there or taken already. */
public final class RandomEdits {
    private static final String[] IN = {
        "generic >= 1", "proxy = 0", "any < 2", "task == 2", "relevant all", "relevant >= 1", "always"
    };
    private static final String[] OUT = {
        "take all proxy", "take 1 generic", "add 2 generic", "consume all any", "take all relevant", "always"
    };
    private static final ValueType[] TYPES = {
        ValueType.Simple.REAL,
        ValueType.Simple.TEXT,
        ValueType.Simple.POINT,
        new ValueType.ListOf(ValueType.Simple.POINT)
    };

    private final Random random;
    private final Vocabulary vocabulary;
    private Project project;
    private Plan plan;
    private int names;

    /** Edits of projects of one domain; equal seeds give equal edits of equal projects. */
    public RandomEdits(long seed, Vocabulary vocabulary) {
        this.random = new Random(seed);
        this.vocabulary = vocabulary;
    }

    /** An edit of a project as it is now. */
    public Edit next(Project now) {
        project = now;
        plan = project.plans().isEmpty() ? new NetBuilder("none").build() : of(project.plans());
        List<Supplier<Edit>> kinds = new ArrayList<>();
        addVertexEdits(kinds);
        addEventEdits(kinds);
        addNameEdits(kinds);
        addProjectEdits(kinds);
        return of(kinds).get();
    }

    private void addVertexEdits(List<Supplier<Edit>> kinds) {
        kinds.add(() -> VertexEdit.AddPlace.blank(plan.id(), fresh("place"), mode(), point()));
        kinds.add(() -> VertexEdit.AddTransition.blank(plan.id(), fresh("transition"), mode(), point()));
        kinds.add(() -> new VertexEdit.AddPlace(
                plan.id(),
                of(
                        plan.places(),
                        new NetBuilder("x").places("x").build().places().get(0)),
                Optional.empty()));
        kinds.add(() -> new VertexEdit.MoveVertices(plan.id(), Map.of(vertex(), point())));
        kinds.add(() -> new VertexEdit.NameVertex(plan.id(), vertex(), fresh("Name ")));
        kinds.add(() -> new VertexEdit.SetStart(plan.id(), place()));
        kinds.add(() -> new VertexEdit.SetEnd(plan.id(), place(), random.nextBoolean(), random.nextBoolean()));
        kinds.add(() -> new VertexEdit.SetWaitFor(plan.id(), transition(), of(List.of(WaitFor.values()))));
        kinds.add(() -> new VertexEdit.OrderTransitions(plan.id(), place(), List.of(transition())));
        kinds.add(() -> new SetMode(plan.id(), Set.of(element()), mode()));
        kinds.add(() -> new RemoveElements(plan.id(), Set.of(element())));
        kinds.add(() -> new SetDisabled(plan.id(), Set.of(vertex()), random.nextBoolean()));
        kinds.add(() -> new FrameEdit.AddFrame(plan.id(), frame()));
        kinds.add(() -> new FrameEdit.SetFrame(plan.id(), random.nextInt(3), frame()));
        kinds.add(() -> new FrameEdit.MoveFrames(plan.id(), Map.of(random.nextInt(3), point())));
        kinds.add(() -> new FrameEdit.RemoveFrames(plan.id(), Set.of(random.nextInt(3))));
        kinds.add(() -> new EdgeEdit.Connect(plan.id(), vertex(), vertex(), mode()));
        kinds.add(() -> new EdgeEdit.ConnectIn(
                plan.id(), place(), transition(), mode(), List.of(Requirements.in(IN[random.nextInt(IN.length)]))));
        kinds.add(() -> new EdgeEdit.ConnectOut(
                plan.id(), transition(), place(), mode(), List.of(Requirements.out(OUT[random.nextInt(OUT.length)]))));
        kinds.add(() -> new EdgeEdit.Disconnect(plan.id(), vertex(), vertex()));
        kinds.add(() -> new EdgeEdit.SetLocked(plan.id(), Set.of(element()), random.nextBoolean()));
        kinds.add(() -> new EdgeEdit.SetInRequirements(
                plan.id(), element(), List.of(Requirements.in(IN[random.nextInt(IN.length)]))));
        kinds.add(() -> new EdgeEdit.SetOutRequirements(
                plan.id(), element(), List.of(Requirements.out(OUT[random.nextInt(OUT.length)]))));
        kinds.add(() -> new Paste(plan.id(), Fragment.copyOf(of(project.plans(), plan), some()), 20, 20));
    }

    private Set<String> some() {
        Set<String> ids = new LinkedHashSet<>();
        Plan from = of(project.plans(), plan);
        from.places().stream().filter(p -> random.nextInt(3) == 0).forEach(p -> ids.add(p.id()));
        from.transitions().stream().filter(t -> random.nextInt(3) == 0).forEach(t -> ids.add(t.id()));
        return ids;
    }

    private void addEventEdits(List<Supplier<Edit>> kinds) {
        kinds.add(() -> new EventEdit.AddOutput(plan.id(), place(), output(fresh("out"))));
        kinds.add(() -> new EventEdit.AddInput(plan.id(), transition(), input(fresh("in"))));
        kinds.add(() -> new EventEdit.ChangeOutput(plan.id(), output(outputId())));
        kinds.add(() -> new EventEdit.ChangeInput(plan.id(), input(element())));
        kinds.add(() -> new EventEdit.MoveEvent(plan.id(), element(), random.nextInt(3)));
        kinds.add(() -> new EventEdit.RemoveMarkup(plan.id(), element(), Reserved.PRIORITY));
        kinds.add(() -> new EventEdit.AddSubMission(
                plan.id(),
                place(),
                new SubMissionSpec(
                        fresh("sub"),
                        of(project.plans(), plan).id(),
                        random.nextBoolean(),
                        Map.of(),
                        random.nextBoolean() ? Map.of() : Map.of(variable(), variable()))));
        kinds.add(() -> new EditSequence(
                "Add a place with an event",
                List.of(
                        VertexEdit.AddPlace.blank(plan.id(), "with-event", mode(), point()),
                        new EventEdit.AddOutput(plan.id(), "with-event", output(fresh("out"))))));
    }

    private OutputEventSpec output(String id) {
        EventType type = eventType(Direction.OUTPUT);
        Map<String, FieldSource> fields = new HashMap<>();
        Map<String, String> writes = new HashMap<>();
        for (FieldType field : type.fields()) {
            switch (random.nextInt(4)) {
                case 0 -> fields.put(field.name(), new FieldSource.FromVariable(variable()));
                case 1 -> fields.put(field.name(), new FieldSource.Asked(Optional.empty(), true));
                case 2 -> writes.put(field.name(), variable());
                default -> {
                    if (field.type() == ValueType.Simple.TEXT) {
                        fields.put(field.name(), new FieldSource.Fixed(new TextValue(fresh("text"))));
                    }
                }
            }
        }
        return new OutputEventSpec(id, type.name(), fields, writes, List.of());
    }

    private InputEventSpec input(String id) {
        EventType type = eventType(Direction.INPUT);
        Map<String, String> writes = new HashMap<>();
        type.fields().stream().filter(f -> random.nextBoolean()).forEach(f -> writes.put(f.name(), variable()));
        return new InputEventSpec(id, type.name(), Map.of(), writes, List.of());
    }

    private EventType eventType(Direction side) {
        return of(vocabulary.events().values().stream()
                .filter(e -> e.direction() == side)
                .toList());
    }

    private void addNameEdits(List<Supplier<Edit>> kinds) {
        kinds.add(() -> new RenameElement(plan.id(), element(), fresh("renamed")));
        kinds.add(() -> new RenameElement(plan.id(), element(), element()));
        kinds.add(() -> new RenameVariable(owner(), variable(), "@" + fresh("v")));
        kinds.add(() -> new RenameVariable(owner(), variable(), variable()));
        kinds.add(() -> new RenameInterrupt(interrupt(), fresh("Interrupt ")));
        kinds.add(() -> new VariableEdit.AddVariable(owner(), spec("@" + fresh("v"))));
        kinds.add(() -> new VariableEdit.AddVariable(owner(), spec(variable())));
        kinds.add(() -> new VariableEdit.ChangeVariable(owner(), spec(variable())));
        kinds.add(() -> new VariableEdit.RemoveVariable(owner(), variable()));
        kinds.add(() -> new SetReads(plan.id(), random.nextBoolean() ? List.of() : List.of(variable())));
        kinds.add(() -> new TaskEdit.AddTask(plan.id(), task(fresh("task"))));
        kinds.add(() -> new TaskEdit.RemoveTask(plan.id(), taskName()));
        kinds.add(() -> new TaskEdit.RenameTask(plan.id(), taskName(), fresh("task")));
        kinds.add(() -> new TaskEdit.ChangeTask(plan.id(), task(taskName())));
    }

    private void addProjectEdits(List<Supplier<Edit>> kinds) {
        kinds.add(() -> new ProjectEdit.AddPlan(
                new NetBuilder(fresh("plan")).start("start").end("end").build()));
        kinds.add(() -> random.nextInt(3) == 0 && project.plans().size() > 2
                ? new ProjectEdit.RemovePlan(plan.id())
                : new ProjectEdit.RenamePlan(plan.id(), fresh("plan")));
        kinds.add(() -> project.plans().size() < 8
                ? new ProjectEdit.ClonePlan(plan.id(), fresh("plan"), "A clone")
                : new ProjectEdit.RemovePlan(plan.id()));
        kinds.add(() -> new ProjectEdit.MovePlan(plan.id(), random.nextInt(4)));
        kinds.add(() -> new ProjectEdit.DescribePlan(plan.id(), fresh("Plan "), "", List.of(Note.of("A note"))));
        kinds.add(() -> new NoteEdit.AddNote(plan.id(), new Note(fresh("Note "), Optional.of(point()))));
        kinds.add(() -> new NoteEdit.SetNoteText(plan.id(), random.nextInt(3), fresh("Note ")));
        kinds.add(() -> new NoteEdit.MoveNotes(plan.id(), Map.of(random.nextInt(3), point())));
        kinds.add(() -> new NoteEdit.RemoveNotes(plan.id(), Set.of(random.nextInt(3))));
        kinds.add(() -> new ExtractSubMission(plan.id(), some(), fresh("extracted"), "Extracted"));
        kinds.add(() -> new ProjectEdit.NameProject(fresh("Project ")));
        kinds.add(() -> new ProjectEdit.SetMissionTree(List.of(
                new MissionTreeNode("Folder", Optional.empty(), List.of()),
                new MissionTreeNode("", Optional.of(plan.id()), List.of()))));
        kinds.add(() -> new ProjectEdit.MoveTreeNode(
                List.of(random.nextInt(2)), random.nextBoolean() ? List.of() : List.of(random.nextInt(2)), 0));
        kinds.add(() -> new ProjectEdit.SetTestCase(
                plan.id(), of(plan.testCases().stream().map(t -> t.name()).toList(), "none"), Optional.empty()));
        kinds.add(() -> new ProjectEdit.SetQuery(plan.id(), "asked", query()));
    }

    private Optional<PlanQuery> query() {
        String place = of(plan.places().stream().map(Place::id).toList(), "nowhere");
        return random.nextInt(3) == 0
                ? Optional.empty()
                : Optional.of(new PlanQuery("asked", "reachable m(\"" + place + "\") >= 1", PlanQuery.Expected.YES));
    }

    private String fresh(String stem) {
        return stem + ++names;
    }

    private NetFrame frame() {
        return new NetFrame(
                fresh("Frame "),
                of(List.of(FrameColor.values())),
                point(),
                1 + random.nextInt(300),
                1 + random.nextInt(300));
    }

    private LayoutPoint point() {
        return new LayoutPoint(random.nextInt(1000), random.nextInt(1000));
    }

    private Mode mode() {
        return of(List.of(Mode.values()));
    }

    private String place() {
        return of(plan.places().stream().map(Place::id).toList(), "nowhere");
    }

    private String transition() {
        return of(plan.transitions().stream().map(Transition::id).toList(), "nowhere");
    }

    private String vertex() {
        return random.nextBoolean() ? place() : transition();
    }

    private String outputId() {
        return of(
                plan.places().stream()
                        .flatMap(p -> p.outputs().stream())
                        .map(OutputEventSpec::id)
                        .toList(),
                "nothing");
    }

    /** An id of a vertex, edge, event or sub-mission. */
    private String element() {
        List<String> ids = new ArrayList<>(List.of(vertex(), outputId()));
        plan.inEdges().forEach(e -> ids.add(e.id()));
        plan.outEdges().forEach(e -> ids.add(e.id()));
        plan.transitions().forEach(t -> t.inputs().forEach(i -> ids.add(i.id())));
        plan.places().forEach(p -> p.subMissions().forEach(s -> ids.add(s.id())));
        return of(ids);
    }

    private Optional<String> owner() {
        return random.nextInt(3) == 0 ? Optional.empty() : Optional.of(plan.id());
    }

    private String variable() {
        List<String> known = new ArrayList<>(List.of("@some", "@other"));
        plan.variables().forEach(v -> known.add(v.name()));
        project.globals().forEach(v -> known.add(v.name()));
        return of(known);
    }

    private VariableSpec spec(String name) {
        return new VariableSpec(name, TYPES[random.nextInt(TYPES.length)], Optional.empty());
    }

    private String taskName() {
        return of(plan.tasks().stream().map(TaskSpec::name).toList(), "none");
    }

    private TaskSpec task(String name) {
        return new TaskSpec(name, of(List.copyOf(vocabulary.taskClasses().keySet()), "None"), Map.of());
    }

    private String interrupt() {
        Predicate<String> known = field -> field.equals(Reserved.INTERRUPT_NAME);
        return of(
                plan.transitions().stream()
                        .flatMap(t -> t.inputs().stream())
                        .flatMap(i -> i.fields().entrySet().stream())
                        .filter(e -> known.test(e.getKey()) && e.getValue() instanceof TextValue)
                        .map(e -> ((TextValue) e.getValue()).value())
                        .toList(),
                "none");
    }

    private <T> T of(List<T> list, T otherwise) {
        return list.isEmpty() ? otherwise : of(list);
    }

    private <T> T of(List<T> list) {
        return list.get(random.nextInt(list.size()));
    }
}
