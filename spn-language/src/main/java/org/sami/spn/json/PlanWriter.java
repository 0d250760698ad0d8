package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
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
import org.sami.spn.model.PlanQuery;
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
        OptionalMembers.putText(node, "name", plan.name());
        OptionalMembers.putText(node, "description", plan.description());
        if (!plan.variables().isEmpty()) {
            node.set("variables", VariableWriter.write(plan.variables(), vocabulary));
        }
        OptionalMembers.putTexts(node, "reads", plan.reads());
        OptionalMembers.put(node, "tasks", plan.tasks(), this::task);
        OptionalMembers.put(node, "places", plan.places(), this::place);
        OptionalMembers.put(node, "transitions", plan.transitions(), this::transition);
        OptionalMembers.put(node, "inEdges", plan.inEdges(), PlanWriter::inEdge);
        OptionalMembers.put(node, "outEdges", plan.outEdges(), PlanWriter::outEdge);
        if (!plan.layout().isEmpty()) {
            ObjectNode layout = node.putObject("layout");
            plan.layout()
                    .forEach((id, p) -> layout.putArray(id)
                            .add(SimpleValueWriter.number(p.x()))
                            .add(SimpleValueWriter.number(p.y())));
        }
        if (!plan.notes().isEmpty()) {
            ArrayNode notes = node.putArray("notes");
            plan.notes().forEach(note -> note(notes, note));
        }
        OptionalMembers.put(node, "frames", plan.frames(), PlanWriter::frame);
        TestCaseWriter cases = new TestCaseWriter(vocabulary, plan, project);
        OptionalMembers.put(node, "testCases", plan.testCases(), cases::write);
        OptionalMembers.put(node, "queries", plan.queries(), PlanWriter::query);
        return node;
    }

    private static ObjectNode query(PlanQuery query) {
        ObjectNode node = NODES.objectNode().put("name", query.name()).put("text", query.text());
        if (query.expected() != PlanQuery.Expected.YES) {
            node.put("expect", Words.of(query.expected()));
        }
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
                    .add(SimpleValueWriter.number(at.x()))
                    .add(SimpleValueWriter.number(at.y()));
        }
    }

    private static ObjectNode frame(NetFrame frame) {
        ObjectNode node = NODES.objectNode();
        OptionalMembers.putText(node, "title", frame.title());
        if (frame.color() != FrameColor.BLUE) {
            node.put("color", Words.of(frame.color()));
        }
        node.putArray("at")
                .add(SimpleValueWriter.number(frame.at().x()))
                .add(SimpleValueWriter.number(frame.at().y()));
        node.putArray("size")
                .add(SimpleValueWriter.number(frame.width()))
                .add(SimpleValueWriter.number(frame.height()));
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
        OptionalMembers.putText(node, "name", place.name());
        OptionalMembers.putFlag(node, "start", place.start());
        OptionalMembers.putFlag(node, "end", place.end());
        OptionalMembers.putFlag(node, "endsSharedInstance", place.endsSharedInstance());
        putMode(node, place.mode());
        OptionalMembers.put(node, "outputs", place.outputs(), events::output);
        OptionalMembers.put(node, "subMissions", place.subMissions(), PlanWriter::subMission);
        OptionalMembers.putTexts(node, "transitionOrder", place.transitionOrder());
        OptionalMembers.putFlag(node, "disabled", place.disabled());
        return node;
    }

    private ObjectNode transition(Transition transition) {
        ObjectNode node = NODES.objectNode().put("id", transition.id());
        OptionalMembers.putText(node, "name", transition.name());
        putMode(node, transition.mode());
        if (transition.waitFor() != WaitFor.EACH) {
            node.put("waitFor", Words.of(transition.waitFor()));
        }
        OptionalMembers.put(node, "inputs", transition.inputs(), events::input);
        OptionalMembers.putFlag(node, "disabled", transition.disabled());
        return node;
    }

    private static ObjectNode subMission(SubMissionSpec s) {
        ObjectNode node = NODES.objectNode().put("id", s.id()).put("plan", s.plan());
        OptionalMembers.putFlag(node, "shared", s.shared());
        OptionalMembers.putTextMap(node, "tasks", s.tasks());
        OptionalMembers.putTextMap(node, "variables", s.variables());
        return node;
    }

    private static ObjectNode inEdge(InEdge edge) {
        ObjectNode node = NODES.objectNode()
                .put("id", edge.id())
                .put("place", edge.place())
                .put("transition", edge.transition());
        putMode(node, edge.mode());
        OptionalMembers.put(node, "requirements", edge.requirements(), PlanWriter::inRequirement);
        OptionalMembers.putFlag(node, "locked", edge.locked());
        return node;
    }

    private static ObjectNode outEdge(OutEdge edge) {
        ObjectNode node = NODES.objectNode()
                .put("id", edge.id())
                .put("transition", edge.transition())
                .put("place", edge.place());
        putMode(node, edge.mode());
        OptionalMembers.put(node, "requirements", edge.requirements(), PlanWriter::outRequirement);
        OptionalMembers.putFlag(node, "locked", edge.locked());
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
        OptionalMembers.putText(node, "task", r.task());
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
        OptionalMembers.putText(node, "task", r.task());
        return node;
    }

    private static void putMode(ObjectNode node, Mode mode) {
        if (mode != Mode.NOMINAL) {
            node.put("mode", Words.of(mode));
        }
    }
}
