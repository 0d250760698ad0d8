package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Note;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Vocabulary;

/** Writes one plan, in the order in which {@link PlanReader} reads it. */
final class PlanWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Vocabulary vocabulary;
    private final EventSpecWriter events;
    private final Project project;

    PlanWriter(Vocabulary vocabulary, Project project) {
        this.vocabulary = vocabulary;
        this.events = new EventSpecWriter(vocabulary);
        this.project = project;
    }

    ObjectNode write(Plan plan) {
        ObjectNode node = NODES.objectNode().put("id", plan.id());
        putText(node, "name", plan.name());
        putText(node, "description", plan.description());
        if (!plan.variables().isEmpty()) {
            node.set("variables", ProjectWriter.variables(plan.variables(), vocabulary));
        }
        putTexts(node, "reads", plan.reads());
        put(node, "tasks", plan.tasks(), this::task);
        put(node, "places", plan.places(), this::place);
        put(node, "transitions", plan.transitions(), this::transition);
        put(node, "inEdges", plan.inEdges(), PlanWriter::inEdge);
        put(node, "outEdges", plan.outEdges(), PlanWriter::outEdge);
        if (!plan.layout().isEmpty()) {
            ObjectNode layout = node.putObject("layout");
            plan.layout()
                    .forEach((id, p) ->
                            layout.putArray(id).add(ValueWriter.number(p.x())).add(ValueWriter.number(p.y())));
        }
        if (!plan.notes().isEmpty()) {
            ArrayNode notes = node.putArray("notes");
            plan.notes().forEach(note -> note(notes, note));
        }
        put(node, "frames", plan.frames(), PlanWriter::frame);
        TestCaseWriter cases = new TestCaseWriter(vocabulary, plan, project);
        put(node, "testCases", plan.testCases(), cases::write);
        return node;
    }

    /** One that lies nowhere is its text alone, as before there was anything else to say of a note. */
    private static void note(ArrayNode notes, Note note) {
        if (note.at().isEmpty()) {
            notes.add(note.text());
        } else {
            LayoutPoint at = note.at().get();
            notes.addObject()
                    .put("text", note.text())
                    .putArray("at")
                    .add(ValueWriter.number(at.x()))
                    .add(ValueWriter.number(at.y()));
        }
    }

    private static ObjectNode frame(NetFrame frame) {
        ObjectNode node = NODES.objectNode();
        putText(node, "title", frame.title());
        if (frame.color() != FrameColor.BLUE) {
            node.put("color", Words.of(frame.color()));
        }
        node.putArray("at")
                .add(ValueWriter.number(frame.at().x()))
                .add(ValueWriter.number(frame.at().y()));
        node.putArray("size").add(ValueWriter.number(frame.width())).add(ValueWriter.number(frame.height()));
        return node;
    }

    private ObjectNode task(TaskSpec task) {
        ObjectNode node = NODES.objectNode().put("name", task.name()).put("class", task.taskClass());
        if (!task.fields().isEmpty()) {
            node.set("fields", events.taskFields(task));
        }
        return node;
    }

    private ObjectNode place(Place place) {
        ObjectNode node = NODES.objectNode().put("id", place.id());
        putText(node, "name", place.name());
        putFlag(node, "start", place.start());
        putFlag(node, "end", place.end());
        putFlag(node, "endsSharedInstance", place.endsSharedInstance());
        putMode(node, place.mode());
        put(node, "outputs", place.outputs(), events::output);
        put(node, "subMissions", place.subMissions(), PlanWriter::subMission);
        putTexts(node, "transitionOrder", place.transitionOrder());
        putFlag(node, "disabled", place.disabled());
        return node;
    }

    private ObjectNode transition(Transition transition) {
        ObjectNode node = NODES.objectNode().put("id", transition.id());
        putText(node, "name", transition.name());
        putMode(node, transition.mode());
        if (transition.waitFor() != WaitFor.EACH) {
            node.put("waitFor", Words.of(transition.waitFor()));
        }
        put(node, "inputs", transition.inputs(), events::input);
        putFlag(node, "disabled", transition.disabled());
        return node;
    }

    private static ObjectNode subMission(SubMissionSpec s) {
        ObjectNode node = NODES.objectNode().put("id", s.id()).put("plan", s.plan());
        putFlag(node, "shared", s.shared());
        putTextMap(node, "tasks", s.tasks());
        putTextMap(node, "variables", s.variables());
        return node;
    }

    private static ObjectNode inEdge(InEdge edge) {
        ObjectNode node = NODES.objectNode()
                .put("id", edge.id())
                .put("place", edge.place())
                .put("transition", edge.transition());
        putMode(node, edge.mode());
        put(node, "requirements", edge.requirements(), PlanWriter::inRequirement);
        putFlag(node, "locked", edge.locked());
        return node;
    }

    private static ObjectNode outEdge(OutEdge edge) {
        ObjectNode node = NODES.objectNode()
                .put("id", edge.id())
                .put("transition", edge.transition())
                .put("place", edge.place());
        putMode(node, edge.mode());
        put(node, "requirements", edge.requirements(), PlanWriter::outRequirement);
        putFlag(node, "locked", edge.locked());
        return node;
    }

    private static ObjectNode inRequirement(InRequirement r) {
        ObjectNode node = NODES.objectNode();
        if (r.kind() == TokenKind.UNCONDITIONAL) {
            return node.put("kind", Words.of(r.kind()));
        }
        node.put("match", Words.of(r.match()));
        if (r.match() != Match.ZERO && r.match() != Match.ALL) {
            node.put("n", r.n());
        }
        node.put("kind", Words.of(r.kind()));
        putText(node, "task", r.task());
        return node;
    }

    private static ObjectNode outRequirement(OutRequirement r) {
        ObjectNode node = NODES.objectNode();
        if (r.kind() == TokenKind.UNCONDITIONAL) {
            return node.put("kind", Words.of(r.kind()));
        }
        node.put("action", Words.of(r.action()));
        if (r.takesAll()) {
            node.put("n", "all");
        } else {
            node.put("n", r.n());
        }
        node.put("kind", Words.of(r.kind()));
        putText(node, "task", r.task());
        return node;
    }

    static void putText(ObjectNode node, String member, String text) {
        if (!text.isEmpty()) {
            node.put(member, text);
        }
    }

    private static void putFlag(ObjectNode node, String member, boolean flag) {
        if (flag) {
            node.put(member, true);
        }
    }

    private static void putMode(ObjectNode node, Mode mode) {
        if (mode != Mode.NOMINAL) {
            node.put("mode", Words.of(mode));
        }
    }

    static void putTexts(ObjectNode node, String member, List<String> texts) {
        if (!texts.isEmpty()) {
            ArrayNode array = node.putArray(member);
            texts.forEach(array::add);
        }
    }

    static void putTextMap(ObjectNode node, String member, Map<String, String> texts) {
        if (!texts.isEmpty()) {
            ObjectNode map = node.putObject(member);
            texts.forEach(map::put);
        }
    }

    static <T> void put(ObjectNode node, String member, List<T> items, Function<T, ObjectNode> writer) {
        if (!items.isEmpty()) {
            ArrayNode array = node.putArray(member);
            items.forEach(item -> array.add(writer.apply(item)));
        }
    }
}
